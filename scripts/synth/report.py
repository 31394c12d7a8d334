"""What a synthesis result says to a person: tables, plain module names, the critical path in terms of the source, and the section for
`floorline report --hardware`."""

import collections
import re

COLUMNS = ("lut", "ff", "bram", "dsp")


def module_name(name):
    """Yosys calls a module with parameters $paramod$HASH\\NAME or $paramod\\NAME\\P=..; this gives NAME."""
    match = re.match(r"\$paramod(?:\$[0-9a-f]+)?\\([^\\]+)", name)
    return match.group(1) if match else name


def merge(rows):
    """Rows of the same module added up, most LUTs first; modules without cells are left out."""
    merged = collections.defaultdict(lambda: dict.fromkeys(("instances", *COLUMNS), 0))
    for row in rows:
        for key in ("instances", *COLUMNS):
            merged[row["module"]][key] += row[key]
    used = [{"module": name, **row} for name, row in merged.items() if any(row[key] for key in COLUMNS)]
    return sorted(used, key=lambda row: (-row["lut"], row["module"]))


def net_sources(files):
    """{instance: {name in its Verilog: 'file:line' of the C++ that its comment tells}}, for the wires of generated Verilog. A file holds a module,
    and its instance is called as the module is; the one of a top without DATAFLOW, TOP_core, is called core."""
    sources = {}
    for file in files:
        module = sources.setdefault("core" if file.stem.endswith("_core") else file.stem, {})
        for line in file.read_text().splitlines():
            match = re.search(r"^\s*(?:wire|reg)\b.*?\b(\w+)\s*(?:=|;).*//\s*(\S+:\d+)", line)
            if match:
                module.setdefault(match.group(1), match.group(2))
    return sources


def plain_name(name):
    """A net or cell name without what Yosys and nextpnr append to the name in the Verilog."""
    name = re.sub(r"\[\d+\]$", "", name)
    return re.sub(r"(?:_(?:TRELLIS_FF|LUT4|PFUMX|L6MUX21|CCU2C|DP16KD|MULT18X18D)_.*|\.\d+\.\d+)$", "", name)


def source_of(name, sources):
    """The C++ line of a name in the Verilog, '' where there is none. Registers of a pipeline stage are NAME_s1, NAME_s2.. of a wire NAME."""
    *instances, local = name.split(".")
    module = next((sources[instance] for instance in reversed(instances) if instance in sources), {})
    return module.get(local) or module.get(re.sub(r"_s\d+$", "", local), "")


def critical_path(routed, files):
    """The slowest path of a nextpnr report from register to register (not those of the shell's pins), from where it starts to where it
    ends: [{ns, at, source}]; `at` is the name in the Verilog, `source` its C++ line or ''. ns: time from the clock edge until the signal
    has left `at`."""
    between_registers = [path for path in routed["critical_paths"] if "<async>" not in (path["from"], path["to"])]
    slowest = max(between_registers, key=lambda path: sum(step["delay"] for step in path["path"]))
    sources = net_sources(files)
    steps = []
    elapsed = 0.0
    for step in slowest["path"]:
        elapsed += step["delay"]
        name = plain_name(step["from"]["cell"])
        if not steps or (steps[-1]["at"] != name and not name.startswith("$")):  # $: a cell of nextpnr's own, of the name before
            steps.append({"at": name, "source": source_of(name, sources)})
        steps[-1]["ns"] = round(elapsed, 2)
    return steps


def table(header, rows):
    """Columns of text; the first is flushed left, the others right."""
    cells = [[str(cell) for cell in row] for row in [header, *rows]]
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    return "\n".join("  ".join(cell.ljust(width) if i == 0 else cell.rjust(width) for i, (cell, width) in enumerate(zip(row, widths))) for row in cells)


def sections(result):
    """The tables of a result as sections of docs/report.md: [{title, note, columns, rows}]."""
    where = f"{result['design']} on {result['target']}"
    rows = [[row["module"], row["instances"], *(row[key] for key in COLUMNS)] for row in result["parts"]]
    rows.append(["all, flattened", "", *(result["total"][key] for key in COLUMNS)])
    found = [{"title": f"Resources: {where}", "note": "Yosys, before placement; a part has all that is in it.",
              "columns": ["part", "instances", "LUT", "FF", "BRAM", "DSP"], "rows": rows}]
    if result["routes"]:
        mhz = [route["mhz"] for route in result["routes"]]
        best = max(result["routes"], key=lambda route: route["mhz"])
        found.append({"title": f"Critical path: {where}",
                      "note": f"{best['mhz']} MHz, the best of {len(mhz)} placements ({min(mhz)} to {max(mhz)} MHz).",
                      "columns": ["at", "ns", "C++"], "rows": [[step["at"], step["ns"], step["source"]] for step in best["path"]]})
    return found


def text(sections_):
    return "\n\n".join(f"{section['title']}\n{section['note']}\n{table(section['columns'], section['rows'])}" for section in sections_)
