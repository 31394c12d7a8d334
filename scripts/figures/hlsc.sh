#!/usr/bin/env bash
# The compiler against native execution: corpus, schedule expectations, refused programs, random programs.
# The count of random programs is the record's (records/fuzz.hlsc.tsv, an hour) where that is of this very compiler; else the 150 of CI are
# run, and the line says short. `HLSC_FUZZ_PROGRAMS=5000 ./scripts/figures.sh hlsc` makes the record. Usage: hlsc.sh BUILD_DIR
source "$(dirname "$0")/../common.sh"
source scripts/records.sh
build=$1
runner=$build/bin/hlsc-differential
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run COMMAND...: sets passed, failed and log. Failures are also told at once, as a long run has an hour to go.
run() {
    log=$({ "$runner" -j 2 --work "$work/run" "$@" 2>/dev/null || true; } | tee >(cat >&2))
    passed=$(sed -n 's/^\([0-9]*\) passed, .*/\1/p' <<<"$log")
    failed=$(sed -n 's/^[0-9]* passed, \([0-9]*\) failed.*/\1/p' <<<"$log")
    [ -n "$passed" ] || { echo "error: $runner $* counted nothing; run it by hand." >&2; exit 1; }
}

run corpus compiler/test/corpus
figure hlsc.corpus_cases $((passed + failed)) '>=' 120
figure hlsc.corpus_failures "$failed" '<=' 0
figure hlsc.schedule_expectations "$(grep -rl '// expect:' --include='*.c*' compiler/test/corpus | wc -l)" '>=' 40

run messages compiler/test/refused
figure hlsc.refused_cases $((passed + failed)) '>=' 40
figure hlsc.refused_failures "$failed" '<=' 0

run messages compiler/test/warned
figure hlsc.warned_failures "$failed" '<=' 0

# What a random program's outcome depends on.
version=$(content_hash "${compiler_sources[@]}" compiler/differential)
record=records/fuzz.hlsc.tsv
if [ -z "${HLSC_FUZZ_PROGRAMS:-}" ] && [ -f "$record" ] && [ "$(head -1 "$record")" = "$version" ]; then
    IFS=$'\t' read -r programs mismatches crashes < <(tail -1 "$record")
else
    run fuzz --first 1 --last "${HLSC_FUZZ_PROGRAMS:-150}"
    crashes=$(grep -cE '^(crash|hang) ' <<<"$log" || true)
    programs=$((passed + failed))
    mismatches=$((failed - crashes))
    [ -z "${HLSC_FUZZ_PROGRAMS:-}" ] || printf '%s\n%s\t%s\t%s\n' "$version" "$programs" "$mismatches" "$crashes" >"$record"
fi
figure hlsc.fuzz_programs "$programs" '>=' 5000
figure hlsc.fuzz_mismatches "$mismatches" '<=' 0
figure hlsc.fuzz_crashes "$crashes" '<=' 0
