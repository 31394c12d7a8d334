# Where things are, for every vendor script: each lists files through these procedures and never by a path of its own.

set root [file normalize [file join [file dirname [info script]] .. ..]]

# The kernels' top function, its sources and its test bench.
set kernel_top floorline_accelerator
proc kernel_sources {} { global root; return [list [file join $root hls accelerator.cpp]] }
proc kernel_testbench {} { global root; return [file join $root scripts vendor accelerator_tb.cpp] }
# c++0x is what GCC 4.6, which Vivado HLS brings for its C simulation, calls C++11; later compilers know it too.
proc kernel_flags {} { global root; return "-std=c++0x -I[file join $root hls]" }

# {function array} of every array of structs that hls/ aggregates; a kernel has the name of its header.
proc aggregated_arrays {} {
    global root
    set arrays {}
    foreach header [lsort [glob -directory $root hls/*.h]] {
        set file [open $header]
        foreach {- variable} [regexp -all -inline {#pragma HLS AGGREGATE variable = (\w+)} [read $file]] {
            lappend arrays [list [file rootname [file tail $header]] $variable]
        }
        close $file
    }
    return $arrays
}

# The Verilog of floorline_top: hand-written, library, generated.
proc verilog_sources {} {
    global root
    set files {}
    foreach pattern {rtl/*.v rtl/lib/*.v rtl/generated/*.v} {
        set found [lsort [glob -nocomplain -directory $root $pattern]]
        if {[llength $found] == 0} {
            error "no file matches $pattern; a clean checkout has them, so check it out again or generate them"
        }
        lappend files {*}$found
    }
    return $files
}

# The demonstration on a board: test pattern in, results on a serial line.
proc board_sources {} {
    global root
    return [lsort [glob -directory $root rtl/board/*.v]]
}

proc constraints_file {name} { global root; return [file join $root constraints $name] }
proc out_dir {name} { global root; return [file join $root out $name] }
