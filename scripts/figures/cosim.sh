#!/usr/bin/env bash
# The Verilog of the whole accelerator against the C simulation: sequences, pictures, faults and soak (minutes, so recorded), then
# cycles. Usage: cosim.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
source scripts/records.sh

rtl=(hls rtl tb/cosim tb/csim host)
# The wide and the small core are compiled when they are needed.
recorded cosim "${rtl[@]}" "${compiler_sources[@]}" apps/drive.cpp scenes/demo.yaml scripts/cosim_record.sh -- ./scripts/cosim_record.sh "$1"
recorded mutants "${rtl[@]}" scripts/mutate.py scripts/mutants.sh -- ./scripts/mutants.sh "$1"
recorded gate_level hls rtl tb/gates tb/cocotb "${compiler_sources[@]}" scripts/gate_level.sh -- ./scripts/gate_level.sh "$1"
"$1/bin/cosim_record" cycles
