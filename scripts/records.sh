# Long measurements are kept in records/, committed, under the hash of everything that they depend on: a checkout whose sources are those of
# the record prints it again in no time, any other measures anew. `./scripts/figures.sh --fresh` trusts none of them.

# content_hash PATH...: of the tracked files under these paths, as they are in the working tree.
content_hash() {
    git ls-files -z -- "$@" | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -c1-16
}

# What the compiler's Verilog depends on.
compiler_sources=(compiler/frontend compiler/middle compiler/design compiler/schedule compiler/verilog compiler/tool compiler/include rtl/lib hls/compat)

# recorded NAME PATH... -- COMMAND...: the lines that COMMAND prints, from records/NAME.tsv where its first line is the hash of the paths.
# A command that fails is run again the next time; what it printed is still passed on.
recorded() {
    local name=$1 paths=() hash record output
    shift
    while [ "$1" != -- ]; do paths+=("$1"); shift; done
    shift
    hash=$(content_hash "${paths[@]}")
    record=records/$name.tsv
    if [ -n "${FLOORLINE_FRESH:-}" ] || [ ! -f "$record" ] || [ "$(head -1 "$record")" != "$hash" ]; then
        output=$(mktemp)
        if "$@" >"$output"; then
            { printf '%s\n' "$hash"; cat "$output"; } >"$record"
        elif [ ! -s "$output" ]; then
            printf 'error: %s failed and printed nothing; run it and read its message.\n' "$*" >&2
            return 1
        fi
        cat "$output"
        rm -f "$output"
    else
        tail -n +2 "$record"
    fi
}
