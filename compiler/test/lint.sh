#!/usr/bin/env bash
# lint.sh floorline-hlsc ROOT CASE...: compiles cases of test/cosim. Verilator -Wall, Icarus and Yosys must accept the
# Verilog without a word, and a C header must be the one beside the case.
set -euo pipefail
compiler=$1 root=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for case in "$@"; do
  "$compiler" compile "$root/compiler/test/cosim/$case.cpp" --top "$case" -o "$work/$case"
  cd "$work/$case"
  verilator --lint-only -Wall --top-module "$case" -y "$root/rtl/lib" ./*.v
  iverilog -g2005 -Wall -s "$case" -o /dev/null -y "$root/rtl/lib" ./*.v 2>&1 | tee icarus.log
  yosys -q -p "read_verilog *.v $root/rtl/lib/*.v; hierarchy -check -top $case; proc; check -assert" 2>&1 | tee yosys.log
  [ ! -s icarus.log ] && [ ! -s yosys.log ]
  header=$root/compiler/test/cosim/x${case}_hw.h
  [ ! -f "$header" ] || diff "$header" "x${case}_hw.h"
done
