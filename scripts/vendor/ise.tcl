# ISE 14.7, Virtex-6: floorline_ml605 (the demonstration on the ML605 board) from Verilog to a bitstream.
#   xtclsh scripts/vendor/ise.tcl
source [file join [file dirname [info script]] files.tcl]

file mkdir [out_dir ise]
cd [out_dir ise]
if {[file exists floorline.xise]} { file delete floorline.xise }
project new floorline.xise
project set family "Virtex6"
project set device "xc6vlx240t"
project set package "ff1156"
project set speed "-1"
project set top_level_module_type "HDL"
project set synthesis_tool "XST (VHDL/Verilog)"

foreach file [verilog_sources] { xfile add $file }
foreach file [board_sources] { xfile add $file }
xfile add [constraints_file ml605.ucf]
project set top floorline_ml605

project set "Optimization Goal" "Speed" -process "Synthesize - XST"
project set "Optimization Effort" "High" -process "Synthesize - XST"
project set "Verilog Macros" "SYNTHESIS" -process "Synthesize - XST"
project set "Register Balancing" "No" -process "Synthesize - XST"
project set "Shift Register Extraction" true -process "Synthesize - XST"
project set "RAM Extraction" true -process "Synthesize - XST"
project set "Automatic BRAM Packing" true -process "Synthesize - XST"
project set "Use DSP Block" "Auto" -process "Synthesize - XST"

process run "Generate Programming File"
project close
