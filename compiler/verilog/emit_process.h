/// A scheduled process as one Verilog module.
#ifndef HLSC_VERILOG_EMIT_PROCESS_H
#define HLSC_VERILOG_EMIT_PROCESS_H

#include <string>
#include <vector>

#include "design/design.h"
#include "schedule/schedule_process.h"

namespace hlsc {

/// The module's text. Ports: clk, rst (synchronous, high), ap_start/ap_done/ap_idle/ap_ready; a stream `s`
/// that is read has s_dout, s_empty_n, s_read, one that is written s_din, s_full_n, s_write; a memory port
/// has address, ce, we, d, q as in Vitis' ap_memory. ap_done and ap_ready are one pulse per run; scalar
/// outputs keep their value and have NAME_ap_vld.
///
/// A loop's pipeline has one clock enable. It stops when an access to a stream cannot go on; when II = 1, the
/// stages behind the last read go on with bubbles while an input is empty, so that results do not wait for
/// later inputs.
///
/// `has_probes`: with probes for co-simulation (emit_probes.h).
std::string emit_process(const Process& process, const ProcessSchedule& schedule, bool has_probes);

/// Whether a dataflow region's head needs no clock: one block without memory and loops.
bool is_combinational(const Process& process);

/// The module of such a head: scalar inputs to scalar outputs, no clock.
std::string emit_combinational(const Process& process);

}  // namespace hlsc

#endif
