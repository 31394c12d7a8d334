#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test. The README's test command, and CI's.
#   ./scripts/test.sh              all tests
#   ./scripts/test.sh -R gaussian  only those whose name matches (any ctest option)
source "$(dirname "$0")/common.sh"

./scripts/setup.sh
say "building (preset release)"
build release
say "running the tests"
ctest --test-dir build/release --output-on-failure -j "$(nproc)" "$@" ||
    fail "tests failed; run one alone with ./scripts/test.sh -R NAME."
