"""Gives check_pins.py constraints with a wrong name and with a pin too few, in each of the three languages."""

import pathlib
import sys
import tempfile

import check_pins

PORTS = {"clk": 1, "led": 2}
CASES = [  # file, text, a part of the sentence, '' for good constraints
    ("good.ucf", 'NET "clk" LOC = "U23";\nNET "led[0]" LOC = "A1";\nNET "led[1]" LOC = "A2";', ""),
    ("wrong.ucf", 'NET "clock" LOC = "U23";\nNET "led[0]" LOC = "A1";\nNET "led[1]" LOC = "A2";', "names clock"),
    ("few.ucf", 'NET "clk" LOC = "U23";\nNET "led[0]" LOC = "A1";', "no pin to led[1]"),
    ("good.lpf", 'LOCATE COMP "clk" SITE "G2";\nFREQUENCY PORT "clk" 25 MHZ;\nLOCATE COMP "led[0]" SITE "B2";\nLOCATE COMP "led[1]" SITE "C2";', ""),
    ("wrong.lpf", 'LOCATE COMP "clk" SITE "G2";\nFREQUENCY PORT "clk25" 25 MHZ;\nLOCATE COMP "led[0]" SITE "B2";\nLOCATE COMP "led[1]" SITE "C2";',
     "names clk25"),
    ("good.xdc", "create_clock -period 6 [get_ports clk]\nset_output_delay 1 [get_ports {l* clk}]", ""),
    ("wrong.xdc", "create_clock -period 6 [get_ports aclk]", "names aclk"),
]


def main():
    with tempfile.TemporaryDirectory() as folder:
        for name, text, part in CASES:
            constraints = pathlib.Path(folder) / name
            constraints.write_text(text)
            found = " ".join(check_pins.faults(constraints, PORTS, "top"))
            if (part not in found) if part else found:
                sys.exit(f"error: {name} was to give '{part}' and gave '{found}'.")


if __name__ == "__main__":
    main()
