# Vivado IP packager: floorline_top as an IP for block designs, under out/vivado_ip.
#   vivado -mode batch -source scripts/vendor/vivado_ip.tcl
source [file join [file dirname [info script]] files.tcl]

set out [out_dir vivado_ip]
file mkdir $out

create_project -force -part xc7a200tsbg484-1 floorline_ip [file join $out project]
add_files [verilog_sources]
set_property top floorline_top [current_fileset]
ipx::package_project -root_dir [file join $out ip] -vendor floorline -library video -taxonomy /UserIP -import_files
set core [ipx::current_core]
set_property name floorline_top $core
set_property display_name {Floorline obstacle detection} $core
foreach bus {s_axis_video m_axis_points m_axis_obstacles m_axis_counts s_axil} {
    ipx::associate_bus_interfaces -busif $bus -clock aclk $core
}
ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
close_project
