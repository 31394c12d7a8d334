"""The accelerator's Verilog for a target and a frame size: what rtl/generated has, or compiled by floorline-hlsc from hls/accelerator.cpp.

rtl/generated is the committed text, scheduled for Virtex-6 at 100 MHz; it also serves 7-series. An ECP5 is slower and has other blocks: its
text comes from the same C++, but with that FPGA's delays, into build/synth/generated. --strict: a loop that loses its II is an error.
"""

import functools
import pathlib
import re
import subprocess

from common import ROOT, fail

COMPILER = ROOT / "build/release/bin/floorline-hlsc"
FOLDER = ROOT / "build/synth/generated"
VGA = (640, 480)
CONFIGURATION = "floorline::VgaConfig"
# What the compiler is told: a family whose delays it knows, and the period in ns that it schedules for.
SCHEDULE = {"xc6v": ("xc6v", "10"), "xc7": ("xc6v", "10"), "ecp5": ("ecp5", "8")}


def configuration(width, height):
    """The AcceleratorConfig of a size: VGA's lines, and rows of the frame ring beyond a frame's in VGA's proportion."""
    text = (ROOT / "hls/accelerator.h").read_text()
    vga = re.search(r"typedef AcceleratorConfig<(\d+), (\d+), (\d+), (\d+)> VgaConfig;", text)
    if vga is None:
        fail("hls/accelerator.h no longer defines VgaConfig as an AcceleratorConfig of four numbers; see scripts/synth/compiled.py.")
    _, rows, margin, lines = map(int, vga.groups())
    return f"floorline::AcceleratorConfig<{width}, {height}, {margin * height // rows}, {lines}>"


def source(size, folder):
    """hls/accelerator.cpp, or for another size than VGA its copy in `folder` with that configuration."""
    shipped = ROOT / "hls/accelerator.cpp"
    if size == VGA:
        return shipped
    text = shipped.read_text()
    if CONFIGURATION not in text:
        fail(f"hls/accelerator.cpp no longer names {CONFIGURATION}; scripts/synth/compiled.py puts another size in its place.")
    folder.mkdir(parents=True, exist_ok=True)
    copy = folder / "accelerator.cpp"
    copy.write_text(text.replace(CONFIGURATION, configuration(*size)))
    return copy


@functools.lru_cache
def compile_source(source, top, target, folder, options=()):
    """Verilog of `source` in `folder`/rtl, which is returned relative to the root."""
    family, period = SCHEDULE[target]
    if not COMPILER.exists():
        fail("the compiler is not built; run 'cmake --preset release' and 'ninja -C build/release floorline-hlsc'.")
    done = subprocess.run([COMPILER, "compile", source, "--top", top, *options, "-I", ROOT / "hls", "--std", "c++11", "--target", family,
                           "--clock", period, "--strict", "-o", folder / "rtl", "--report", folder / "report"],
                          cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        fail(f"the compiler refuses {source} for {target}: {done.stderr.strip()}")
    return str((folder / "rtl").relative_to(ROOT))


def accelerator(target, size):
    """The folder of the accelerator's Verilog, relative to the root."""
    family = SCHEDULE[target][0]
    if size == VGA and family == "xc6v":
        return "rtl/generated"
    folder = FOLDER / f"{family}-{size[0]}x{size[1]}"
    taps = (ROOT / "hls/taps.txt").read_text().split()
    return compile_source(source(size, folder), "floorline_accelerator", target, folder, ("--tap", *taps))


def located(pattern, target, size):
    """A pattern of designs.yaml: with the folder of the accelerator's Verilog in the place of GENERATED; of a C++ file, the Verilog of the
    function that is called as the file is."""
    if "GENERATED" in pattern:
        return pattern.replace("GENERATED", accelerator(target, size))
    kernel = pathlib.Path(pattern)
    if kernel.suffix == ".cpp":
        return compile_source(kernel, kernel.stem, target, FOLDER / f"{SCHEDULE[target][0]}-{kernel.stem}") + "/*.v"
    return pattern
