#!/usr/bin/env bash
# Resources and clock of the accelerator, and of the compiler's kernels beside those written by hand. Results are kept in build/synth/ until
# a source or a tool changes; the first run takes some minutes.
set -euo pipefail
.venv/bin/python scripts/synth/figures.py
