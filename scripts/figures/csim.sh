#!/usr/bin/env bash
# Speed of the C simulation of the whole accelerator on one core, VGA colour frames.
set -euo pipefail
taskset -c 0 "$1/bin/csim_speed"
