"""Estimate of the power on the paper's device: how often signals change, times what a change costs.

    power = static + clock * (fabric * sum of (LUT + FF) * activity + clocking + bram * BRAM + dsp * sum of DSP * activity)

The sums go over the parts of the design with Yosys's counts for xc6v. activity: changes of a bit per clock cycle, the mean over all
signals of a part, counted by Verilator's toggle coverage while rendered frames pass the board demonstration (activity/). Glitches and
what lies inside a cone of LUTs are not seen; the signals that have names stand for them. Coefficients and their uncertainty: power.yaml."""

import collections
import json
import math
import re
import subprocess

import yaml

import flow

CLOCK_MHZ = 61.9  # the paper's, so that its 3.9 W and ours are for the same work
FRAMES = 2
WORK = flow.ROOT / "build/synth/activity"
RECORD = flow.RECORDS / "activity.json"
SOURCES = ("rtl/*.v", "rtl/lib/*.v", "rtl/generated/*.v", "rtl/board/demonstration.v", "rtl/board/register_setup.v",
           "rtl/board/serial_results.v", "scripts/synth/activity/video_file.v")
# Verilator's make runs in its own folder.
MAIN = flow.ROOT / "scripts/synth/activity/main.cpp"
CORE = "TOP.demonstration.top.core."  # where the parts of the accelerator are
PAGE = "\x01page\x02v_toggle"
OTHER = "other"                       # everything around it


def simulate():
    """Two frames of the demo scene through the Verilog; returns the cycles of the second, which coverage.dat counts."""
    WORK.mkdir(parents=True, exist_ok=True)
    floorline = flow.ROOT / "build/release/bin/floorline"
    if not floorline.exists():
        flow.fail("the floorline command is not built; run 'cmake --preset release' and 'ninja -C build/release floorline'.")
    sequence = WORK / "sequence"
    if not sequence.exists():
        flow.run([floorline, "render", "scenes/demo.yaml", "--output", sequence], WORK / "render.log")
    frames = sorted((sequence / "frames").glob("*.png"))[:FRAMES]
    flow.run([flow.tool("convert"), *frames, "-colorspace", "Gray", "-depth", "8", f"gray:{WORK}/frames.grey"], WORK / "convert.log")
    flow.say("Verilator: activity of the demo scene")
    flow.run([flow.tool("verilator"), "--cc", "--exe", "--build", "-O3", "--x-assign", "fast", "--coverage-toggle", "-Wno-fatal", "-Wno-lint",
              "-Wno-style", "--top-module", "demonstration", "-GCYCLES_PER_BIT=4", "--Mdir", WORK / "model", *flow.matching(SOURCES), MAIN],
             WORK / "verilator.log")
    done = subprocess.run([WORK / "model/Vdemonstration"], cwd=WORK, capture_output=True, text=True, check=True)
    return int(done.stdout)


def toggle_points(file):
    """(module, name of the bit, instance, changes) of every point of Verilator's coverage data; fifo__W21_D2 is a fifo."""
    for line in file.read_text(errors="replace").splitlines():
        match = re.match(r"C '(.*)' (\d+)$", line)
        if match and PAGE in match.group(1):
            fields = dict(field.split("\x02", 1) for field in match.group(1).split("\x01") if "\x02" in field)
            yield fields["page"].split("/")[1].split("__")[0], fields["o"], fields["h"], int(match.group(2))


def read_coverage(file, cycles):
    """{part: changes per bit and cycle}; a part is a module in the core, with all that is in it, and OTHER all that is around the core."""
    points = [point for point in toggle_points(file) if not re.fullmatch(r"a?clk", point[1])]  # the clock has a coefficient of its own
    modules = {instance: module for module, _, instance, _ in points if instance.startswith(CORE) and "." not in instance[len(CORE):]}
    changes, bits = collections.Counter(), collections.Counter()
    for _, _, instance, count in points:
        part = modules.get(CORE + instance[len(CORE):].split(".")[0], OTHER) if instance.startswith(CORE) else OTHER
        changes[part] += count
        bits[part] += 1
    return {part: round(changes[part] / bits[part] / cycles, 5) for part in sorted(bits)}


def activity(record):
    key = flow.content_key(flow.matching(SOURCES))
    if RECORD.exists() and json.loads(RECORD.read_text())["key"] == key:
        return json.loads(RECORD.read_text())["activity"]
    cycles = simulate()
    result = {"key": key, "cycles": cycles, "activity": read_coverage(WORK / "coverage.dat", cycles)}
    flow.keep(result, WORK / "activity.json")
    if record:
        flow.keep(result, RECORD)
    return result["activity"]


def estimate(parts, changes, coefficient):
    """{source: (watts, factor of its uncertainty)}. parts: of a result on xc6v; changes: see activity()."""
    mean = changes[OTHER]

    def weighted(*keys):
        return sum(sum(part[key] for key in keys) * changes.get(part["module"], mean) for part in parts)

    watts = CLOCK_MHZ * 1e6 * 1e-12  # of a pJ per cycle
    fabric = weighted("lut", "ff") * coefficient["fabric_pj_per_change"] * watts
    return {
        "LUTs, registers, wires": (fabric, coefficient["fabric_factor"]),
        "clock network": (fabric * coefficient["clock_share"], coefficient["clock_factor"]),
        "block RAM": (sum(part["bram"] for part in parts) * coefficient["bram_pj_per_cycle"] * watts, coefficient["bram_factor"]),
        "DSP": (weighted("dsp") * coefficient["dsp_pj_per_cycle"] * watts, coefficient["dsp_factor"]),
        "the device, waiting": (coefficient["static_w"], coefficient["static_factor"]),
    }


def measure(record=False):
    """{power_w, low_w, high_w, dynamic_w, rows: [[source, W, from, to]]}: the range has every source off by its factor at once."""
    coefficient = yaml.safe_load((flow.HERE / "power.yaml").read_text())
    sources = estimate(flow.evaluate(flow.Design("top", "xc6v"), record=record)["parts"], activity(record), coefficient)
    rows = [[name, round(watts, 3), round(watts / factor, 3), round(watts * factor, 3)] for name, (watts, factor) in sources.items()]
    total = [round(math.fsum(row[i] for row in rows), 2) for i in (1, 2, 3)]
    dynamic = round(total[0] - coefficient["static_w"], 2)
    result = {"power_w": total[0], "low_w": total[1], "high_w": total[2], "dynamic_w": dynamic, "clock_mhz": CLOCK_MHZ,
              "rows": [*rows, ["sum", *total]]}
    if record:
        flow.keep(result, flow.RECORDS / "power.json")
    return result


def sections(result):
    return [{"title": "Power, estimated", "note": f"xc6vlx240t at {result['clock_mhz']} MHz, the demo's frames; the paper estimates 3.9 W.",
             "columns": ["source", "W", "from", "to"], "rows": result["rows"]}]
