#!/usr/bin/env bash
# Each kernel in C simulation against its golden twin: the figures that the kernel tests record as "value bound".
# Lines with _real are missing where ../shared/data is. Usage: kernels.sh BUILD_DIR
set -euo pipefail
results=$(mktemp)
trap 'rm -f "$results"' EXIT
# A figure beyond its bound also fails its test; the verdict here is the figure's.
"$1/bin/kernel_tests" "--gtest_output=xml:$results" >/dev/null 2>&1 || true
figures=$(sed -n 's/.*<property name="\([a-z_0-9]*\)" value="\([^ ]*\) \([^ "]*\)".*/\1 \2 \3/p' "$results")
[ -n "$figures" ] || { echo "error: the kernel tests left no figures; run $1/bin/kernel_tests and read its output." >&2; exit 1; }
awk '{ printf "kernels.%s\t%s\t<= %s\t%s\n", $1, $2, $3, ($2 + 0 <= $3 + 0 ? "ok" : "short") }' <<<"$figures"
