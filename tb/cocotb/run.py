"""Builds floorline_top with Icarus and runs floorline_top_test.py. Usage: run.py BUILD_FOLDER VECTORS.json [SOURCE...] (rtl/)"""
import pathlib
import sys

from cocotb.runner import get_results, get_runner

build, vectors, *sources = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
rtl = pathlib.Path(__file__).resolve().parents[2] / "rtl"
if not sources:
    sources = [path for folder in (rtl, rtl / "lib", rtl / "generated") for path in sorted(folder.glob("*.v"))]
runner = get_runner("icarus")
runner.build(
    verilog_sources=[str(path) for path in sources],
    hdl_toplevel="floorline_top",
    build_dir=build,
    timescale=("1ns", "1ps"),
    always=True,
)
results = runner.test(
    hdl_toplevel="floorline_top",
    test_module="floorline_top_test",
    test_dir=pathlib.Path(__file__).parent,
    build_dir=build,
    results_xml=str(build / "results.xml"),
    extra_env={"FLOORLINE_VECTORS": str(vectors)},
)
tests, failures = get_results(results)
print(f"{tests} tests, {failures} failures")
sys.exit(1 if failures or not tests else 0)
