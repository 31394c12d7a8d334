"""Checks that every pin and clock of a constraints file names a port of the top, and that every port of a board top has its pin.

usage: check_pins.py CONSTRAINTS TOP SOURCE... ; CONSTRAINTS is a .ucf, .xdc or .lpf file.
"""

import fnmatch
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PATTERNS = {  # what a constraint calls a port, by kind of file
    ".ucf": r'^\s*NET\s+"([^"]+)"',
    ".lpf": r'^\s*(?:LOCATE\s+COMP|IOBUF\s+PORT|FREQUENCY\s+PORT)\s+"([^"]+)"',
    ".xdc": r"\[get_ports\s+(\{[^}]*\}|\S+?)(?:\s+-filter\s+\{[^}]*\})?\]",
}


def ports_of(top, sources):
    """Every bit of every port, as constraints name it: `led[3]`, or `clk` where the port has one bit."""
    with tempfile.TemporaryDirectory() as folder:
        netlist = pathlib.Path(folder) / "top.json"
        script = f"read_verilog {' '.join(sources)}; hierarchy -top {top}; proc; write_json {netlist}"
        subprocess.run(["yosys", "-q", "-p", script], check=True)
        ports = json.loads(netlist.read_text())["modules"][top]["ports"]
    return {name: len(port["bits"]) for name, port in ports.items()}


def named_ports(constraints):
    """The names or patterns in the file."""
    pattern = PATTERNS.get(constraints.suffix)
    if pattern is None:
        sys.exit(f"error: {constraints.name} is no constraints file; give a .ucf, .xdc or .lpf.")
    names = []
    for match in re.finditer(pattern, constraints.read_text(), flags=re.MULTILINE):
        names += match.group(1).strip("{}").split()
    return names


def faults(constraints, ports, top):
    """A sentence for names that are no port, and one for ports without a pin."""
    bits = [name if width == 1 else f"{name}[{i}]" for name, width in ports.items() for i in range(width)]
    names = named_ports(constraints)
    if constraints.suffix == ".xdc":  # patterns name whole ports, and pins are the business of the design around
        unknown, missing = [name for name in names if not fnmatch.filter(ports, name)], []
    else:
        unknown, missing = [name for name in names if name not in bits], [bit for bit in bits if bit not in names]
    if unknown:
        yield f"{constraints.name} names {', '.join(unknown)}, but {top} has no such port; correct the name."
    if missing:
        yield f"{constraints.name} gives no pin to {', '.join(missing)} of {top}; add it."


def main():
    if len(sys.argv) < 4:
        sys.exit(f"error: {__doc__}")
    constraints, top, sources = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    for fault in faults(constraints, ports_of(top, sources), top):
        sys.exit(f"error: {fault}")


if __name__ == "__main__":
    main()
