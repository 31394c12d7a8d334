#include <nlohmann/json.hpp>

#include "report/write.h"

namespace hlsc {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const SourceLocation& location) {
  return {{"file", location.file}, {"line", location.line}, {"column", location.column}};
}

Json to_json(const Latency& latency) {
  Json made = {{"formula", latency.text()}, {"is_bound", latency.is_bound}};
  if (latency.terms.empty() && !latency.is_endless) made["cycles"] = latency.cycles;
  return made;
}

Json to_json(const Resources& r) {
  return {{"lut", r.lut}, {"ff", r.ff}, {"dsp", r.dsp}, {"bram18", r.bram}};
}

Json to_json(const LoopReport& loop) {
  Json made = {{"name", loop.name},
               {"source", to_json(loop.location)},
               {"nesting", loop.depth_in_nest},
               {"pipelined", loop.is_pipelined},
               {"least_trips", loop.least_trips},
               {"most_trips", loop.most_trips},
               {"latency", to_json(loop.latency)}};
  if (loop.is_pipelined)
    made.update(
        {{"ii", loop.ii}, {"asked_ii", loop.asked_ii}, {"stages", loop.stages}, {"limit", loop.limit}});
  return made;
}

Json to_json(const MemoryReport& memory) {
  return {{"name", memory.name}, {"kind", memory.kind},   {"words", memory.words},
          {"bits", memory.bits}, {"loads", memory.loads}, {"stores", memory.stores}};
}

Json to_json(const ScheduledOperation& op) {
  return {{"id", op.id},     {"name", op.name},        {"kind", op.kind},   {"source", to_json(op.location)},
          {"bits", op.bits}, {"start", op.start},      {"ready", op.ready}, {"begin", op.begin},
          {"end", op.end},   {"operands", op.operands}};
}

Json to_json(const BlockReport& block) {
  Json operations = Json::array();
  for (const ScheduledOperation& op : block.operations) operations.push_back(to_json(op));
  return {{"name", block.name},     {"source", to_json(block.location)},
          {"loop", block.is_loop},  {"ii", block.ii},
          {"cycles", block.cycles}, {"operations", operations}};
}

Json to_json(const OperatorReport& op) { return {{"kind", op.kind}, {"bits", op.bits}, {"count", op.count}}; }

Json to_json(const ModuleReport& module);

template <typename T>
Json list(const std::vector<T>& items) {
  Json made = Json::array();
  for (const T& item : items) made.push_back(to_json(item));
  return made;
}

Json to_json(const ModuleReport& module) {
  return {
      {"name", module.name},
      {"function", module.source_name},
      {"source", to_json(module.location)},
      {"latency", to_json(module.latency)},
      {"estimate", to_json(module.resources)},
      {"loops", list(module.loops)},
      {"memories", list(module.memories)},
      {"operators", list(module.operators)},
      {"longest_chain",
       {{"ns", module.chain.delay}, {"block", module.chain.block}, {"operations", module.chain.operations}}},
      {"blocks", list(module.blocks)}};
}

}  // namespace

std::string report_json(const Report& report) {
  Json made = {{"top", report.top},
               {"target", report.target},
               {"clock_ns", report.period},
               {"chain_budget_ns", report.budget},
               {"estimate", to_json(report.resources)},
               {"warnings", report.warnings},
               {"modules", list(report.modules)}};
  return made.dump(1) + "\n";
}

}  // namespace hlsc
