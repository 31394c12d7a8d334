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

# score AREA CASE OPTION...: the figures of `floorline score OPTION...` as lines.
score() {
    local area=$1 case=$2
    shift 2
    # Exit code 1 only says that a bound is missed, which the figures tell too.
    "$floorline" score "$@" --model golden --json "$work/$area.$case.json" >/dev/null || [ $? = 1 ]
    ./scripts/json_figures.py "$work/$area.$case.json" "$area" "$case"
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
    local baseline pid pids=()
    for baseline in 1 2 4 8; do
        score detection "b$baseline" "$folder"/* --baseline "$baseline" >"$work/b$baseline" &
        pids+=($!)
    done
    score detection.paper b1 "$folder"/* --rule paper --baseline 1 >"$work/paper" &
    pids+=($!)
    for pid in "${pids[@]}"; do wait "$pid"; done
    cat "$work"/b[1248]
    without_bounds <"$work/paper"
}

kitti() {
    for name in kitti_odo06 kitti_trk0003a; do
        [ -d "$data/$name" ] || continue
        "$floorline" import kitti "$data/$name" --output "$work/$name" >/dev/null
        score detection "$name" "$work/$name" --poses exact
        score detection.paper "$name" "$work/$name" --poses exact --rule paper | without_bounds
    done
}

# The driver of the hardware has no part in it.
sources=(golden host ':!host/driver.*' render apps/score.cpp apps/score_command.cpp apps/drive.cpp apps/model.cpp scripts/figures/detection.sh)
recorded detection "${sources[@]}" -- rooms
kitti
