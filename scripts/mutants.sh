#!/usr/bin/env bash
# Whether the bench finds bugs that are seeded into the RTL (scripts/mutate.py), as figures; those it misses are named by a line each.
# Usage: mutants.sh BUILD_DIR
source "$(dirname "$0")/common.sh"

ninja -C "$1" cosim_mutants >&2
result=$1/mutants.tsv
"$1/bin/cosim_mutants" >"$result"
seeded=$(wc -l <"$result")
found=$(grep -vc $'\tmissed$' "$result" || true)
figure cosim.mutants_seeded "$seeded" '>=' 60
figure cosim.mutants_found "$(awk -v found="$found" -v seeded="$seeded" 'BEGIN { printf "%.3f", found / seeded }')" '>=' 0.95
# cosim.mutant_missed.FILE:LINE, what was changed.
awk -F'\t' '$4 == "missed" { printf "cosim.mutant_missed.%s\t%s\t\tok\n", $2, $3 }' "$result"
