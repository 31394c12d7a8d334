"""Checks that Verilog keeps to what XST of ISE 14.7 reads: Verilog-2001 without SystemVerilog, and of system functions and simulation
constructs only what UG687 tells as supported in synthesis.

usage: check_verilog.py FILE...
"""

import pathlib
import re
import sys

# What is refused, as it looks in the text without comments and strings, and why.
REFUSED = {
    r"\b(logic|bit|byte|shortint|int|longint|struct|union|enum|typedef|interface|modport|package|import|unique|priority|always_ff|always_comb|"
    r"always_latch|assert|assume|cover|property|inside|foreach|endinterface|endpackage)\b(?!\s*=)": "'{}' is SystemVerilog",
    r"(\+\+|--|\+=|-=|\*=|/=(?!=)|&=|\|=(?!=)|\^=|<<=(?=\s*\d*;)|>>=)": "'{}' is SystemVerilog",
    r"(?<![\w'])'([01xz])(?!\w)": "'{}' without a width is SystemVerilog",
    r"('\{)": "the pattern {} is SystemVerilog",
    r"(\.\*)": "the implicit connection {} is SystemVerilog",
    r"(\$(?!signed\b|unsigned\b|readmemh\b|readmemb\b)\w+)": "'{}' is not for XST",
    r"\b(initial|fork|force|release|deassign|wait|forever|disable|event|real|time|realtime|casex)\b": "'{}' is not for synthesis with XST",
    r"(#\s*\d)": "a delay, {}, is not for synthesis",
}


# The form in which UG687 gives a memory its first contents.
CONTENTS = r"\binitial\s+begin\s*(?:\w+\[\d+\]\s*=\s*\d+'[bdh][0-9a-fA-F]+;\s*)+end\b"


def plain(text):
    """The text without comments, strings, contents of memories and what only simulation reads, with its lines kept."""

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))

    text = re.sub(r"// synthesis translate_off\b.*?// synthesis translate_on\b", blank, text, flags=re.DOTALL)
    text = re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\n])*\"", blank, text, flags=re.DOTALL)
    return re.sub(rf"`(?:ifdef\s+SIMULATION|ifndef\s+SYNTHESIS)\b.*?`endif|{CONTENTS}", blank, text, flags=re.DOTALL)


def faults(text):
    """[(line, sentence)] of a file's text."""
    text = plain(text)
    return sorted((text.count("\n", 0, match.start()) + 1, sentence.format(match.group(1)))
                  for pattern, sentence in REFUSED.items() for match in re.finditer(pattern, text))


def main():
    if len(sys.argv) < 2:
        sys.exit(f"error: {__doc__}")
    found = [f"{file}:{line}: {sentence}" for file in sys.argv[1:] for line, sentence in faults(pathlib.Path(file).read_text())]
    if found:
        sys.exit("\n".join(found) + "\nerror: XST does not read the above; write it in Verilog-2001.")


if __name__ == "__main__":
    main()
