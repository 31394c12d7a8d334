/// floorline cycles: the table of cycles by frame size, against a baseline.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "command.h"
#include "host/error.h"
#include "output.h"
#include "progress.h"
#include "tb/cosim/cycle_table.h"

namespace floorline::app {
namespace {

struct Options {
  std::string baseline;
  std::string hardware;
  Output results;
};

nlohmann::json to_json(const std::vector<cosim::CycleRow>& table) {
  nlohmann::json rows = nlohmann::json::array();
  for (const cosim::CycleRow& row : table) {
    rows.push_back({{"width", row.size.width},
                    {"height", row.size.height},
                    {"stalls", name(row.stalls)},
                    {"frame_cycles", row.frame_cycles},
                    {"input_stalls", row.input_stalls},
                    {"output_stalls", row.output_stalls},
                    {"first_result_latency", row.first_result_latency},
                    {"decision_latency", row.decision_latency}});
  }
  return rows;
}

nlohmann::json read_baseline(const std::string& file) {
  std::ifstream in(file);
  nlohmann::json baseline = nlohmann::json::parse(in, nullptr, false);
  if (!baseline.is_array()) {
    throw Error(
        fmt::format("{} holds no table of cycles; write one with 'floorline cycles --json FILE'.", file));
  }
  return baseline;
}

/// One section of docs/report.md.
nlohmann::json hardware_sections(const nlohmann::json& table, const nlohmann::json& baseline) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const nlohmann::json& row = table[i];
    const bool same = !baseline.is_null() && i < baseline.size() && baseline[i] == row;
    rows.push_back({fmt::format("{}x{}", row["width"].get<int>(), row["height"].get<int>()), row["stalls"],
                    row["frame_cycles"], row["input_stalls"], row["output_stalls"],
                    row["first_result_latency"], row["decision_latency"],
                    baseline.is_null() ? ""
                    : same             ? "ok"
                                       : "short"});
  }
  return nlohmann::json::array(
      {{{"title", "Cycles by frame size"},
        {"note", "The core's own counters on frames back to back; short: not what the baseline has."},
        {"columns",
         {"size", "stalls", "frame", "pixels waited", "results waited", "first pixel to first result",
          "deciding row to point", "verdict"}},
        {"rows", rows}}});
}

ExitCode run(const Options& options) {
  const nlohmann::json baseline =
      options.baseline.empty() ? nlohmann::json() : read_baseline(options.baseline);
  const auto& cases = cosim::cycle_cases();
  std::vector<cosim::CycleRow> table;
  {
    Progress progress("cycles");
    for (const cosim::CycleCase& some : cases) {
      table.push_back(cosim::measure_cycles(some.size, some.stalls));
      progress.advance(static_cast<int>(table.size()), static_cast<int>(cases.size()));
    }
  }
  options.results.text(fmt::format("{:>9} {:>7} {:>10} {:>14} {:>12} {:>14}", "size", "stalls", "cycles",
                                   "beyond pixels", "first result", "deciding row"));
  for (const cosim::CycleRow& row : table) {
    options.results.text(fmt::format("{:>9} {:>7} {:>10} {:>14} {:>12} {:>14}",
                                     fmt::format("{}x{}", row.size.width, row.size.height), name(row.stalls),
                                     row.frame_cycles, static_cast<int>(row.frame_cycles) - row.size.area(),
                                     row.first_result_latency, row.decision_latency));
  }
  const nlohmann::json facts = to_json(table);
  options.results.json(facts);
  if (!options.hardware.empty())
    produce_file(options.hardware, hardware_sections(facts, baseline).dump(2) + "\n");
  if (baseline.is_null() || baseline == facts) return ExitCode::ok;
  options.results.text(fmt::format(
      "The table is not that of {}: if the change is wanted, renew it with 'floorline cycles --json "
      "{}' and give the reason in CHANGELOG.md.",
      options.baseline, options.baseline));
  return ExitCode::short_of_bound;
}

}  // namespace

Command add_cycles(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser =
      app.add_subcommand("cycles", "Count the cycles of a frame in the Verilog for several sizes");
  parser->footer(
      "Examples:\n"
      "  floorline cycles --baseline tb/cosim/cycles_baseline.json\n"
      "  floorline cycles --json tb/cosim/cycles_baseline.json\n"
      "Exit code 1: the table differs from the baseline.");
  parser->add_option("--baseline", options->baseline, "Table to compare with, as --json writes it")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  parser->add_option("--hardware", options->hardware, "Section for floorline report --hardware")
      ->type_name("FILE");
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
