#!/usr/bin/env bash
# Golden model against C simulation, stage by stage and as whole pipelines, on the rendered default sequence and on the KITTI folders
# of ../shared/data, where they are. Usage: spine.sh BUILD_DIR
set -euo pipefail
floorline=$1/bin/floorline
data=$(dirname "$0")/../../../shared/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# figures SEQUENCE JSON: a line for each figure of a check.
figures() {
    python3 - "$1" "$2" <<'PYTHON'
import json, sys
sequence, path = sys.argv[1:]
for figure in json.load(open(path))["figures"]:
    value = "none" if figure["value"] is None else format(figure["value"], ".4g")
    print(f"spine.{figure['name']}.{sequence}\t{value}\t{figure['bound']}\t{figure['verdict']}")
PYTHON
}

# run_check NAME OPTION...: checks the sequence $work/NAME. Exit code 1 only says that a bound is missed, which the figures tell too.
run_check() {
    local name=$1
    shift
    "$floorline" check "$work/$name" "$@" --json "$work/$name.json" >/dev/null || [ $? = 1 ]
    figures "$name" "$work/$name.json"
}

"$floorline" render scenes/demo.yaml --output "$work/demo" >/dev/null
run_check demo
for folder in kitti_odo06 kitti_trk0003a; do
    [ -d "$data/$folder" ] || continue
    "$floorline" import kitti "$data/$folder" --output "$work/$folder" >/dev/null
    run_check "$folder" --poses exact
done
