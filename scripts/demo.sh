#!/usr/bin/env bash
# The main job in one command: set up, build, render a sequence with exact ground truth, run the golden model and
# the fixed-point kernels side by side, score, and write a report. Ends with the report's path.
source "$(dirname "$0")/common.sh"

./scripts/setup.sh
say "building the floorline command"
build release floorline
floorline=build/release/bin/floorline
out=out/demo
mkdir -p out
settings=(--baseline 4)

say "rendering scenes/demo.yaml"
"$floorline" render scenes/demo.yaml --output "$out/sequence" --force
say "golden model and HLS kernels, stage by stage"
"$floorline" check "$out/sequence" "${settings[@]}" --json "$out/check.json" || [ $? = 1 ]
say "scoring against the ground truth"
# Exit code 1 means that a figure is below its bound: the report shows which, so the demo goes on.
"$floorline" score "$out/sequence" "${settings[@]}" --json "$out/score.json" || [ $? = 1 ]
say "writing the report"
"$floorline" report "$out/sequence" "${settings[@]}" --output "$out/report.html"
printf 'report: %s\n' "$root/$out/report.html"
