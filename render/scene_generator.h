/// Random rooms for scoring; docs/rendered_set.md tells the distribution.
#ifndef FLOORLINE_RENDER_SCENE_GENERATOR_H
#define FLOORLINE_RENDER_SCENE_GENERATOR_H

#include "scene.h"

namespace floorline::render {

/// The room of a seed: the same on every machine.
Scene generate_scene(std::uint64_t seed);

}  // namespace floorline::render

#endif
