# Vitis HLS, 7-series and later: C simulation, synthesis, co-simulation and export of the accelerator.
#   vitis_hls -f scripts/vendor/vitis_hls.tcl
source [file join [file dirname [info script]] files.tcl]

file mkdir [out_dir vitis_hls]
cd [out_dir vitis_hls]
open_project -reset floorline
set_top $kernel_top
foreach source [kernel_sources] { add_files $source -cflags [kernel_flags] }
add_files -tb [kernel_testbench] -cflags [kernel_flags]

open_solution -reset artix7 -flow_target vivado
set_part {xc7a200tsbg484-1}
create_clock -period 6.25 -name default
csim_design
csynth_design
cosim_design -rtl verilog
export_design -format ip_catalog
exit
