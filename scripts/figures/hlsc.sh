#!/usr/bin/env bash
# The compiler against native execution: corpus, schedule expectations, refused programs, random programs.
# Counts of long fuzz runs (hlsc-differential fuzz, docs/fuzzing.md) are taken from BUILD_DIR/hlsc_fuzz_record when they belong to
# the present compiler; else the 150 programs of CI are run. Usage: hlsc.sh BUILD_DIR
set -euo pipefail
build=$1
runner=$build/bin/hlsc-differential
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

line() { # name value relation bound
    awk -v n="$1" -v v="$2" -v r="$3" -v b="$4" 'BEGIN { ok = r == ">=" ? v >= b : v <= b; printf "hlsc.%s\t%s\t%s %s\t%s\n", n, v, r, b, ok ? "ok" : "short" }'
}
# run COMMAND...: sets passed, failed and log.
run() {
    log=$("$runner" -j 2 --work "$work/run" "$@" 2>/dev/null || true)
    passed=$(sed -n 's/^\([0-9]*\) passed, .*/\1/p' <<<"$log")
    failed=$(sed -n 's/^[0-9]* passed, \([0-9]*\) failed.*/\1/p' <<<"$log")
    [ -n "$passed" ] || { echo "error: $runner $* counted nothing; run it by hand." >&2; exit 1; }
}

run corpus compiler/test/corpus
line corpus_cases $((passed + failed)) '>=' 120
line corpus_failures "$failed" '<=' 0
line schedule_expectations "$(grep -rl '// expect:' --include='*.c*' compiler/test/corpus | wc -l)" '>=' 40

run messages compiler/test/refused
line refused_cases $((passed + failed)) '>=' 40
line refused_failures "$failed" '<=' 0

run messages compiler/test/warned
line warned_failures "$failed" '<=' 0
line open_cases "$(find compiler/test/open -mindepth 2 -type f | wc -l)" '<=' 0

record=$build/hlsc_fuzz_record
version=$(find compiler rtl/lib hls/compat -type f -not -path 'compiler/test/*' | LC_ALL=C sort | xargs sha256sum | sha256sum | cut -d' ' -f1)
if [ ! -f "$record" ] || [ "$(sed -n 1p "$record")" != "$version" ]; then
    run fuzz --first 1 --last "${HLSC_FUZZ_PROGRAMS:-150}"
    crashes=$(grep -cE '^(crash|hang) ' <<<"$log" || true)
    printf '%s\n%s %s %s\n' "$version" $((passed + failed)) $((failed - crashes)) "$crashes" >"$record"
fi
read -r programs mismatches crashes < <(sed -n 2p "$record")
line fuzz_programs "$programs" '>=' 5000
line fuzz_mismatches "$mismatches" '<=' 0
line fuzz_crashes "$crashes" '<=' 0
