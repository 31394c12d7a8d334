#!/usr/bin/env bash
# Coverage, fuzzing and sanitizers: an hour, so recorded. They need builds of their own (presets coverage and asan-ubsan).
# Usage: robust.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
source scripts/records.sh

# figure NAME VALUE RELATION BOUND
figure() { awk -v OFS='\t' -v n="$1" -v v="$2" -v r="$3" -v b="$4" 'BEGIN { good = r == ">=" ? v >= b : v <= b; print n, v, r " " b, good ? "ok" : "short" }'; }

# What the fuzz targets are compiled from (tb/fuzz/CMakeLists.txt).
readers=(apps/settings_file.cpp apps/settings_file.h host/atomic_file.cpp host/camera.cpp host/image_file.cpp host/mount.cpp host/odometry.cpp
    host/sequence.cpp host/text_file.cpp host/yaml_file.cpp render/scene.cpp render/scene.h)

recorded coverage hls golden host tb/types tb/golden tb/host tb/kernels tb/csim scripts/coverage.sh -- ./scripts/coverage.sh |
    while IFS=$'\t' read -r folder _ _ percent; do figure "robust.coverage.$folder" "$percent" '>=' 95; done
fuzzing=$(recorded fuzz "${readers[@]}" tb/fuzz scripts/fuzz.sh -- ./scripts/fuzz.sh)
figure robust.fuzz_seconds "$(cut -f2 <<<"$fuzzing" | sort -n | head -1)" '>=' 600
figure robust.fuzz_findings "$(awk '{ sum += $4 } END { print sum + 0 }' <<<"$fuzzing")" '<=' 0
sanitizers=$(recorded sanitize hls golden host render apps tb/types tb/golden tb/host tb/kernels tb/csim tb/render tb/apps scripts/sanitize.sh -- ./scripts/sanitize.sh)
figure robust.sanitizer_failed_tests "$(cut -f2 <<<"$sanitizers")" '<=' 0
figure robust.sanitizer_findings "$(cut -f3 <<<"$sanitizers")" '<=' 0
