#include <algorithm>
#include <cstdio>

#include "report/write.h"

namespace hlsc {
namespace {

using Row = std::vector<std::string>;

std::string place(const SourceLocation& location) {
  if (!location.line) return "";
  return location.file.substr(location.file.find_last_of('/') + 1) + ":" + std::to_string(location.line);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

/// Columns as wide as their widest cell; the last one stays open.
std::string table(const Row& head, std::vector<Row> rows) {
  if (rows.empty()) return "";
  rows.insert(rows.begin(), head);
  std::vector<size_t> widths(head.size(), 0);
  for (const Row& row : rows)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string out;
  for (const Row& row : rows) {
    std::string line = "  ";
    for (size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out + "\n";
}

std::string cycles(const Latency& latency) { return (latency.is_bound ? "up to " : "") + latency.text(); }

std::string trips(const LoopReport& loop) {
  if (!loop.most_trips) return "N(" + loop.name + ")";
  if (loop.least_trips == loop.most_trips) return std::to_string(loop.most_trips);
  return std::to_string(loop.least_trips) + ".." + std::to_string(loop.most_trips);
}

std::string loops_text(const ModuleReport& module) {
  std::vector<Row> rows;
  std::string limits;
  for (const LoopReport& loop : module.loops) {
    std::string indent(2 * loop.depth_in_nest, ' ');
    std::string asked = loop.asked_ii ? std::to_string(loop.asked_ii) : "", ii = std::to_string(loop.ii);
    rows.push_back({indent + loop.name, place(loop.location), loop.is_pipelined ? ii : "-",
                    loop.is_pipelined ? asked : "-", loop.is_pipelined ? std::to_string(loop.stages) : "-",
                    trips(loop), cycles(loop.latency)});
    if (!loop.limit.empty()) limits += "  " + loop.name + ": II " + ii + " because " + loop.limit + "\n";
  }
  return table({"loop", "source", "II", "asked", "stages", "iterations", "cycles"}, rows) +
         (limits.empty() ? "" : limits + "\n");
}

std::string memories_text(const ModuleReport& module) {
  std::vector<Row> rows;
  for (const MemoryReport& memory : module.memories)
    rows.push_back({memory.name, memory.kind,
                    std::to_string(memory.words) + " x " + std::to_string(memory.bits),
                    std::to_string(memory.loads), std::to_string(memory.stores)});
  return table({"memory", "kind", "words x bits", "loads", "stores"}, rows);
}

std::string operators_text(const ModuleReport& module) {
  std::vector<Row> rows;
  for (const OperatorReport& op : module.operators)
    rows.push_back({op.kind, std::to_string(op.bits), std::to_string(op.count)});
  return table({"operator", "bits", "count"}, rows);
}

std::string chain_text(const ModuleReport& module) {
  if (module.chain.block < 0) return "";
  std::vector<Row> rows;
  for (ValueId id : module.chain.operations)
    for (const ScheduledOperation& op : module.blocks[module.chain.block].operations)
      if (op.id == id) rows.push_back({op.name, op.kind, place(op.location), number(op.end)});
  return table({"longest chain", "", "source", "until ns"}, rows);
}

std::string resources_text(const Resources& resources) {
  return "LUT " + std::to_string(resources.lut) + ", FF " + std::to_string(resources.ff) + ", DSP " +
         std::to_string(resources.dsp) + ", BRAM18 " + std::to_string(resources.bram);
}

}  // namespace

std::string report_text(const Report& report) {
  std::string out = report.top + " for " + report.target + ", clock " + number(report.period) +
                    " ns, of which a chain may take " + number(report.budget) + " ns\n" +
                    "Estimate of all modules: " + resources_text(report.resources) + "\n";
  for (const std::string& warning : report.warnings) out += warning + "\n";
  for (const ModuleReport& module : report.modules)
    out += "\n" + module.name + ": " + module.source_name + " of " + place(module.location) + "\n  cycles " +
           cycles(module.latency) + "\n  estimate " + resources_text(module.resources) + "\n\n" +
           loops_text(module) + memories_text(module) + operators_text(module) + chain_text(module);
  return out;
}

}  // namespace hlsc
