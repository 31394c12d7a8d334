/// The reader of scenes: what it takes, it must also take as it writes it.
#include "reader_contract.h"
#include "render/scene.h"

namespace fuzz = floorline::fuzz;
namespace render = floorline::render;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  file.fill(data, size);
  fuzz::load_or_refuse([] {
    const std::string written = render::scene_to_yaml(render::read_scene(file.path()));
    if (render::scene_to_yaml(render::parse_scene(written, "written")) != written)
      fuzz::finding("the written scene is another one");
  });
  return 0;
}
