#!/usr/bin/env bash
# Synthesis with open tools: resources of a design, and for ECP5 its place and route with Fmax and critical path.
#   ./scripts/synth.sh xc6v                   the accelerator's top for Virtex-6 (also xc7, ecp5)
#   ./scripts/synth.sh ecp5 --design NAME     another design of scripts/synth/designs.yaml (--design all: each)
#   ./scripts/synth.sh ecp5 --seeds 5         best of five placements
#   ./scripts/synth.sh xc6v --baseline check  fails when the resources are not those of scripts/synth/baseline.json (or: write)
# Results: a table here, JSON under build/synth/, kept until a source or a tool changes.
source "$(dirname "$0")/common.sh"
[ -x .venv/bin/python ] || fail "the tools are not installed; run ./scripts/setup.sh."
exec .venv/bin/python scripts/synth/synth.py "$@"
