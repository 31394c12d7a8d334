#!/usr/bin/env bash
# Speed of the golden pipeline: frames a second, VGA in colour, every stage, on one core. Usage: golden.sh BUILD_DIR
set -euo pipefail
speed=$("$1/bin/golden_speed")
verdict=$(awk -v speed="$speed" 'BEGIN { print (speed >= 30 ? "ok" : "short") }')
printf 'golden.frames_per_second\t%s\t>= 30\t%s\n' "$speed" "$verdict"
