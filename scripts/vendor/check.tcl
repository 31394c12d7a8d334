# Runs a vendor script in plain tclsh against mocks of the vendor's commands, as far as that goes without the tools: each command must
# be known, come in its order, and name files that exist.
#   tclsh scripts/vendor/check.tcl SCRIPT
set script [file normalize [lindex $argv 0]]
set calls {}

proc reject {message} {
    global script
    puts stderr "error: [file tail $script]: $message"
    exit 1
}

proc called {name} { global calls; lappend calls $name }

proc need {name earlier} {
    global calls
    foreach command $earlier {
        if {[lsearch -exact $calls $command] < 0} { reject "$name comes before $command" }
    }
}

proc need_files {name files} {
    if {[llength $files] == 0} { reject "$name is given no file" }
    foreach file $files {
        if {![file isfile $file]} { reject "$name names $file, which does not exist" }
    }
}

# Positional arguments: drops options, and the values of those listed in with_value.
proc positional {arguments with_value} {
    set rest {}
    for {set i 0} {$i < [llength $arguments]} {incr i} {
        set word [lindex $arguments $i]
        if {[lsearch -exact $with_value $word] >= 0} { incr i; continue }
        if {[string match -* $word]} { continue }
        lappend rest $word
    }
    return $rest
}

# command NAME NEEDS WITH_VALUE COUNT : a mock that takes COUNT positional arguments (at least that many with a +).
proc command {name earlier {with_value {}} {count 0}} {
    proc ::$name {args} [string map [list NAME $name EARLIER $earlier WITH $with_value COUNT $count] {
        need {NAME} {EARLIER}
        set given [llength [positional $args {WITH}]]
        set wanted {COUNT}
        if {[string match *+ $wanted] ? $given < [string trimright $wanted +] : $given != $wanted} {
            reject "NAME takes $wanted arguments and is given $given: $args"
        }
        called {NAME}
        return {NAME}
    }]
}

# command_files NAME NEEDS WITH_VALUE : a mock whose positional arguments are files.
proc command_files {name earlier {with_value {}}} {
    proc ::$name {args} [string map [list NAME $name EARLIER $earlier WITH $with_value] {
        need {NAME} {EARLIER}
        need_files {NAME} [concat {*}[positional $args {WITH}]]
        called {NAME}
    }]
}

# need_value NAME ARGUMENTS OPTION PATTERN : the option's value, or with {} the first argument, must match the regular expression.
proc need_value {name arguments option pattern} {
    set at [expr {$option eq {} ? 0 : [lsearch -exact $arguments $option] + 1}]
    if {$option ne {} && $at == 0} { reject "$name lacks $option" }
    if {![regexp "^($pattern)\$" [lindex $arguments $at]]} { reject "$name is given '[lindex $arguments $at]', which is not $pattern" }
}

# checked NAME OPTION PATTERN : from now on the mock NAME also checks this value.
proc checked {name option pattern} {
    rename ::$name ::unchecked_$name
    proc ::$name {args} [string map [list NAME $name OPTION $option PATTERN $pattern] {
        need_value {NAME} $args {OPTION} {PATTERN}
        unchecked_NAME {*}$args
    }]
}

# Vivado HLS and Vitis HLS.
proc hls_commands {formats part} {
    command open_project {} {} 1
    command set_top open_project {} 1
    command_files add_files {open_project set_top} {-cflags}
    command open_solution {open_project add_files} {-flow_target} 1
    command set_part open_solution {} 1
    command create_clock {open_solution set_part} {-period -name} 0
    command csim_design {create_clock} {} 0
    command csynth_design {create_clock csim_design} {} 0
    command cosim_design csynth_design {-rtl} 0
    command export_design csynth_design {-format} 0
    checked set_part {} $part
    checked create_clock -period {[0-9]+(\.[0-9]+)?}
    checked cosim_design -rtl {verilog|vhdl}
    checked export_design -format $formats
    rename ::exit ::leave
    proc ::exit {{code 0}} { called exit; if {$code} { leave $code } }
    return {csim_design csynth_design cosim_design export_design}
}

# Vivado HLS alone: structs are packed by directive.
proc vivado_hls_commands {} {
    command set_directive_data_pack open_solution {} 2
    checked set_directive_data_pack {} {[a-z_]+}
    set must [hls_commands {sysgen|ip_catalog|pcore|syn_dcp} {xc6v[a-z]+[0-9]+tff[0-9]+-[123]}]
    command csim_design {create_clock set_directive_data_pack} {} 0
    return $must
}

# ISE.
proc ise_commands {} {
    proc ::project {action args} {
        if {$action ne "new"} { need "project $action" {{project new}} }
        if {$action eq "set" && !([llength $args] == 2 || ([llength $args] == 4 && [lindex $args 2] eq "-process"))} {
            reject "project set takes a property and a value, or those and -process NAME: $args"
        }
        called [list project $action]
    }
    proc ::xfile {action file} { need xfile {{project new}}; need_files xfile [list $file]; called xfile }
    proc ::process {action name} { need "process run" {xfile {project set}}; called "process run" }
    return {{project new} {project set} xfile {process run} {project close}}
}

# Vivado.
proc vivado_commands {} {
    command_files read_verilog {}
    command_files read_xdc read_verilog {-mode}
    command synth_design {read_verilog read_xdc} {-top -part -mode} 0
    command opt_design synth_design
    command place_design opt_design
    command phys_opt_design place_design
    command route_design place_design
    foreach report {report_utilization report_timing_summary report_power} { command $report route_design {-file} 0 }
    command write_checkpoint route_design {} 1
    return {synth_design route_design report_utilization report_timing_summary write_checkpoint}
}

proc vivado_ip_commands {} {
    command create_project {} {-part} 2
    command_files add_files create_project
    command set_property {} {} 3
    command current_fileset create_project
    namespace eval ::ipx {}
    command ipx::package_project add_files {-root_dir -vendor -library -taxonomy} 0
    command ipx::current_core ipx::package_project
    command ipx::associate_bus_interfaces ipx::package_project {-busif -clock} 1
    command ipx::create_xgui_files ipx::package_project {} 1
    command ipx::update_checksums ipx::package_project {} 1
    command ipx::check_integrity ipx::update_checksums {} 1
    command ipx::save_core ipx::check_integrity {} 1
    command close_project create_project
    return {ipx::package_project ipx::save_core}
}

switch [file tail $script] {
    vivado_hls.tcl { set must [vivado_hls_commands] }
    vitis_hls.tcl { set must [hls_commands {ip_catalog|xo|syn_dcp|sysgen} {xc[a-z0-9]+-[0-9a-z]+}] }
    ise.tcl { set must [ise_commands] }
    vivado.tcl { set must [vivado_commands] }
    vivado_ip.tcl { set must [vivado_ip_commands] }
    default { reject "there are no mocks for it" }
}
source $script
foreach command $must {
    if {[lsearch -exact $calls $command] < 0} { reject "it never calls $command" }
}
