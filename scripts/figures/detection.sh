#!/usr/bin/env bash
# Detection on the 200 seeded rooms (docs/rendered_set.md) at baselines of 1, 2, 4 and 8 frames, each frame and confirmed in the grid, and on
# the KITTI folders of ../shared/data against their masks, where they are; the paper's own rule beside ours. Recorded, since the rooms take
# a quarter of an hour to render and as long to score. Usage: detection.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
source scripts/records.sh
floorline=$1/bin/floorline
data=../shared/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# score NAME OPTION... : the figures of `floorline score OPTION...` as lines; NAME stands before, and its last part behind, each name.
score() {
    local name=$1
    shift
    # Exit code 1 only says that a bound is missed, which the figures tell too.
    "$floorline" score "$@" --model golden --json "$work/score.json" >/dev/null || [ $? = 1 ]
    python3 - "$name" "$work/score.json" <<'PYTHON'
import json, sys
(area, case), result = sys.argv[1].rsplit(".", 1), json.load(open(sys.argv[2]))
figures = result["figures"] or [  # masks alone have no bounds
    {"name": name, "value": result[name], "bound": "", "verdict": "ok"} for name in ("mask_precision", "pixel_precision", "pixel_recall")]
for figure in figures:
    value = "none" if figure["value"] is None else format(figure["value"], ".3f")
    print(area + "." + figure["name"] + "." + case, value, figure["bound"], figure["verdict"], sep="\t")
PYTHON
}

# The paper's rule is scored for comparison, so that none of its figures can be short.
without_bounds() { awk -F'\t' -v OFS='\t' '{ print $1, $2, "", "ok" }'; }

rooms() {
    local folder
    folder=build/rooms/$(content_hash render)
    [ -d "$folder" ] || {
        rm -rf "$folder.unfinished"
        "$floorline" render --seeds 1..200 --output "$folder.unfinished" >/dev/null
        mv "$folder.unfinished" "$folder"
    }
    for baseline in 1 2 4 8; do score "detection.b$baseline" "$folder"/* --baseline "$baseline"; done
    score detection.paper.b1 "$folder"/* --rule paper --baseline 1 | without_bounds
}

kitti() {
    for name in kitti_odo06 kitti_trk0003a; do
        [ -d "$data/$name" ] || continue
        "$floorline" import kitti "$data/$name" --output "$work/$name" >/dev/null
        score "detection.$name" "$work/$name" --poses exact
        score "detection.paper.$name" "$work/$name" --poses exact --rule paper | without_bounds
    done
}

sources=(golden host render apps/score.cpp apps/score_command.cpp apps/drive.cpp apps/model.cpp scripts/figures/detection.sh)
recorded detection "${sources[@]}" -- rooms
kitti
