# Shared by the scripts of this folder: progress lines, one-sentence failures, the release build.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

say() { printf '\033[1m==> %s\033[0m\n' "$*" >&2; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

# build PRESET TARGET... : configure when needed and build, quietly unless it fails.
build() {
    local preset=$1
    shift
    [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >"build-$preset.log" 2>&1 ||
        { cat "build-$preset.log" >&2; fail "CMake could not configure preset '$preset'; run ./scripts/setup.sh and read the lines above."; }
    rm -f "build-$preset.log"
    ninja -C "build/$preset" "$@" >&2 || fail "the build failed; the compiler's message is above."
}

# figure NAME VALUE RELATION BOUND: a line of ./scripts/figures.sh; a VALUE that is no number is short.
figure() {
    awk -v OFS='\t' -v name="$1" -v value="$2" -v relation="$3" -v bound="$4" 'BEGIN {
        known = value ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/
        kept = relation == ">=" ? value + 0 >= bound + 0 : relation == "<=" ? value + 0 <= bound + 0 : value + 0 == bound + 0
        print name, value, relation " " bound, known && kept ? "ok" : "short"
    }'
}
