/// Probes: what modules tell a co-simulation beside their work, as SystemVerilog that calls the functions of
/// cosim/probes.h. They read signals and change none.
#ifndef HLSC_VERILOG_EMIT_PROBES_H
#define HLSC_VERILOG_EMIT_PROBES_H

#include <string>

namespace hlsc {

/// The functions; once in every module with probes.
std::string probe_imports();

/// That a run of a top without ap_done ends with this clock edge.
std::string run_probe(const std::string& done);

/// How many words the FIFO of stream `name` holds, and the most it has held.
std::string fifo_probe(const std::string& name, int depth);

/// Which stream of the region a port of an instance is tied to.
std::string end_probe(const std::string& instance, const std::string& port, const std::string& stream,
                      bool is_reader);

/// An instance that could start but for a bank of an array.
std::string gate_probe(const std::string& instance, const std::string& channel, bool is_reader);

}  // namespace hlsc

#endif
