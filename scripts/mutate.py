#!/usr/bin/env python3
"""Seeds bugs into a copy of rtl/, all of them in one text: input `mutant` of floorline_top says which one is alive, 0: none.

    scripts/mutate.py FOLDER              write the copy and FOLDER/mutants.tsv: number, file:line, what was changed
    scripts/mutate.py FOLDER --count N    so many bugs (80)

The choice depends on the texts alone: every file takes part, and of its places those with the least hash.
"""
import argparse
import hashlib
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEAST_PER_FILE = 2
# The head only copies scalars.
LEFT_OUT = {"floorline_accelerator_head"}
# ap_done and ap_idle, which their instances leave open; and what is a constant as a whole, as first values and cleared fields, which are
# often free: no bench could tell.
UNSEEN = re.compile(r"finished_|run_leaves|ap_idle|= \d+'[dh][0-9a-f]+;")

# (what, pattern, replacement): one occurrence in an expression is changed.
OPERATORS = [
    ("+ for -", r" - ", " + "),
    ("- for +", r" \+ ", " - "),
    ("| for &", r" & ", " | "),
    ("& for |", r" \| ", " & "),
    ("|| for &&", r" && ", " || "),
    ("&& for ||", r" \|\| ", " && "),
    ("!= for ==", r" == ", " != "),
    ("== for !=", r" != ", " == "),
    ("<= for <", r" < (?=\d)", " <= "),  # against a constant: of two equal signals a minimum may take either
    (">= for >", r" > (?=\d)", " >= "),
    ("constant off by one", r"(?<=[0-9]'d)(\d+)", lambda match: str(int(match[1]) ^ 1)),
    ("choice the other way round", r"^((?:[^?:\[]|\[[^?:\]]*\])+) \? ([^?:]+) : ([^?:]+)$", r"\1 ? \3 : \2"),
    ("inversion lost", r"[~!](?=\w)", ""),
    ("handshake dropped", r"\b\w*(?:ready|full_n)\b", "1'b1"),
    ("handshake dropped", r"\b\w*(?:valid|empty_n)\b", "1'b1"),
    ("middle bit lost", r"^([a-z_]\w*)$", r"(\1 & ~(64'd1 << ($bits(\1) / 2)))"),
]

STATEMENTS = [
    re.compile(r"^(\s*(?:wire|assign)\b[^=]* = )(.+)(;.*)$"),
    re.compile(r"^(\s*(?:if \([^=]*\) |else )?[a-z]\w*(?:\[[^\]]*\])? <= )(.+)(;.*)$"),
    re.compile(r"^(\s*(?:else )?if \()(.+)(\)(?: begin)?)$"),
]


def places(name, lines):
    """(hash, line number, what, head, expression, mutated expression, tail) of every change that could be made in a file."""
    simulation_only = False
    for number, line in enumerate(lines):
        simulation_only = "`ifdef SIMULATION" in line or (simulation_only and "`endif" not in line)
        if simulation_only:
            continue
        code, comment = (line.split("//", 1) + [""])[:2]
        for statement in STATEMENTS:
            match = statement.match(code.rstrip())
            if not match or "$signed" in match[2] or "{" in match[1] or UNSEEN.search(code):
                continue
            head, expression, tail = match.groups()
            for what, pattern, replacement in OPERATORS:
                for occurrence in re.finditer(pattern, expression):
                    new = replacement(occurrence) if callable(replacement) else occurrence.expand(replacement)
                    mutated = expression[: occurrence.start()] + new + expression[occurrence.end() :]
                    key = hashlib.sha256(f"{name} {code.strip()} {what} {occurrence.start()}".encode()).hexdigest()
                    yield key, number, what, head, expression, mutated, tail + (" //" + comment if comment else "")
            break


def choose(files, count):
    """The least hashes: LEAST_PER_FILE of each file and what, then of all; one a line."""
    candidates = sorted((place, path) for path, lines in files.items() for place in places(path.name, lines))
    chosen, per_file, whats = {}, {}, {}
    for limit in (1, LEAST_PER_FILE, None):
        for place, path in candidates:
            where = (path, place[1])
            if len(chosen) == count:
                break
            if where in chosen or (limit and per_file.get(path, 0) >= limit):
                continue
            if limit == 1 and whats.get(place[2], 0) > count // len(OPERATORS):
                continue
            chosen[where] = place
            per_file[path] = per_file.get(path, 0) + 1
            whats[place[2]] = whats.get(place[2], 0) + 1
    return dict(sorted(chosen.items()))


def built(files):
    """The files whose modules are in floorline_top: those that it names, that these name, and so on."""
    words = {path.stem: set(re.findall(r"\w+", re.sub(r"//.*", "", "\n".join(lines)))) for path, lines in files.items()}
    found, waiting = set(), {"floorline_top"}
    while waiting:
        name = waiting.pop()
        found.add(name)
        waiting |= (words[name] & words.keys()) - found
    return {path: lines for path, lines in files.items() if path.stem in found - LEFT_OUT}


def add_port(text):
    """floorline_top with input `mutant`, registered, so that it is a constant to the logic."""
    text = text.replace("    input  wire         aclk,\n", "    input  wire         aclk,\n    input  wire [7:0]   mutant,\n", 1)
    return text.replace("    reg rst;\n", "    reg [7:0] mutant_reg;\n    always @(posedge aclk) mutant_reg <= mutant;\n\n    reg rst;\n", 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=80)
    options = parser.parse_args()
    if options.count > 255:
        sys.exit("error: --count must be at most 255, the bugs that 8 bits tell apart.")
    shutil.rmtree(options.folder, ignore_errors=True)
    paths = sorted(path for path in [*ROOT.glob("rtl/*.v"), *ROOT.glob("rtl/lib/*.v"), *ROOT.glob("rtl/generated/*.v")])
    texts = {path: path.read_text().splitlines() for path in paths}
    chosen = choose(built(texts), options.count)
    table = []
    for number, ((path, line), (_, _, what, head, expression, mutated, tail)) in enumerate(chosen.items(), 1):
        texts[path][line] = f"{head}(floorline_top.mutant_reg == 8'd{number}) ? ({mutated}) : ({expression}){tail}"
        table.append(f"{number}\t{path.relative_to(ROOT)}:{line + 1}\t{what}: {expression} -> {mutated}\n")
    for path, lines in texts.items():
        copy = options.folder / path.relative_to(ROOT / "rtl")
        copy.parent.mkdir(parents=True, exist_ok=True)
        text = "\n".join(lines) + "\n"
        copy.write_text(add_port(text) if path.name == "floorline_top.v" else text)
    (options.folder / "mutants.tsv").write_text("".join(table))


if __name__ == "__main__":
    main()
