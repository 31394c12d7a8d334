#!/usr/bin/env bash
# Frames a second of the golden model, the C simulation and the Verilator model on the demo's frames, each on one core, and how much
# longer a frame takes from one to the next. Usage: speed.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1/bin/floorline" render scenes/demo.yaml --output "$work/demo" >/dev/null
taskset -c 0 "$1/bin/frame_benchmark" "$work/demo" --benchmark_out="$work/times.json" >/dev/null 2>"$work/log" ||
    { cat "$work/log" >&2; fail "the benchmark failed; its message is above."; }
# value NAME COUNTER
value() { python3 -c 'import json, sys; print(*[format(b[sys.argv[3]], ".4g") for b in json.load(open(sys.argv[1]))["benchmarks"] if b["name"] == sys.argv[2]])' "$work/times.json" "$1" "$2"; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'; }
golden=$(value golden frames_per_second)
csim=$(value csim frames_per_second)
cosim=$(value cosim frames_per_second)
figure golden.frames_per_second "$golden" '>=' 30
figure csim.frames_per_second "$csim" '>=' 10
printf 'cosim.frames_per_second\t%s\t\tok\n' "$cosim"
printf 'csim.frame_time_over_golden\t%s\t\tok\n' "$(ratio "$golden" "$csim")"
printf 'cosim.frame_time_over_csim\t%s\t\tok\n' "$(ratio "$csim" "$cosim")"
figure cosim.cycles_per_second "$(value cosim cycles_per_second)" '>=' 1500000
