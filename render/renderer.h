/// Ray-traced sequences with exact ground truth: images, poses, odometry, masks and contact curves.
#ifndef FLOORLINE_RENDER_RENDERER_H
#define FLOORLINE_RENDER_RENDERER_H

#include <filesystem>
#include <functional>

#include "scene.h"

namespace floorline::render {

/// Called after each frame with the number of frames done and of all frames; returns false to stop.
using Progress = std::function<bool(int done, int total)>;

/// Renders `scene` into the sequence folder `folder` (format: docs/architecture.md). The folder appears only
/// when it is complete; a folder that is there already is an error. Same scene, same bytes, on any number of
/// threads. Throws Error with one sentence when something cannot be written or `progress`
/// stopped it.
void render_sequence(const Scene& scene, const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace floorline::render

#endif
