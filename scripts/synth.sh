#!/usr/bin/env bash
# Synthesis with open tools: what the hardware costs, how fast it is, and a bitstream.
#   ./scripts/synth.sh xc6v                  the accelerator for Virtex-6 (also xc7, ecp5): resources by part
#   ./scripts/synth.sh ecp5                  also placed and routed, five seeds: clock, spread, critical path with its C++ lines
#   ./scripts/synth.sh xc6v --design NAME    another design of scripts/synth/designs.yaml (all: each)
#   ./scripts/synth.sh xc6v --baseline check fails where resources grew by more than 2 % over scripts/synth/baseline.json (or: write)
#   ./scripts/synth.sh sweep                 320x240 to 1920x1080: resources, clock, and which FPGAs hold it
#   ./scripts/synth.sh power                 estimate of the power from the activity in co-simulation
#   ./scripts/synth.sh ulx3s                 bitstream of the demonstration for the ULX3S board: out/ulx3s/floorline.bit
#   ./scripts/synth.sh tables                the comparison tables of README.md and docs/synthesis.md from records/synth (--check: compare)
# Results: tables here, and JSON under build/synth, kept until a source or a tool changes; --record also keeps them in records/synth.
source "$(dirname "$0")/common.sh"
[ "${1:-}" = tables ] || ./scripts/setup.sh
case "${1:-}" in ecp5 | sweep) build release floorline-hlsc ;; esac  # their Verilog is compiled first
exec .venv/bin/python scripts/synth/synth.py "$@"
