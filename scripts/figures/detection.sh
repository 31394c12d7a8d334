#!/usr/bin/env bash
# Detection on the 200 seeded rooms (docs/rendered_set.md), each frame and after confirmation in the grid, at baselines of 1, 2, 4 and 8
# frames. Rooms are rendered once for each version of the renderer and kept in BUILD_DIR/rooms. Usage: detection.sh BUILD_DIR
set -euo pipefail
floorline=$1/bin/floorline
version=$(cat render/*.h render/*.cpp | sha256sum | cut -c1-16)
rooms=$1/rooms/$version
[ -d "$rooms" ] || {
    rm -rf "$rooms.unfinished"
    "$floorline" render --seeds 1..200 --output "$rooms.unfinished" >/dev/null
    mv "$rooms.unfinished" "$rooms"
}
result=$(mktemp)
trap 'rm -f "$result"' EXIT

for baseline in 1 2 4 8; do
    # Exit code 1 only says that a bound is missed, which the figures tell too.
    "$floorline" score "$rooms"/* --model golden --baseline "$baseline" --json "$result" >/dev/null || [ $? = 1 ]
    python3 - "$baseline" "$result" <<'PYTHON'
import json, sys
baseline, path = sys.argv[1:]
for figure in json.load(open(path))["figures"]:
    value = "none" if figure["value"] is None else format(figure["value"], ".3f")
    print(f"detection.{figure['name']}.b{baseline}\t{value}\t{figure['bound']}\t{figure['verdict']}")
PYTHON
done
