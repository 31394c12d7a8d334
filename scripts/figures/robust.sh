#!/usr/bin/env bash
# Coverage, fuzzing and sanitizers: an hour, so recorded. They need builds of their own (presets coverage and asan-ubsan).
# Usage: robust.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
source scripts/records.sh

recorded coverage hls golden host tb/types tb/golden tb/host tb/kernels tb/csim scripts/coverage.sh -- ./scripts/coverage.sh |
    while IFS=$'\t' read -r folder _ _ percent; do figure "robust.coverage.$folder" "$percent" '>=' 95; done
# Each target with the readers that it enters (tb/fuzz/CMakeLists.txt).
declare -A readers=(
    [image]="host/image_file.cpp"
    [yaml]="apps/settings_file.cpp apps/settings_file.h host/camera.cpp host/mount.cpp host/sequence.cpp host/yaml_file.cpp"
    [table]="host/odometry.cpp host/text_file.cpp"
    [scene]="render/scene.cpp render/scene.h host/yaml_file.cpp")
fuzzing=$(for target in image yaml table scene; do
    # shellcheck disable=SC2086 # a target has several readers
    recorded "fuzz.$target" ${readers[$target]} "tb/fuzz/${target}_fuzzer.cpp" scripts/fuzz.sh -- ./scripts/fuzz.sh 600 "$target"
done)
figure robust.fuzz_seconds "$(cut -f2 <<<"$fuzzing" | sort -n | head -1)" '>=' 600
figure robust.fuzz_findings "$(awk '{ sum += $4 } END { print sum + 0 }' <<<"$fuzzing")" '<=' 0
sanitizers=$(recorded sanitize hls golden host render apps tb/types tb/golden tb/host tb/kernels tb/csim tb/render tb/apps scripts/sanitize.sh -- ./scripts/sanitize.sh)
figure robust.sanitizer_failed_tests "$(cut -f2 <<<"$sanitizers")" '<=' 0
figure robust.sanitizer_findings "$(cut -f3 <<<"$sanitizers")" '<=' 0
