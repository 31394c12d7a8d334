#!/usr/bin/env bash
# Resources, clock and power of the accelerator, and the compiler's kernels beside those written by hand. What is known for these very sources
# comes from records/synth or build/synth; else it is measured and recorded, which takes an hour, most of it place and route.
set -euo pipefail
.venv/bin/python scripts/synth/figures.py
./scripts/synth.sh tables >/dev/null
