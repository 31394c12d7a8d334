"""Checks docs/pragmas.md against the compiler: a row for every kind, a status, and a test that uses the kind.

Usage: check_pragma_table.py REPOSITORY
"""
import pathlib
import re
import sys


def rows(text):
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 4 and cells[0].isupper():
            yield cells[0], cells[1], cells[3]


def main():
    root = pathlib.Path(sys.argv[1])
    source = (root / "compiler/middle/directives_to_ir.cpp").read_text()
    sets = re.findall(r"k(?:Region|Object|Ignored)Kinds\s*=\s*\{([^}]*)\}", source)
    known = {kind for names in sets for kind in re.findall(r'"([A-Z_]+)"', names)} | {"INTERFACE"}
    table = list(rows((root / "docs/pragmas.md").read_text()))
    faults = [f"{kind} has no row" for kind in sorted(known - {row[0] for row in table})]
    for kind, status, test in table:
        if kind not in known:
            faults.append(f"{kind} has a row, but the compiler does not know it")
        file = root / "compiler/test" / test
        text = file.read_text() if file.is_file() else ""
        if not re.search(rf"#pragma HLS {kind}\b", text, re.IGNORECASE):
            faults.append(f"{kind}: {test} does not use it")
        if status == "ignored" and f"pragma '{kind}' has no effect" not in text:
            faults.append(f"{kind}: {test} states no warning of it")
        if status not in ("honoured", "ignored", "accepted", "refused"):
            faults.append(f"{kind}: '{status}' is no status")
    print("\n".join(faults) or f"{len(table)} kinds, each with its test")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
