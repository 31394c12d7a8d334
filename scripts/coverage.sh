#!/usr/bin/env bash
# Line coverage of hls/, golden/ and host/ by their own tests (preset coverage): folder, covered lines, lines and percent, tab-separated.
# build/coverage/report.txt lists every file, build/coverage/html/index.html shows every line.
source "$(dirname "$0")/common.sh"

tests=(types_test types_systemc_test golden_tests host_tests kernel_tests)
build coverage "${tests[@]}"
work=build/coverage/profiles
rm -rf "$work"
mkdir -p "$work"
objects=()
for test in "${tests[@]}"; do
    say "running $test"
    LLVM_PROFILE_FILE="$work/$test.profraw" SYSTEMC_DISABLE_COPYRIGHT_MESSAGE=1 "build/coverage/bin/$test" >"$work/$test.log" 2>&1 ||
        fail "$test failed; read $work/$test.log."
    objects+=(-object "build/coverage/bin/$test")
done
llvm-profdata-19 merge -sparse "$work"/*.profraw -o "$work/all.profdata"
measured=("${objects[@]}" -instr-profile="$work/all.profdata" hls golden host)
llvm-cov-19 report "${measured[@]}" >build/coverage/report.txt
llvm-cov-19 show -format=html -output-dir=build/coverage/html "${measured[@]}"
llvm-cov-19 export -summary-only "${measured[@]}" | python3 -c '
import json, os, sys
lines = {folder: [0, 0] for folder in ("hls", "golden", "host")}
for file in json.load(sys.stdin)["data"][0]["files"]:
    folder = os.path.relpath(file["filename"]).split(os.sep)[0]
    lines[folder][0] += file["summary"]["lines"]["covered"]
    lines[folder][1] += file["summary"]["lines"]["count"]
for folder, (covered, count) in lines.items():
    print(folder, covered, count, f"{100 * covered / count:.1f}", sep="\t")'
