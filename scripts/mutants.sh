#!/usr/bin/env bash
# Whether the bench finds bugs that are seeded into the RTL (scripts/mutate.py), as figures; those it misses are named on stderr.
# Usage: mutants.sh BUILD_DIR
source "$(dirname "$0")/common.sh"

ninja -C "$1" cosim_mutants >&2
result=$1/mutants.tsv
"$1/bin/cosim_mutants" >"$result"
grep $'\tmissed$' "$result" | sed 's/^/missed: /' >&2 || true
awk -F'\t' '
    { seeded++; if ($4 != "missed") found++ }
    END {
        printf "cosim.mutants_seeded\t%d\t>= 60\t%s\n", seeded, (seeded >= 60 ? "ok" : "short")
        printf "cosim.mutants_found\t%.3f\t>= 0.95\t%s\n", found / seeded, (found >= 0.95 * seeded ? "ok" : "short")
    }' "$result"
