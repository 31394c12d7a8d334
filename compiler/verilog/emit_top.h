/// The top module: instances of the processes, the FIFOs between them, and ports under Vitis' names.
#ifndef HLSC_VERILOG_EMIT_TOP_H
#define HLSC_VERILOG_EMIT_TOP_H

#include <map>
#include <string>
#include <vector>

#include "design/design.h"
#include "frontend/frontend.h"
#include "middle/directives_to_ir.h"
#include "verilog/interface.h"

namespace hlsc {

struct TopModule {
  std::string text;
  std::map<std::string, std::string> bank_files;  ///< Name -> text: modules of the s_axilite banks, C header.
  TopInterface interface;
};

/// How the ports of the top look, from the INTERFACE directives.
struct PortModes {
  std::map<std::string, Directive> by_port;  ///< Parameter name or "return".
  int least_fifo = 1;                        ///< Words of the smallest FIFO behind an output (Target).

  /// Warns of m_axi, in whose place there are the ports of a memory.
  static PortModes from(const std::vector<PortDirective>& directives, Diagnostics& diagnostics);
  /// "axis", "ap_fifo", "ap_none", "ap_vld", "ap_memory", "ap_ctrl_hs", ...; empty when not given.
  std::string mode(const std::string& port) const;
  /// The bundle of a port with s_axilite, which may have another mode beside; empty for the others.
  std::string bank(const std::string& port) const;
};

/// A top that is one process: the process with other port names. `has_probes` as in emit_process.
TopModule emit_single_top(const FunctionInfo& top, const Process& process, const PortModes& modes,
                          bool has_probes);

/// A dataflow region. A start of the region puts the scalars of the run into a FIFO before each instance; an
/// instance runs when its FIFO holds a start and its streams allow, so the first may be runs ahead of the
/// last. When the scalars are many, each instance has a register for those of its run instead, and takes
/// them from the ports when it is free: the first may be one run ahead of the last. The region is done when
/// all instances are.
///
/// A stream that `taps` names has outputs NAME_tap_TDATA, _TVALID and _TREADY besides: what its reader sees.
/// An element passes in every cycle in which both are 1; nothing waits for who looks at it. Throws
/// CompileError for a name that no stream between the processes has. `has_probes` as in emit_process.
TopModule emit_dataflow_top(const FunctionInfo& top, const Region& region,
                            const std::vector<const Process*>& processes, const PortModes& modes,
                            const std::vector<std::string>& taps, bool has_probes);

}  // namespace hlsc

#endif
