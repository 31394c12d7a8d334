#!/usr/bin/env bash
# The same source gives the same bytes, wherever things lie in memory: compiles every case of the corpus and the accelerator
# twice, the second time with another heap layout and with fresh and freed memory filled.
#   deterministic.sh COMPILER REPOSITORY
set -euo pipefail
compiler=$1
repository=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# both SOURCE TOP OPTIONS...: compiles twice and compares.
both() {
    local source=$1 top=$2
    shift 2
    rm -rf "$work/plain" "$work/moved"
    "$compiler" compile "$source" --top "$top" "$@" -o "$work/plain" >"$work/plain.log" 2>&1 || true
    MALLOC_PERTURB_=165 MALLOC_TOP_PAD_=1234567 MALLOC_MMAP_THRESHOLD_=4096 MALLOC_ARENA_MAX=1 \
        "$compiler" compile "$source" --top "$top" "$@" -o "$work/moved" >"$work/moved.log" 2>&1 || true
    if [ ! -d "$work/plain" ] || ! diff -r "$work/plain" "$work/moved" >"$work/diff"; then
        echo "$source: two compilations differ: $(head -c 300 "$work/diff" "$work/plain.log")"
        failures=$((failures + 1))
    fi
}

for source in "$repository"/compiler/test/corpus/*.cpp; do
    top=$(sed -n 's|^// top: *\([a-zA-Z0-9_]*\).*|\1|p' "$source")
    [ -z "$top" ] || grep -q '^// file:' "$source" || both "$source" "$top"
done
both "$repository/hls/accelerator.cpp" floorline_accelerator -I "$repository/hls" --std c++11 --target xc6v
[ "$failures" -eq 0 ]
