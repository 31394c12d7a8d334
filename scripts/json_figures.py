#!/usr/bin/env python3
"""The figures that a command wrote with --json, as lines of ./scripts/figures.sh.

Usage: json_figures.py FILE AREA CASE. A line is AREA.NAME.CASE, value, bound, ok or short. A score against masks alone has no figures
with bounds; then its three shares are printed without.
"""

import json
import sys

UNBOUNDED = ("mask_precision", "pixel_precision", "pixel_recall")

path, area, case = sys.argv[1:]
with open(path) as file:
    result = json.load(file)
figures = result["figures"] or [{"name": name, "value": result[name], "bound": "", "verdict": "ok"} for name in UNBOUNDED]
for figure in figures:
    value = "none" if figure["value"] is None else format(figure["value"], ".4g")
    print(f"{area}.{figure['name']}.{case}", value, figure["bound"], figure["verdict"], sep="\t")
