#!/usr/bin/env bash
# The gates that Yosys makes of a small floorline_top (tb/gates) for Virtex-6 and ECP5, in Icarus with Yosys' models of the cells, on the
# frames of the cocotb bench against the C simulation, as figures. Memories and multipliers stay what they are in RTL: there are no open
# models of block RAM and DSP blocks. Usage: gate_level.sh BUILD_DIR
source "$(dirname "$0")/common.sh"

[ -x .venv/bin/python ] || fail "the project's Python packages are missing; run ./scripts/setup.sh."
build=$1
ninja -C "$build" floorline-hlsc cosim_vectors >&2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/bin/floorline-hlsc" compile tb/gates/small_accelerator.cpp --top floorline_accelerator_small --tap $(cat hls/taps.txt) -I hls --std c++11 \
    --target xc6v -o "$work/core"
# Yosys keeps the zeros with which memories start, in simulation as in an FPGA.
sed -i '/synthesis translate_o/d' "$work"/core/*.v
"$build/bin/cosim_vectors" 2 1 >"$work/vectors.json"
cells=$(dirname "$(dirname "$(command -v yosys)")")/share/yosys

# synthesise TARGET: $work/TARGET.v. The memories' mapping is left out.
synthesise() {
    local coarse fine
    case $1 in
        xc6v)
            coarse="synth_xilinx -family xc6v -nodsp -noiopad -noclkbuf -top floorline_top -run begin:map_memory"
            fine="synth_xilinx -family xc6v -nodsp -noiopad -noclkbuf -top floorline_top -run fine:"
            ;;
        ecp5)
            coarse="synth_ecp5 -nodsp -top floorline_top -run begin:map_ram"
            fine="synth_ecp5 -nodsp -top floorline_top -run map_gates:"
            ;;
    esac
    yosys -q -p "
        read_verilog -DFLOORLINE_CORE=floorline_accelerator_small rtl/*.v rtl/lib/*.v $work/core/*.v
        read_verilog -lib tb/gates/multiplier_cell.v
        chparam -set MAX_WIDTH 128 -set MAX_HEIGHT 64 -set LOG2_LINES 5 floorline_top
        hierarchy -top floorline_top; proc; flatten; opt
        techmap -map tb/gates/multiplier_map.v
        $coarse
        opt -fast -full
        $fine
        write_verilog -noattr $work/$1.v" >"$work/$1.log" || fail "Yosys failed; its message is above."
}

# Of the numbers it reads; nothing when there are none.
sum() { awk '{ total += $1 } END { if (NR) print total }'; }

# simulate TARGET MODELS: the figures.
simulate() {
    TESTCASE=frames_back_to_back .venv/bin/python tb/cocotb/run.py "$work/$1" "$work/vectors.json" "$work/$1.v" tb/gates/multiplier_cell.v "$cells/$2" >"$work/$1.log" 2>&1 || true
    local frames bits
    frames=$(sed -n 's/^differing bits: [0-9]* in \([0-9]*\) frames/\1/p' "$work/$1.log" | sum)
    bits=$(sed -n 's/^differing bits: \([0-9]*\) .*/\1/p' "$work/$1.log" | sum)
    [ -n "$bits" ] || tail -40 "$work/$1.log" >&2
    figure "cosim.gate_level_frames.$1" "${frames:-none}" '>=' 2
    figure "cosim.gate_level_differences.$1" "${bits:-none}" '<=' 0
}

synthesise ecp5 &
synthesise xc6v
wait $! || fail "Yosys failed; its message is above."
simulate xc6v xilinx/cells_sim.v
simulate ecp5 ecp5/cells_sim.v
