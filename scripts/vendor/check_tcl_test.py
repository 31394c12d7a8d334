"""Spoils the vendors' scripts in one place each and expects check.tcl to refuse them."""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

SPOILED = [  # script, text, what comes in its place, a part of the sentence
    ("vivado_hls.tcl", "set_top $kernel_top\n", "", "comes before set_top"),
    ("vivado_hls.tcl", "csynth_design\ncosim_design", "cosim_design", "comes before csynth_design"),
    ("vivado_hls.tcl", "-format pcore", "-format zip", "'zip', which is not"),
    ("vivado_hls.tcl", "xc6vlx240tff1156-1", "xc7a200tsbg484-1", "which is not xc6v"),
    ("vivado_hls.tcl", "create_clock -period 10", "create_clock -period fast", "'fast', which is not"),
    ("vivado_hls.tcl", "set_directive_data_pack $kernel_top $port", "set_directive_data_pack $port", "takes 2 arguments"),
    ("vivado_hls.tcl", "open_solution", "open_solutions", "invalid command name"),
    ("vitis_hls.tcl", "add_files -tb", "add_files -tb missing.cpp", "missing.cpp, which does not exist"),
    ("ise.tcl", "[constraints_file ml605.ucf]", "[constraints_file ml606.ucf]", "ml606.ucf, which does not exist"),
    ("ise.tcl", 'project set speed "-1"', "project set speed", "takes a property and a value"),
    ("ise.tcl", "process run", "#", "never calls process run"),
    ("vivado.tcl", "place_design\n", "", "comes before place_design"),
    ("vivado.tcl", "opt_design\n", "opt_design everything\n", "takes 0 arguments"),
    ("vivado_ip.tcl", "ipx::save_core $core\n", "", "never calls ipx::save_core"),
]


def main():
    with tempfile.TemporaryDirectory() as folder:
        checkout = pathlib.Path(folder)
        vendor = checkout / "scripts/vendor"
        vendor.mkdir(parents=True)
        for name in ("hls", "rtl", "constraints"):
            (checkout / name).symlink_to(ROOT / name)
        for file in HERE.iterdir():
            if file.suffix in (".tcl", ".cpp"):
                (vendor / file.name).write_text(file.read_text())
        for script, text, spoiled, part in SPOILED:
            whole = (HERE / script).read_text()
            if whole.count(text) < 1:
                sys.exit(f"error: {script} no longer has '{text.strip()}'; spoil something else.")
            (vendor / script).write_text(whole.replace(text, spoiled, 1))
            done = subprocess.run(["tclsh", vendor / "check.tcl", vendor / script], capture_output=True, text=True)
            (vendor / script).write_text(whole)
            if done.returncode == 0 or part not in done.stderr:
                sys.exit(f"error: {script} with '{spoiled.strip()}' for '{text.strip()}' was to be refused with '{part}' and gave:\n{done.stderr}")


if __name__ == "__main__":
    main()
