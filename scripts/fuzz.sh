#!/usr/bin/env bash
# Fuzzes everything that reads a file (tb/fuzz): any input must load or be refused with a sentence, without a crash, a sanitizer's report,
# a hang or much memory. What the fuzzer learns stays in build/fuzz/TARGET/corpus; an input that breaks a reader lands in
# build/fuzz/TARGET/findings, and the script exits 1.
#   ./scripts/fuzz.sh              10 minutes each: image, yaml, table (CSV and trajectories), scene
#   ./scripts/fuzz.sh 60           a minute each
#   ./scripts/fuzz.sh 60 scene     only the scene reader
source "$(dirname "$0")/common.sh"

seconds=${1:-600}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || fail "'$seconds' is no number of seconds; see the head of scripts/fuzz.sh."
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(image yaml table scene)

# seeds TARGET FOLDER: small valid inputs, from which the fuzzer starts.
seeds() {
    local folder=$2
    case $1 in
        image)
            local picture format
            for format in png jpg; do
                picture=$(find docs -name '*.png' | sort | head -1)
                convert "$picture" -resize '16x12!' "$folder/colour.$format"
                convert "$picture" -resize '16x12!' -colorspace gray -depth 8 "$folder/grey.$format"
            done
            convert "$picture" -resize '16x12!' -depth 16 "$folder/deep.png"
            convert "$picture" -resize '16x12!' -interlace plane "$folder/progressive.jpg"
            ;;
        yaml)
            printf '%%YAML:1.0\n---\nimage_width: 16\nimage_height: 12\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [20., 0., 8., 0., 20., 6., 0., 0., 1.]\ndistortion_coefficients: {rows: 1, cols: 5, data: [.1, 0, 0, 0, 0]}\n' >"$folder/camera.yaml"
            printf 'robot_from_camera: [0, 0, 1, .1,  -1, 0, 0, 0,  0, -1, 0, .6,  0, 0, 0, 1]\n' >"$folder/mount.yaml"
            printf 'name: room\nwidth: 16\nheight: 12\nframe_count: 1\nfps: 25\nsource: rendered\nhas_truth: false\n' >"$folder/sequence.yaml"
            printf 'rule: run\nmin_rows: 12\nleast_height_m: .06\nnoise: 3\nreference_every: 4\n' >"$folder/settings.yaml"
            ;;
        table)
            printf 'frame,timestamp_s,x_m,y_m,yaw_rad\n0,0.0,0,0,0\n1,0.04,.01,-1e-3,.02\n' >"$folder/odometry.csv"
            printf '1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1.5 0 1 0 0 0 0 1 -2e-1\n' >"$folder/poses.txt"
            printf '# timestamp tx ty tz qx qy qz qw\n0 1 2 .5 0 0 0 1\n.5 1 2 .5 0 0 1 0\n' >"$folder/groundtruth.txt"
            ;;
        scene)
            cp scenes/*.yaml "$folder"
            printf 'image: {width: 64, height: 48}\nobstacles: [{kind: ramp}]\npath: {segments: [{frames: 2}]}\n' >"$folder/small.yaml"
            ;;
        *) fail "there is no fuzz target '$1'; choose from image, yaml, table, scene." ;;
    esac
}

# fuzz TARGET: a line on stdout: target, seconds, executions, findings.
fuzz() {
    local target=$1 work=build/fuzz/$1 executions findings
    rm -rf "$work/findings"
    mkdir -p "$work/seeds" "$work/corpus" "$work/findings"
    seeds "$target" "$work/seeds"
    # The decoders of the image library write to stderr for every damaged input: only the fuzzer may (-close_fd_mask).
    "build/asan-ubsan/bin/fuzz_$target" "$work/corpus" "$work/seeds" -artifact_prefix="$work/findings/" -max_total_time="$seconds" \
        -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=256 -max_len=8192 -close_fd_mask=3 -print_final_stats=1 >"$work/log" 2>&1 || true
    executions=$(awk '/stat::number_of_executed_units/ { print $2 }' "$work/log")
    [ -n "$executions" ] || fail "fuzz_$target did not run; read $work/log."
    findings=$(find "$work/findings" -type f | wc -l)
    printf '%s\t%s\t%s\t%s\n' "$target" "$seconds" "$executions" "$findings"
}

build asan-ubsan fuzzers
say "fuzzing ${targets[*]}, $seconds s each (target, seconds, executions, findings)"
for target in "${targets[@]}"; do fuzz "$target"; done | tee build/fuzz.tsv
! awk -F'\t' '{ sum += $4 } END { exit sum == 0 }' build/fuzz.tsv ||
    fail "the readers broke; the inputs are in build/fuzz/*/findings, the reports in build/fuzz/*/log."
