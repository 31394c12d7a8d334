#!/usr/bin/env bash
# The long co-simulations as figures: the rendered default sequence, the KITTI folders and the unit pictures of ../shared/data, where they
# are, under every kind of stalls; faults; soak. Usage: cosim_record.sh BUILD_DIR
source "$(dirname "$0")/common.sh"

build=$1
floorline=$build/bin/floorline
data=../shared/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run SEQUENCE OPTION...: $work/SEQUENCE. Exit code 1 only says that a bit differs, which the figure tells too.
run() {
    local sequence=$1
    shift
    for stalls in none light heavy; do
        "$floorline" cosim "$work/$sequence" "$@" --stalls "$stalls" --waves "$work/$sequence.fst" --json "$work/$sequence.json" >/dev/null || [ $? = 1 ]
        python3 - "$sequence" "$work/$sequence.json" <<'PYTHON'
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

# Two lanes, as every run takes one core.
kitti() {
    [ -d "$data/$1" ] || return 0
    "$floorline" import kitti "$data/$1" --output "$work/$1" >/dev/null
    run "$1" --poses exact
}
# Without those with transparency, which no camera sends, and the one below 16x16.
pictures() {
    [ -d "$data/unit_opencv" ] || return 0
    mkdir "$work/pictures"
    cp "$data"/unit_*/*.png "$data"/unit_*/*.jpg "$work/pictures"
    rm "$work"/pictures/{detect_blob,gradient,horse,checker_bilevel}.png
    "$build/bin/cosim_record" pictures "$work/pictures"
}
first_lane() {
    kitti kitti_odo06
    "$build/bin/cosim_record" faults
}
second_lane() {
    "$floorline" render scenes/demo.yaml --output "$work/demo" >/dev/null
    run demo
    kitti kitti_trk0003a
    pictures
    "$build/bin/cosim_record" soak
}
first_lane >"$work/first.tsv" &
lane=$!
second_lane
wait "$lane" || fail "a co-simulation failed; its message is above."
cat "$work/first.tsv"
