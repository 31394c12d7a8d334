"""Tables of our figures beside others', written into README.md and docs/synthesis.md between markers, and for `floorline report --hardware`.

Everything comes from JSON: records/synth (our measurements), tb/cosim/cycles_baseline.json (cycles), published.yaml (others)."""

import json
import re

import yaml

import flow
import power
import report
import sweep

CYCLES = flow.ROOT / "tb/cosim/cycles_baseline.json"
VGA = (640, 480)
HD = (1920, 1080)
KERNELS = ("gaussian", "erode", "polar", "histogram")  # those that are also written by hand, in bench/handwritten
STAGE_COLUMNS = ("lut", "ff", "dsp")  # Vitis Vision's tables count block RAM in other units
SECTIONS = flow.ROOT / "build/synth/tables.sections.json"


def record(name):
    """A record, or {} where nobody has measured it yet."""
    file = flow.RECORDS / f"{name}.json"
    return json.loads(file.read_text()) if file.exists() else {}


def published():
    return yaml.safe_load((flow.HERE / "published.yaml").read_text())


def cycles(size):
    return next(row for row in json.loads(CYCLES.read_text()) if (row["width"], row["height"]) == size)


def clock(result):
    """The fastest placement in MHz, or None."""
    route = flow.best_route(result) if result else None
    return route["mhz"] if route else None


def ours():
    """{figure: value or None} under the names of published.yaml."""
    xilinx, mhz, vga = record("xc6v-top"), clock(record("ecp5-top")), cycles(VGA)
    return {
        "clock_mhz": mhz,
        "frames_per_second": mhz and round(mhz * 1e6 / vga["frame_cycles"]),
        "latency_us": mhz and round(vga["decision_latency"] / mhz, 1),
        **{key: xilinx["total"][key] if xilinx else None for key in report.COLUMNS},
        "power_w": record("power").get("power_w"),
    }


# figure: (its name for a reader, the command that prints it)
FIGURES = {
    "clock_mhz": ("clock, MHz (ours: placed and routed on ECP5 -6; theirs: Virtex-6)", "./scripts/synth.sh ecp5"),
    "frames_per_second": ("640x480 frames a second at that clock", "./scripts/figures.sh synth"),
    "latency_us": ("last pixel that decides to contact point, us", "./build/release/bin/floorline cycles"),
    "lut": ("LUT, Virtex-6 (ours: Yosys)", "./scripts/synth.sh xc6v"),
    "ff": ("flip-flops", "./scripts/synth.sh xc6v"),
    "bram": ("RAMB36", "./scripts/synth.sh xc6v"),
    "dsp": ("DSP48E1", "./scripts/synth.sh xc6v"),
    "power_w": ("power at 61.9 MHz, W (both estimated)", "./scripts/synth.sh power"),
}


def ratio(our, their):
    return "-" if our is None or not their else f"{our / their:.2f}"


def told(value):
    return "not told" if value is None else value


def comparison():
    """Ours beside the paper's architecture 2."""
    our, their = ours(), published()["paper"]
    rows = [[name, "not measured" if our[key] is None else our[key], told(their[key]), ratio(our[key], their[key]), command]
            for key, (name, command) in FIGURES.items()]
    return {"title": "Beside the paper", "note": "Architecture 2 at 640x480.", "columns": ["figure", "ours", "paper", "ratio", "printed by"], "rows": rows}


def stages():
    """Our stages at VGA and 1080p beside the functions of Vitis Vision that do the same work, at 1080p."""
    part = {size: {row["module"]: row for row in record(name).get("parts", [])}
            for size, name in ((VGA, "xc6v-top"), (HD, f"xc6v-top_{HD[0]}x{HD[1]}"))}
    rows = []
    for function in published()["vitis_vision"]:
        cells = [part[size].get(function["stage"], {}).get(key, "-") for size in (VGA, HD) for key in STAGE_COLUMNS]
        rows.append([function["stage"], *cells, function["function"], *(function[key] for key in STAGE_COLUMNS)])
    sums = ["" if any(isinstance(cell, str) for cell in column) else sum(column) for column in list(zip(*rows))[1:]]
    rows.append(["sum", *sums])
    return {"title": "Stages beside Vitis Vision", "note": "Ours by Yosys for Virtex-6, theirs as published for 1080p, one pixel a clock.",
            "columns": ["stage", "LUT, VGA", "FF", "DSP", "LUT, 1080p", "FF", "DSP", "Vitis Vision", "LUT", "FF", "DSP"], "rows": rows}


def by_hand():
    """Compiled kernels beside the same ones written by hand."""
    rows = []
    for kernel in KERNELS:
        pairs = [[record(f"{target}-{name}") for name in (kernel, f"{kernel}_handwritten")] for target in ("xc6v", "ecp5")]
        if not all(map(all, pairs)):
            return None
        xilinx, lattice = pairs
        rows.append([kernel, *(" / ".join(str(result["total"][key]) for result in xilinx) for key in report.COLUMNS),
                     " / ".join(str(clock(result)) for result in lattice)])
    return {"title": "Beside Verilog by hand", "note": "Compiled / by hand; the best of five placements each.",
            "columns": ["kernel", "LUT, Virtex-6", "FF", "RAMB36", "DSP48", "MHz, ECP5 -6"], "rows": rows}


def parts():
    result = record("xc6v-top")
    return report.sections(result)[0] if result else None


def lens():
    result = record("xc6v-lens")
    if not result:
        return None
    return {"title": "Lens stage", "note": "Yosys for Virtex-6; VGA, nearest pixel, rows up to 20 rows away.",
            "columns": ["stage", *(key.upper() for key in report.COLUMNS)],
            "rows": [["lens", *(result["total"][key] for key in report.COLUMNS)]]}


def placements():
    """The clock of each seed, and the critical path of the fastest."""
    result = record("ecp5-top")
    if not result or not result["routes"]:
        return None
    return report.sections(result)[1]


def sizes():
    rows = [(*size, record(f"xc6v-{sweep.name(*size)}"), record(f"ecp5-{sweep.name(*size)}")) for size in sweep.SIZES]
    return sweep.sections(rows)[0] if all(xilinx for _, _, xilinx, _ in rows) else None


def power_table():
    result = record("power")
    return power.sections(result)[0] if result else None


TABLES = {"comparison": comparison, "stages": stages, "by_hand": by_hand, "parts": parts, "lens": lens,
          "placements": placements, "sizes": sizes, "power": power_table}


def cell_text(value):
    """As Markdown: commands as code."""
    return f"`{value}`" if str(value).startswith("./") else str(value)


def markdown(section):
    if section is None:
        return "Not measured yet.\n"
    lines = ["| " + " | ".join(section["columns"]) + " |", "| --- |" + " ---: |" * (len(section["columns"]) - 1)]
    lines += ["| " + " | ".join(map(cell_text, row)) + " |" for row in section["rows"]]
    return f"{section['note']}\n\n" + "\n".join(lines) + "\n"


def filled(text, file):
    """The text with every table between its markers renewed."""

    def table(match):
        if match.group(1) not in TABLES:
            flow.fail(f"{file}: there is no table '{match.group(1)}'; choose from: {', '.join(TABLES)}.")
        return f"<!-- table {match.group(1)}: ./scripts/synth.sh tables -->\n{markdown(TABLES[match.group(1)]())}<!-- end -->"

    return re.sub(r"<!-- table (\w+):.*?-->\n.*?<!-- end -->", table, text, flags=re.DOTALL)


def update(check):
    """Renews the tables; with `check` only says whether they are what the records give."""
    for file in (flow.ROOT / "README.md", flow.ROOT / "docs/synthesis.md"):
        before = file.read_text()
        after = filled(before, file.name)
        if check and before != after:
            flow.fail(f"{file.name} does not tell what records/synth has; run ./scripts/synth.sh tables.")
        if not check and before != after:
            file.write_text(after)
    if not check:
        flow.keep([section for section in (table() for table in TABLES.values()) if section], SECTIONS)
        print(f"for a report: floorline report SEQUENCE --hardware {SECTIONS.relative_to(flow.ROOT)}")
