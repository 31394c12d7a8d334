"""Tests of what turns the tools' output into our figures; no tool runs."""

import pathlib
import tempfile
import unittest

import baseline
import flow
import pack
import power
import report
import shell
import sweep
import tables


class Report(unittest.TestCase):
    def test_module_name_drops_what_yosys_puts_before_it(self):
        self.assertEqual(report.module_name("$paramod$0123abcd\\fifo"), "fifo")
        self.assertEqual(report.module_name("$paramod\\fifo\\WIDTH=s32'1"), "fifo")
        self.assertEqual(report.module_name("polar"), "polar")

    def test_critical_path_joins_cells_of_a_name_and_finds_its_source(self):
        with tempfile.TemporaryDirectory() as folder:
            verilog = pathlib.Path(folder) / "polar.v"
            verilog.write_text("    wire [8:0] sum_7 = a + b;  // polar.h:101\n")
            namesake = pathlib.Path(folder) / "binarize.v"
            namesake.write_text("    wire [8:0] sum_7 = a + b;  // binarize.h:34\n    wire stall = c;  // binarize.h:35\n")
            path = [{"delay": 0.5, "from": {"cell": "design.core.polar.sum_7_s1_TRELLIS_FF_Q_4"}},
                    {"delay": 1.0, "from": {"cell": "design.core.polar.sum_7_s1_TRELLIS_FF_Q_4"}},
                    {"delay": 2.0, "from": {"cell": "design.core.stall_LUT4_A_Z"}}]
            steps = report.critical_path({"critical_paths": [
                {"from": "posedge clk", "to": "posedge clk", "path": path[:1]}, {"from": "posedge clk", "to": "posedge clk", "path": path},
                {"from": "<async>", "to": "posedge clk", "path": path + path}]}, [namesake, verilog])
        self.assertEqual(steps, [{"at": "design.core.polar.sum_7_s1", "source": "polar.h:101", "ns": 1.5},
                                 {"at": "design.core.stall", "source": "", "ns": 3.5}])


class Parts(unittest.TestCase):
    def test_a_part_has_all_that_is_in_it(self):
        modules = {"top": {"LUT2": 3, "core": 1, "\\guard": 1}, "core": {"FDRE": 1, "polar": 1, "fifo": 2}, "polar": {"LUT6": 5, "fifo": 1},
                   "fifo": {"RAM32M": 1, "FDRE": 2}, "\\guard": {"LUT1": 1}}
        rows = {row["module"]: row for row in flow.parts(modules, flow.XILINX, "top", ["core"])}
        self.assertEqual((rows["polar"]["lut"], rows["polar"]["ff"]), (9, 2))
        self.assertEqual((rows["fifo"]["instances"], rows["fifo"]["lut"]), (2, 8))
        self.assertEqual((rows["top"]["lut"], rows["core"]["ff"]), (3, 1))

    def test_stat_of_old_yosys_has_lines_that_are_no_json(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "stat.json"
            file.write_text('{"modules": {"\\\\top": {"num_cells_by_type": {"LUT2": 3}}}\n   fifo    2\n}')
            self.assertEqual(flow.read_stat(file), {"top": {"LUT2": 3}})


class Shell(unittest.TestCase):
    def test_every_port_is_connected(self):
        ports = {"clk": {"direction": "input", "bits": [2]}, "a": {"direction": "input", "bits": [3, 4]},
                 "b": {"direction": "output", "bits": list(range(20))}}
        text = shell.verilog("design_top", ports)
        self.assertIn("design_top design (.clk(clk), .a(feed[1:0]), .b(result[19:0]));", text)
        self.assertIn("fold[1] <= ^captured[19:16];", text)


class Pack(unittest.TestCase):
    """A block RAM whose output bits 2 and 3 go to flip-flops 12 and 13 with the enable 5."""

    def module(self):
        def flip_flop(data, output, mux="CE"):
            return {"type": "TRELLIS_FF", "parameters": {"CEMUX": mux, "CLKMUX": "CLK", "REGSET": "RESET"},
                    "port_directions": {"CLK": "input", "CE": "input", "LSR": "input", "DI": "input", "Q": "output"},
                    "connections": {"CLK": [1], "CE": [5], "LSR": ["0"], "DI": [data], "Q": [output]}}

        ram = {"type": "DP16KD", "parameters": {"REGMODE_B": "NOREG"}, "port_directions": {"CLKB": "input", "OCEB": "input", "DOB0": "output", "DOB1": "output"},
               "connections": {"CLKB": [1], "OCEB": ["1"], "DOB0": [2], "DOB1": [3]}}
        return {"ports": {"out": {"direction": "output", "bits": [12, 13]}}, "cells": {"ram": ram, "low": flip_flop(2, 12), "high": flip_flop(3, 13)}}

    def test_a_block_takes_the_registers_behind_it(self):
        module = self.module()
        self.assertEqual(pack.pack(module), 2)
        self.assertEqual(list(module["cells"]), ["ram"])
        ram = module["cells"]["ram"]
        self.assertEqual(ram["parameters"]["REGMODE_B"], "OUTREG")
        self.assertEqual(ram["connections"], {"CLKB": [1], "OCEB": [5], "DOB0": [12], "DOB1": [13]})

    def test_an_inverted_enable_is_inverted_once(self):
        module = self.module()
        for name in ("low", "high"):
            module["cells"][name]["parameters"]["CEMUX"] = "INV"
        self.assertEqual(pack.pack(module), 2)
        inverter = module["cells"]["complement_5"]["connections"]
        self.assertEqual((inverter["A"], inverter["Z"]), ([5], module["cells"]["ram"]["connections"]["OCEB"]))

    def test_what_is_read_elsewhere_or_differs_stays(self):
        def read_elsewhere(module):
            module["ports"]["out"]["bits"].append(3)

        def with_reset(module):
            module["cells"]["low"]["connections"]["LSR"] = [6]

        def other_enable(module):
            module["cells"]["low"]["connections"]["CE"] = [7]

        def other_clock(module):
            module["cells"]["ram"]["connections"]["CLKB"] = [8]

        for change in (read_elsewhere, with_reset, other_enable, other_clock):
            module = self.module()
            change(module)
            self.assertEqual(pack.pack(module), 0, change.__name__)
            self.assertEqual(len(module["cells"]), 3)


class Baseline(unittest.TestCase):
    def test_growth_is_a_share(self):
        self.assertAlmostEqual(baseline.growth(100, 103), 0.03)
        self.assertEqual(baseline.growth(0, 0), 0)


class Sweep(unittest.TestCase):
    def test_smallest_device_of_each_family(self):
        small = {"total": {"lut": 9000, "bram": 92, "dsp": 35}}
        self.assertTrue(sweep.smallest({"xc6v": small, "ecp5": None}).startswith("xc6vlx75t, xc7a100t, xc7z020"))
        none = {"total": {"lut": 10**9, "bram": 1, "dsp": 1}}
        self.assertIn("none", sweep.smallest({"xc6v": none, "ecp5": none}))


class Power(unittest.TestCase):
    def test_coverage_is_the_mean_by_module_of_the_core(self):
        def point(name, instance, count, module="polar"):
            fields = {"page": f"v_toggle/{module}", "o": name, "h": instance}
            return "C '" + "".join(f"\x01{key}\x02{value}" for key, value in fields.items()) + f"' {count}\n"

        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "coverage.dat"
            file.write_text(point("a[0]", power.CORE + "polar", 50) + point("b", power.CORE + "polar.ram", 10, "ram_1r1w")
                            + point("clk", power.CORE + "polar", 200) + point("c", "TOP.demonstration", 5, "demonstration")
                            + point("d", power.CORE + "a_fifo", 10, "fifo__W21_D2") + point("d", power.CORE + "b_fifo", 30, "fifo"))
            self.assertEqual(power.read_coverage(file, 100), {"fifo": 0.2, "other": 0.05, "polar": 0.3})

    def test_estimate_is_linear_in_the_activity(self):
        parts = [{"module": "polar", "lut": 1000, "ff": 500, "bram": 2, "dsp": 1}]
        coefficient = {"fabric_pj_per_change": 1, "fabric_factor": 2, "clock_share": 0.5, "clock_factor": 2, "bram_pj_per_cycle": 10,
                       "bram_factor": 2, "dsp_pj_per_cycle": 10, "dsp_factor": 2, "static_w": 1, "static_factor": 2}
        sources = power.estimate(parts, {"polar": 0.1, "other": 0.5}, coefficient)
        self.assertAlmostEqual(sources["LUTs, registers, wires"][0], 150 * power.CLOCK_MHZ * 1e-6)
        self.assertAlmostEqual(sources["clock network"][0], 75 * power.CLOCK_MHZ * 1e-6)
        self.assertAlmostEqual(sources["DSP"][0], power.CLOCK_MHZ * 1e-6)


class Tables(unittest.TestCase):
    def test_only_what_stands_between_markers_is_renewed(self):
        tables.TABLES["sample"] = lambda: {"note": "Note.", "columns": ["a", "b"], "rows": [["x", 1]]}
        before = "text\n<!-- table sample: who -->\nold\n<!-- end -->\nmore"
        after = tables.filled(before, "file")
        self.assertIn("| x | 1 |", after)
        self.assertTrue(after.startswith("text\n") and after.endswith("<!-- end -->\nmore"))
        self.assertEqual(tables.filled(after, "file"), after)

    def test_ratio(self):
        self.assertEqual(tables.ratio(50, 100), "0.50")
        self.assertEqual(tables.ratio(None, 100), "-")
        self.assertEqual(tables.ratio(5, None), "-")


if __name__ == "__main__":
    unittest.main()
