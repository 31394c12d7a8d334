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
