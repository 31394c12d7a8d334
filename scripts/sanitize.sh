#!/usr/bin/env bash
# Runs the test suite under AddressSanitizer and UndefinedBehaviorSanitizer (preset asan-ubsan). Prints tests, failures and sanitizer
# reports, tab-separated, and exits 1 when a test fails; the output of every test stays in build/asan-ubsan/sanitize.log.
# Left out: the compiler, because Debian's LLVM libraries are not instrumented and containers that cross into them raise false reports, and
# the benches of the RTL, because their C++ is Verilator's and their subject is Verilog.
#   ./scripts/sanitize.sh              all parts
#   ./scripts/sanitize.sh host render  some parts
source "$(dirname "$0")/common.sh"

declare -A targets=(
    [types]="types_test types_systemc_test" [golden]=golden_tests [host]=host_tests [kernels]=kernel_tests
    [render]=render_tests [apps]="report_test command_test")
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(types golden host kernels render apps)
for part in "${parts[@]}"; do
    [ -n "${targets[$part]:-}" ] || fail "there is no part '$part'; choose from types, golden, host, kernels, render, apps."
done

# shellcheck disable=SC2086 # a part has several targets
build asan-ubsan $(for part in "${parts[@]}"; do echo ${targets[$part]}; done)
log=build/asan-ubsan/sanitize.log
: >"$log"
say "tests under the sanitizers: ${parts[*]} (tests, failures, sanitizer reports)"
for part in "${parts[@]}"; do
    ASAN_OPTIONS=detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1 \
        ctest --test-dir "build/asan-ubsan/tb/$part" --output-on-failure -j "$(nproc)" >>"$log" 2>&1 || true
done
summary=$(awk '
    / tests? failed out of / { failed += $4; tests += $NF }
    /ERROR: (Address|Leak)Sanitizer|: runtime error: / { reports++ }
    END { printf "%d\t%d\t%d", tests, failed, reports }' "$log")
printf '%s\n' "$summary"
[ "$(cut -f1 <<<"$summary")" -gt 0 ] || fail "no test ran; read $log."
[ "$(cut -f2 <<<"$summary")" = 0 ] || fail "tests fail under the sanitizers; their reports are in $log."
