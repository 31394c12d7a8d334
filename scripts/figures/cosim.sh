#!/usr/bin/env bash
# The Verilog of the whole accelerator against the C simulation: sequences, pictures, faults and soak (minutes, so recorded), then
# cycles. Usage: cosim.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
source scripts/records.sh

rtl=(hls rtl tb/cosim tb/csim host)
# The wide core is compiled when it is needed.
recorded cosim "${rtl[@]}" "${compiler_sources[@]}" apps/drive.cpp scenes/demo.yaml scripts/cosim_record.sh -- ./scripts/cosim_record.sh "$1"
recorded mutants "${rtl[@]}" scripts/mutate.py scripts/mutants.sh -- ./scripts/mutants.sh "$1"
# scripts/gate_level.sh is not measured: Yosys does not end in half an hour (docs/cosimulation.md).
printf 'cosim.gate_level_differences.%s\tnone\t<= 0\tshort\n' xc6v ecp5
"$1/bin/cosim_record" cycles
