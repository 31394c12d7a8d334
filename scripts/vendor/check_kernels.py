"""Checks that kernels use only what the oldest HLS tool of docs/handoff.md accepts, Vivado HLS 2015.4: C++11 as far as its compilers have it
(GCC 4.6 for C simulation, an early Clang for synthesis), without what cannot become hardware (UG902, "Unsupported C Constructs").

usage: check_kernels.py INCLUDE_DIR FILE... ; .h and .cpp files, read together by clang-19, whose syntax tree is walked. Checked is what
belongs to the namespace floorline or has it in its name; the vendor's own headers take the place of hls/compat.
"""

import json
import pathlib
import re
import subprocess
import sys

CLANG = "clang-19"

# Nodes of the tree that are refused, and why.
NODES = {
    "LambdaExpr": "a lambda; write a function",
    "CXXNewExpr": "'new'; hardware has no heap",
    "CXXDeleteExpr": "'delete'; hardware has no heap",
    "CXXThrowExpr": "'throw'; hardware has no exceptions",
    "CXXTryStmt": "'try'; hardware has no exceptions",
    "CXXDynamicCastExpr": "'dynamic_cast'; the type must be known when compiling",
    "CXXTypeidExpr": "'typeid'; the type must be known when compiling",
    "CXXReinterpretCastExpr": "'reinterpret_cast'; pointers cannot be cast",
    "VAArgExpr": "variable arguments; give each argument a name",
    "GCCAsmStmt": "assembler",
    "GotoStmt": "'goto'; write a loop",
    "IndirectGotoStmt": "'goto'; write a loop",
    "TypeAliasDecl": "an alias with 'using', which GCC 4.6 lacks; write a typedef",
    "TypeAliasTemplateDecl": "an alias template, which GCC 4.6 lacks; write a struct with a typedef in it",
    "UserDefinedLiteral": "a user-defined literal, which GCC 4.6 lacks",
    "CXXInheritedCtorInitExpr": "an inherited constructor, which GCC 4.6 lacks",
    "AlignedAttr": "'alignas', which GCC 4.6 lacks",
    "OverrideAttr": "'override': virtual functions cannot become hardware",
    "FinalAttr": "'final', which GCC 4.6 lacks",
}
SYSTEM = re.compile(r"malloc|calloc|realloc|free|v?f?printf|puts|putchar|f?scanf|fopen|fclose|fread|fwrite|abort|exit|rand|srand|time|clock|getenv")
# Pragmas of UG902 for 2015.4. AGGREGATE is newer: the old tools ignore it with a warning, and vivado_hls.tcl gives them DATA_PACK instead.
PRAGMAS = set("ALLOCATION ARRAY_MAP ARRAY_PARTITION ARRAY_RESHAPE DATA_PACK DATAFLOW DEPENDENCE EXPRESSION_BALANCE FUNCTION_INSTANTIATE INLINE "
              "INTERFACE LATENCY LOOP_FLATTEN LOOP_MERGE LOOP_TRIPCOUNT OCCURRENCE PIPELINE PROTOCOL RESET RESOURCE STREAM TOP UNROLL AGGREGATE".split())

FUNCTIONS = ("FunctionDecl", "CXXMethodDecl", "CXXConstructorDecl", "CXXConversionDecl")


def syntax_trees(include, files):
    """The top nodes that belong to floorline, of all files read as one."""
    unit = "".join(f'#include "{pathlib.Path(file).resolve()}"\n' for file in files)
    command = [CLANG, "-x", "c++", "-std=c++11", "-w", f"-I{include}", f"-I{include}/compat", "-fsyntax-only", "-Xclang", "-ast-dump=json",
               "-Xclang", "-ast-dump-filter=floorline", "-"]
    done = subprocess.run(command, input=unit, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{done.stderr}error: {CLANG} does not accept the kernels as C++11; see above.")
    decoder, at = json.JSONDecoder(), 0
    while at < len(done.stdout):
        node, at = decoder.raw_decode(done.stdout, at)
        yield node
        while at < len(done.stdout) and done.stdout[at].isspace():
            at += 1


class Walk:
    """Walks a tree in the order in which clang printed it, as a place tells its file and line only where they change."""

    def __init__(self):
        self.file, self.line = "", 0
        self.faults = {}   # {(file, line, sentence)}, a dict for its order
        self.functions = []  # ids of the functions around the node
        self.first = {}    # {id of a declaration: id of the first one of the same function}
        self.names = {}    # {id: name of a function}
        self.calls = {}    # {id: {ids of what it calls}}

    def refuse(self, sentence):
        self.faults[(self.file, self.line, sentence)] = None

    def place(self, value):
        if isinstance(value, dict):
            self.file = value.get("file", self.file)
            self.line = value.get("line", self.line)
            for key, part in value.items():
                if key != "includedFrom":
                    self.place(part)

    def node(self, node):
        self.place(node.get("loc"))
        self.place(node.get("range", {}).get("begin"))
        self.check(node)
        self.place(node.get("range", {}).get("end"))
        function = node.get("kind") in FUNCTIONS
        if function:
            before = node.get("previousDecl")
            self.first[node["id"]] = self.first.get(before, before) or node["id"]
            self.functions.append(self.first[node["id"]])
            self.names[self.functions[-1]] = node.get("name", "")
        for child in node.get("inner", []):
            self.node(child)
        if function:
            self.functions.pop()

    def check(self, node):
        kind = node.get("kind", "")
        if node.get("isImplicit"):
            return
        if kind in NODES:
            self.refuse(NODES[kind])
        if kind == "FieldDecl" and node.get("hasInClassInitializer"):
            self.refuse("an initialiser in the class, which GCC 4.6 lacks; write a constructor")
        if kind == "VarDecl" and node.get("tls"):
            self.refuse("'thread_local', which GCC 4.6 lacks")
        if node.get("virtual") or node.get("pure"):
            self.refuse("a virtual function; the call must be known when compiling")
        if node.get("tagUsed") == "union":
            self.refuse("a union; use ranges of bits")
        if kind.endswith("Decl") and kind not in ("CXXRecordDecl", "NamespaceDecl"):
            declared = node.get("type", {}).get("qualType", "")
            if re.search(r"\(\*\w*\)\s*\(", declared):
                self.refuse("a pointer to a function; the call must be known when compiling")
            if re.search(r"\bstd::", declared):
                self.refuse("the C++ standard library")
        self.reference(node.get("referencedDecl"))
        self.reference({"id": node["referencedMemberDecl"]} if "referencedMemberDecl" in node else None)

    def reference(self, target):
        if not target:
            return
        if target.get("kind") == "FunctionDecl" and SYSTEM.fullmatch(target.get("name", "")):
            self.refuse(f"a call of the system, '{target['name']}'")
        if self.functions:
            self.calls.setdefault(self.functions[-1], set()).add(self.first.get(target["id"], target["id"]))

    def recursive(self):
        """Names of the functions that can reach themselves."""

        def reached(start):
            seen, open_ = set(), [start]
            while open_:
                for callee in self.calls.get(open_.pop(), ()):
                    if callee in self.names and callee not in seen:
                        seen.add(callee)
                        open_.append(callee)
            return seen

        return sorted({self.names[id_] for id_ in self.names if id_ in reached(id_)})


def pragma_faults(file):
    for number, line in enumerate(pathlib.Path(file).read_text().splitlines(), 1):
        match = re.match(r"\s*#\s*pragma\s+HLS\s+(\w+)", line, re.IGNORECASE)
        if match and match.group(1).upper() not in PRAGMAS:
            yield f"{file}:{number}: pragma {match.group(1)}, which Vivado HLS 2015.4 does not know"


def faults(include, files):
    """A sentence for each construct that is refused."""
    walk = Walk()
    for tree in syntax_trees(include, files):
        walk.node(tree)
    found = [f"{file}:{line}: {sentence}" for file, line, sentence in walk.faults]
    found += [f"recursion of '{name}'; hardware has no stack" for name in walk.recursive()]
    for file in files:
        found += pragma_faults(file)
    return found


def main():
    if len(sys.argv) < 3:
        sys.exit(f"error: {__doc__}")
    found = faults(sys.argv[1], sys.argv[2:])
    if found:
        sys.exit("\n".join(found) + "\nerror: Vivado HLS 2015.4 does not accept the above; see docs/handoff.md.")


if __name__ == "__main__":
    main()
