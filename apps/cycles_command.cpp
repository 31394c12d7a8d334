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
    nlohmann::json stages = nlohmann::json::array();
    for (const cosim::StageRun& stage : row.stages) stages.push_back({stage.name, stage.longest});
    rows.push_back({{"width", row.size.width},
                    {"height", row.size.height},
                    {"stalls", name(row.stalls)},
                    {"frame_cycles", row.frame_cycles},
                    {"input_stalls", row.input_stalls},
                    {"output_stalls", row.output_stalls},
                    {"first_result_latency", row.first_result_latency},
                    {"decision_latency", row.decision_latency},
                    {"stages", stages}});
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

std::string verdict(const nlohmann::json& baseline, bool same) {
  return baseline.is_null() ? "" : same ? "ok" : "short";
}

/// The row of frames as the paper has them, no stalls; empty when there is none.
nlohmann::json paper_row(const nlohmann::json& table) {
  for (const nlohmann::json& row : table) {
    if (row.value("width", 0) == 640 && row.value("height", 0) == 480 && row.value("stalls", "") == "none")
      return row;
  }
  return nlohmann::json::object();
}

nlohmann::json stages_section(const nlohmann::json& table, const nlohmann::json& baseline) {
  const nlohmann::json row = paper_row(table), before = paper_row(baseline);
  const int pixels = row["width"].get<int>() * row["height"].get<int>();
  const nlohmann::json accepted = before.value("stages", nlohmann::json::array());
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < row["stages"].size(); ++i) {
    const nlohmann::json& stage = row["stages"][i];
    const bool same = i < accepted.size() && accepted[i] == stage;
    rows.push_back({stage[0], stage[1], stage[1].get<int>() - pixels, verdict(baseline, same)});
  }
  return {
      {"title", "Cycles by stage, 640x480"},
      {"note",
       "A frame for itself, from its start to the stage's end: what is beyond the pixels is the way through "
       "the stages before and the stage's own. Otsu searches after the frame, which nobody waits for. "
       "The paper needs about 4,610 cycles beyond the deciding row for all stages together. short: not what "
       "the baseline has."},
      {"columns", {"stage", "cycles", "beyond pixels", "verdict"}},
      {"rows", rows}};
}

/// Sections of docs/report.md.
nlohmann::json hardware_sections(const nlohmann::json& table, const nlohmann::json& baseline) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const nlohmann::json& row = table[i];
    const bool same = !baseline.is_null() && i < baseline.size() && baseline[i] == row;
    rows.push_back({fmt::format("{}x{}", row["width"].get<int>(), row["height"].get<int>()), row["stalls"],
                    row["frame_cycles"], row["input_stalls"], row["output_stalls"],
                    row["first_result_latency"], row["decision_latency"], verdict(baseline, same)});
  }
  return nlohmann::json::array(
      {stages_section(table, baseline),
       {{"title", "Cycles by frame size"},
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
