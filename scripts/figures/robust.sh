#!/usr/bin/env bash
# Coverage, fuzzing and sanitizers. They take an hour, so a result is kept in build/robust until a source that it depends on changes.
# They need builds of their own (presets coverage and asan-ubsan). Usage: robust.sh BUILD_DIR
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p build/robust

# cached NAME SCRIPT SOURCE...: the output of a script, run only when nothing is known for these sources.
cached() {
    local name=$1 script=$2 hash result
    shift 2
    hash=$(git ls-files -z -- "$script" cmake "$@" | xargs -0 sha256sum | sha256sum | cut -c1-16)
    result=build/robust/$name.$hash.tsv
    if [ ! -s "$result" ]; then
        # A run that fails is not kept; what it printed still becomes figures.
        if "$script" >"$result.partial"; then mv "$result.partial" "$result"; else result=$result.partial; fi
        [ -s "$result" ] || { echo "error: $script printed nothing; run it and read its message." >&2; exit 1; }
    fi
    cat "$result"
}

# figure NAME VALUE RELATION BOUND
figure() { awk -v OFS='\t' -v n="$1" -v v="$2" -v r="$3" -v b="$4" 'BEGIN { good = r == ">=" ? v >= b : v <= b; print n, v, r " " b, good ? "ok" : "short" }'; }

cached coverage ./scripts/coverage.sh hls golden host tb/types tb/golden tb/host tb/kernels tb/csim | while IFS=$'\t' read -r folder _ _ percent; do
    figure "robust.coverage.$folder" "$percent" '>=' 95
done
fuzzing=$(cached fuzz ./scripts/fuzz.sh host render/scene.cpp render/scene.h apps/settings_file.cpp apps/settings_file.h tb/fuzz)
figure robust.fuzz_seconds "$(cut -f2 <<<"$fuzzing" | sort -n | head -1)" '>=' 600
figure robust.fuzz_findings "$(awk '{ sum += $4 } END { print sum + 0 }' <<<"$fuzzing")" '<=' 0
sanitizers=$(cached sanitize ./scripts/sanitize.sh hls golden host render apps tb/types tb/golden tb/host tb/kernels tb/csim tb/render tb/apps)
figure robust.sanitizer_failed_tests "$(cut -f2 <<<"$sanitizers")" '<=' 0
figure robust.sanitizer_findings "$(cut -f3 <<<"$sanitizers")" '<=' 0
