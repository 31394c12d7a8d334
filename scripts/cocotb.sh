#!/usr/bin/env bash
# The accelerator's top in Icarus Verilog with the AXI agents of cocotbext-axi (tb/cocotb). Usage: cocotb.sh COSIM_VECTORS
source "$(dirname "$0")/common.sh"

[ -x .venv/bin/python ] || fail "the project's Python packages are missing; run ./scripts/setup.sh."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" 3 1 >"$work/vectors.json"
.venv/bin/python tb/cocotb/run.py "$work/icarus" "$work/vectors.json"
