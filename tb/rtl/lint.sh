#!/usr/bin/env bash
# lint.sh TOP SOURCE... : reads one Verilog module in Verilator, Icarus and Yosys; any warning of any of them is a failure.
set -euo pipefail
top=$1
shift

# quietly TOOL COMMAND... : fails when the command fails or says anything.
quietly() {
    local tool=$1 said
    shift
    said=$("$@" 2>&1) && [ -z "$said" ] || { printf '%s\nerror: %s does not accept %s without a warning; see above.\n' "$said" "$tool" "$top" >&2; exit 1; }
}

quietly Verilator verilator --lint-only -Wall --top-module "$top" "$@"
quietly Icarus iverilog -g2005 -Wall -DSIMULATION -t null -s "$top" "$@"
quietly Yosys yosys -q -p "read_verilog $*; hierarchy -check -top $top; proc; check -assert"
