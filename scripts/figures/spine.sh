#!/usr/bin/env bash
# Golden model against C simulation, stage by stage and as whole pipelines, on the rendered default sequence and on the KITTI folders
# of ../shared/data, where they are. Usage: spine.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
floorline=$1/bin/floorline
data=../shared/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# check NAME OPTION...: checks the sequence $work/NAME. Exit code 1 only says that a bound is missed, which the figures tell too.
check() {
    local name=$1
    shift
    "$floorline" check "$work/$name" "$@" --json "$work/$name.json" >/dev/null || [ $? = 1 ]
    ./scripts/json_figures.py "$work/$name.json" spine "$name"
}

"$floorline" render scenes/demo.yaml --output "$work/demo" >/dev/null
check demo
for folder in kitti_odo06 kitti_trk0003a; do
    [ -d "$data/$folder" ] || continue
    "$floorline" import kitti "$data/$folder" --output "$work/$folder" >/dev/null
    check "$folder" --poses exact
done
