#!/usr/bin/env bash
# How long the HLS compiler takes, in seconds of processor time: the whole accelerator, and one of its largest kernels alone.
# Usage: compile_time.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"

hlsc=$1/bin/floorline-hlsc
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# compile_seconds NAME BOUND SOURCE TOP
compile_seconds() {
    local TIMEFORMAT='%U %S' used
    used=$({ time "$hlsc" compile "$3" --top "$4" -I hls -o "$work/$1" --target xc6v --clock 6.5 >"$work/$1.log" 2>&1; } 2>&1) ||
        { cat "$work/$1.log" >&2; exit 1; }
    figure "hlsc.compile_seconds.$1" "$(awk '{ printf "%.1f", $1 + $2 }' <<<"$used")" '<=' "$2"
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
