/// floorline render: sequences with exact ground truth, from a scene file or from seeds.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "render/renderer.h"
#include "render/scene_generator.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string scene;
  std::optional<std::uint64_t> seed;
  std::string seeds;
  std::string output;
  bool force = false;
  Output results;
};

constexpr const char* footer =
    "Examples:\n"
    "  floorline render scenes/demo.yaml --output out/demo      one scene\n"
    "  floorline render --seed 7 --output out/room              the random room of a seed\n"
    "  floorline render --seeds 1..12 --output out/rooms        out/rooms/seed-0001 ... seed-0012";

void render_one(const render::Scene& scene, const Options& options, const fs::path& folder) {
  produce_folder(folder, options.force, [&](const fs::path& fresh) {
    Progress progress("render " + scene.name);
    render::render_sequence(scene, fresh, [&](int done, int total) {
      progress.advance(done, total);
      return true;
    });
  });
}

/// "A..B", both inclusive.
std::pair<std::uint64_t, std::uint64_t> parse_seeds(const std::string& text) {
  unsigned long long first = 0, last = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%llu..%llu%c", &first, &last, &rest) != 2 || last < first) {
    throw CLI::ValidationError("--seeds", fmt::format("'{}' is not a range like 1..12.", text));
  }
  return {first, last};
}

/// The scenes asked for, each with its folder.
std::vector<std::pair<render::Scene, fs::path>> planned(const Options& options) {
  if (!options.scene.empty()) return {{render::read_scene(options.scene), options.output}};
  if (options.seed) return {{render::generate_scene(*options.seed), options.output}};
  const auto [first, last] = parse_seeds(options.seeds);
  std::vector<std::pair<render::Scene, fs::path>> scenes;
  for (std::uint64_t seed = first; seed <= last; ++seed)
    scenes.emplace_back(render::generate_scene(seed),
                        fs::path(options.output) / fmt::format("seed-{:04}", seed));
  return scenes;
}

ExitCode run(const Options& options) {
  nlohmann::json rendered = nlohmann::json::array();
  for (const auto& [scene, folder] : planned(options)) {
    render_one(scene, options, folder);
    const int width = scene.image.width, height = scene.image.height;
    options.results.text(
        fmt::format("{}: {} frames of {} x {}", folder.string(), scene.frame_count(), width, height));
    rendered.push_back(
        {{"folder", folder.string()}, {"frames", scene.frame_count()}, {"width", width}, {"height", height}});
  }
  options.results.json({{"sequences", rendered}});
  return ExitCode::ok;
}

}  // namespace

Command add_render(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = app.add_subcommand("render", "Render a sequence with exact ground truth");
  parser->footer(footer);
  auto* source = parser->add_option_group("source", "One of these");
  source->add_option("SCENE", options->scene, "Scene file (docs/rendered_set.md lists its keys)")
      ->type_name("SCENE.yaml");
  source->add_option("--seed", options->seed, "The random room of seed N")->type_name("N");
  source->add_option("--seeds", options->seeds, "The rooms of seeds A to B, a folder each")
      ->type_name("A..B");
  source->require_option(1);
  parser->add_option("--output", options->output, "Sequence folder to write")
      ->type_name("FOLDER")
      ->required();
  parser->add_flag("--force", options->force, "Replace the folder when it is there already");
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
