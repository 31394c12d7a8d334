# Vivado HLS 2015.4 to 2019.1, Virtex-6: C simulation, synthesis, co-simulation and export of the accelerator.
#   vivado_hls -f scripts/vendor/vivado_hls.tcl
source [file join [file dirname [info script]] files.tcl]

file mkdir [out_dir vivado_hls]
cd [out_dir vivado_hls]
open_project -reset floorline
set_top $kernel_top
foreach source [kernel_sources] { add_files $source -cflags [kernel_flags] }
add_files -tb [kernel_testbench] -cflags [kernel_flags]

open_solution -reset virtex6
set_part {xc6vlx240tff1156-1}
create_clock -period 10 -name default
# DATA_PACK is this tool's name for AGGREGATE. A stream of structs would become a port for each member; one word carries them all, packed from
# bit 0. So does a word of the line table.
foreach port {points obstacles counts lines} { set_directive_data_pack $kernel_top $port }
foreach array [aggregated_arrays] { set_directive_data_pack {*}$array }
csim_design
csynth_design
cosim_design -rtl verilog
export_design -format pcore
exit
