#!/usr/bin/env bash
# Gates after Yosys, for xc6v and ecp5, against the C simulation, as figures. Usage: gate_level.sh BUILD_DIR
source "$(dirname "$0")/common.sh"

ninja -C "$1" cosim_gates_xc6v cosim_gates_ecp5 >&2
for target in xc6v ecp5; do "$1/bin/cosim_gates_$target"; done
