#!/usr/bin/env bash
# The Verilog of the whole accelerator against the C simulation: the rendered default sequence under every kind of stalls, then the record run
# (faults, soak, cycles, speed on one core). Usage: cosim.sh BUILD_DIR
set -euo pipefail
floorline=$1/bin/floorline
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$floorline" render scenes/demo.yaml --output "$work/demo" >/dev/null
for stalls in none light heavy; do
    # Exit code 1 only says that a bit differs, which the figure tells too.
    "$floorline" cosim "$work/demo" --stalls "$stalls" --waves "$work/cosim.fst" --json "$work/$stalls.json" >/dev/null || [ $? = 1 ]
    python3 - "$work/$stalls.json" <<'PYTHON'
import json, sys
run = json.load(open(sys.argv[1]))
bits = sum(run["differing_bits"].values())
print(f"cosim.bit_differences.demo_{run['stalls']}\t{bits}\t<= 0\t{'ok' if bits == 0 else 'short'}")
if run["stalls"] == "none":
    print(f"cosim.frames.demo\t{run['frames']}\t>= 30\t{'ok' if run['frames'] >= 30 else 'short'}")
PYTHON
done
taskset -c 0 "$1/bin/cosim_record"
