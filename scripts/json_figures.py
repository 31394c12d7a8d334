#!/usr/bin/env python3
"""The figures that a command wrote with --json, as lines of ./scripts/figures.sh.

A line is AREA.NAME.CASE, value, bound, ok or short. A score against masks alone has no figures with bounds; then its three shares are
printed without.
"""

import argparse
import json

UNBOUNDED = ("mask_precision", "pixel_precision", "pixel_recall")

parser = argparse.ArgumentParser(description=__doc__)
for argument in ("file", "area", "case"):
    parser.add_argument(argument)
arguments = parser.parse_args()
with open(arguments.file) as file:
    result = json.load(file)
figures = result["figures"] or [{"name": name, "value": result[name], "bound": "", "verdict": "ok"} for name in UNBOUNDED]
for figure in figures:
    value = "none" if figure["value"] is None else format(figure["value"], ".4g")
    print(f"{arguments.area}.{figure['name']}.{arguments.case}", value, figure["bound"], figure["verdict"], sep="\t")
