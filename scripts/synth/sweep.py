"""The accelerator at other maxima than VGA: its top is hls/accelerator.cpp with another configuration, compiled by floorline-hlsc."""

import yaml

import compiled
import flow
import report

SIZES = ((320, 240), (640, 480), (1280, 720), (1920, 1080))


def name(width, height):
    """What the design of a size is called; VGA's is the one that the project ships."""
    return "top" if (width, height) == compiled.VGA else f"top_{width}x{height}"


def design(width, height, target):
    if name(width, height) == "top":
        return flow.Design("top", target)
    entry = dict(flow.entries()["top"], parameters={"MAX_WIDTH": width, "MAX_HEIGHT": height})
    return flow.Design(name(width, height), target, entry, (width, height))


def devices():
    return yaml.safe_load((flow.HERE / "devices.yaml").read_text())


def holds(device, total):
    return all(total[key] <= device[key] for key in ("lut", "bram", "dsp"))


def measure(options):
    """[(width, height, result on xc6v, result on ecp5)]; placed where the LFE5U-85F holds it. Virtex-6 and the largest come first, so that a
    run that is stopped has recorded what docs/synthesis.md wants most."""
    largest = next(device for device in devices() if device["name"] == "LFE5U-85F")
    xilinx = {size: flow.evaluate(design(*size, "xc6v"), record=options.record) for size in reversed(SIZES)}
    lattice = {}
    for size in SIZES:
        lattice[size] = flow.evaluate(design(*size, "ecp5"), record=options.record)
        if holds(largest, lattice[size]["total"]):
            lattice[size] = flow.evaluate(design(*size, "ecp5"), options.seeds, options.record, options.jobs)
    return [(*size, xilinx[size], lattice[size]) for size in SIZES]


def smallest(results):
    """The smallest device of each family that holds a design, as text."""
    found = {}
    for device in devices():
        if device["family"] not in found and results[device["flow"]] and holds(device, results[device["flow"]]["total"]):
            found[device["family"]] = device["name"]
    return ", ".join(found.values()) or "none of scripts/synth/devices.yaml"


def sections(rows):
    """A section of docs/report.md, which tables.py also puts into docs/synthesis.md."""
    table = []
    for width, height, xilinx, lattice in rows:
        route = flow.best_route(lattice) if lattice else None
        table.append([f"{width}x{height}", *(xilinx["total"][key] for key in report.COLUMNS),
                      *(lattice["total"][key] if lattice else "-" for key in report.COLUMNS), route["mhz"] if route else "-",
                      smallest({"xc6v": xilinx, "ecp5": lattice})])
    placed = ", ".join(f"{len(lattice['routes'])} at {width}x{height}" for width, height, _, lattice in rows if lattice and lattice["routes"])
    return [{"title": "Resources by frame size",
             "note": "Yosys for Virtex-6 (7-series has the same blocks) and ECP5; clock: LFE5U-85F, speed grade 6, where it holds the "
                     f"design, the best of the placements tried ({placed}).",
             "columns": ["largest frame", "LUT", "FF", "RAMB36", "DSP48", "ECP5 LUT", "FF", "18 Kbit", "DSP", "MHz", "smallest FPGA of each family"],
             "rows": table}]
