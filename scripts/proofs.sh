#!/usr/bin/env bash
# Runs the formal proofs of tb/rtl/formal/proofs.txt, a line each: name<TAB>proved<TAB>seconds. Exits 1 when one fails.
#   ./scripts/proofs.sh              all
#   ./scripts/proofs.sh fifo_depth_3 only those named
source "$(dirname "$0")/common.sh"

for tool in yosys yosys-abc yosys-smtbmc z3; do
    command -v "$tool" >/dev/null || fail "'$tool' is missing; run ./scripts/setup.sh."
done
table=tb/rtl/formal/proofs.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run NAME STEP COMMAND... : keeps the log, shows it when the command fails.
run() {
    local name=$1 step=$2
    shift 2
    "$@" >"$work/log" 2>&1 || { tail -n 25 "$work/log" >&2; fail "proof '$name': the step '$step' failed; its last lines are above."; }
}

# prove NAME TOP PARAMETERS STEPS SOURCES
prove() {
    local name=$1 top=$2 parameters=$3 steps=$4 sources=$5 set_parameters='' started=$SECONDS
    [ "$parameters" = - ] || for pair in ${parameters//,/ }; do set_parameters+="chparam -set ${pair/=/ } $top; "; done
    local design="read_verilog -formal $sources; ${set_parameters}prep -flatten -top $top; memory_map; async2sync; dffunmap"

    run "$name" elaborate yosys -q -p "$design; write_smt2 -wires $work/$name.smt2; delete t:\$cover; opt -full; techmap; opt_clean; \
        dffunmap; setundef -undriven -anyseq; abc -g AND; dffunmap; opt_clean; write_aiger -zinit $work/$name.aig"
    [ "$steps" = - ] || run "$name" 'bounded check' yosys-smtbmc -s z3 -t "$steps" "$work/$name.smt2"
    run "$name" reachability yosys-abc -c "read $work/$name.aig; fold; strash; scorr; pdr"
    grep -q '^Property proved' "$work/log" || { cat "$work/log" >&2; fail "proof '$name': property-directed reachability did not prove it."; }
    [ "$steps" = - ] || run "$name" cover yosys-smtbmc -s z3 -c -t 40 "$work/$name.smt2"
    printf '%s\tproved\t%d\n' "$name" $((SECONDS - started))
}

wanted=" $* "
found=0
while read -r name top parameters steps sources; do
    case "$name" in '' | '#'*) continue ;; esac
    [ $# -eq 0 ] || [[ $wanted == *" $name "* ]] || continue
    found=$((found + 1))
    prove "$name" "$top" "$parameters" "$steps" "$sources"
done <"$table"
[ "$found" -gt 0 ] || fail "no proof has that name; choose from $table."
