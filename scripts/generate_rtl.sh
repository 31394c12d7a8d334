#!/usr/bin/env bash
# Compiles hls/accelerator.cpp to rtl/generated with the project's own compiler.
#   ./scripts/generate_rtl.sh                     build the compiler and write rtl/generated
#   ./scripts/generate_rtl.sh --check COMPILER    compare bytes with what is committed (the test rtl.generated)
source "$(dirname "$0")/common.sh"

compiler=build/release/bin/floorline-hlsc
[ "${1:-}" = --check ] && compiler=$2 || build release floorline-hlsc
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
"$compiler" compile hls/accelerator.cpp --top floorline_accelerator --tap $(cat hls/taps.txt) -I hls --std c++11 --target xc6v -o "$fresh/rtl" --report "$fresh/report"

if [ "${1:-}" = --check ]; then
    diff -rq "$fresh/rtl" rtl/generated || fail "rtl/generated is not what the compiler makes; run ./scripts/generate_rtl.sh and commit the result."
else
    rm -rf rtl/generated
    cp -r "$fresh/rtl" rtl/generated
    chmod 755 rtl/generated
    say "rtl/generated is written"
fi
