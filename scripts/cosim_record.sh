#!/usr/bin/env bash
# The long co-simulations as figures: the rendered default sequence, the KITTI folders and the unit pictures of ../shared/data, where they
# are, under every kind of stalls; faults; soak. Usage: cosim_record.sh BUILD_DIR
source "$(dirname "$0")/common.sh"

floorline=$1/bin/floorline
data=../shared/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run SEQUENCE OPTION...: $work/SEQUENCE. Exit code 1 only says that a bit differs, which the figure tells too.
run() {
    local sequence=$1
    shift
    for stalls in none light heavy; do
        "$floorline" cosim "$work/$sequence" "$@" --stalls "$stalls" --waves "$work/cosim.fst" --json "$work/$stalls.json" >/dev/null || [ $? = 1 ]
        python3 - "$sequence" "$work/$stalls.json" <<'PYTHON'
import json, sys
sequence, path = sys.argv[1:]
run = json.load(open(path))

def figure(name, value, relation, bound):
    ok = value <= bound if relation == "<=" else value >= bound
    print(f"cosim.{name}\t{value}\t{relation} {bound}\t{'ok' if ok else 'short'}", flush=True)

figure(f"bit_differences.{sequence}_{run['stalls']}", sum(run["differing_bits"].values()), "<=", 0)
if run["stalls"] == "none":
    figure(f"frames.{sequence}", run["frames"], ">=", 30 if sequence == "demo" else 16)
    figure(f"latency_cycles.{sequence}", run["most_decision_latency"], "<=", 2200)
PYTHON
    done
}

"$floorline" render scenes/demo.yaml --output "$work/demo" >/dev/null
run demo
for folder in kitti_odo06 kitti_trk0003a; do
    [ -d "$data/$folder" ] || continue
    "$floorline" import kitti "$data/$folder" --output "$work/$folder" >/dev/null
    run "$folder" --poses exact
done
[ ! -d "$data/unit_opencv" ] || "$1/bin/cosim_record" pictures "$data/unit_opencv" "$data/unit_skimage"
"$1/bin/cosim_record" faults
"$1/bin/cosim_record" soak
