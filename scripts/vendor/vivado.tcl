# Vivado, 7-series, non-project mode: floorline_top placed and routed out of context, with its reports.
#   vivado -mode batch -source scripts/vendor/vivado.tcl
source [file join [file dirname [info script]] files.tcl]

set part xc7a200tsbg484-1
set out [out_dir vivado]
file mkdir $out

read_verilog [verilog_sources]
read_xdc -mode out_of_context [constraints_file floorline_top.xdc]
synth_design -top floorline_top -part $part -mode out_of_context
opt_design
place_design
phys_opt_design
route_design
report_utilization -hierarchical -file [file join $out utilization.txt]
report_timing_summary -file [file join $out timing.txt]
report_power -file [file join $out power.txt]
write_checkpoint -force [file join $out floorline_top.dcp]
