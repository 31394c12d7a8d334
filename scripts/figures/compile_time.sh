#!/usr/bin/env bash
# How long the HLS compiler takes, in seconds of processor time: the whole accelerator, and one of its largest kernels alone.
# Usage: compile_time.sh BUILD_DIR
set -euo pipefail
hlsc=$1/bin/floorline-hlsc
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# compile_seconds NAME BOUND SOURCE TOP
compile_seconds() {
    local TIMEFORMAT='%U %S' used
    used=$({ time "$hlsc" compile "$3" --top "$4" -I hls -o "$work/$1" --target xc6v --clock 6.5 >"$work/$1.log" 2>&1; } 2>&1) ||
        { cat "$work/$1.log" >&2; exit 1; }
    awk -v name="$1" -v bound="$2" '{ s = $1 + $2; printf "hlsc.compile_seconds.%s\t%.1f\t<= %s\t%s\n", name, s, bound, s <= bound ? "ok" : "short" }' <<<"$used"
}

cat >"$work/kernel.cpp" <<'EOF'
#include "accelerator.h"
void kernel(hls::stream<floorline::Pixel>& in, hls::stream<floorline::Pixel>& out, hls::stream<floorline::Pixel>& thresholds,
            floorline::Size width, floorline::Size height) {
  floorline::otsu<640, 480>(in, out, thresholds, width, height);
}
EOF
compile_seconds top 20 hls/accelerator.cpp floorline_accelerator
compile_seconds kernel 3 "$work/kernel.cpp" kernel
