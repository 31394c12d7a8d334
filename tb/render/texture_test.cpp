#include "render/texture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace floorline::render {
namespace {

const Footprint point{{1e-4f, 0}, 1e-4f};

// Spread of the values along a metre.
double contrast(const Texture& texture, const Footprint& footprint) {
  float low = 1, high = 0;
  for (int i = 0; i < 500; ++i) {
    const float value = texture.sample({0.002f * static_cast<float>(i), 0.37f}, footprint);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high - low;
}

TEST(Texture, RepeatsWithoutASeam) {
  const Texture texture(Pattern::tiles, 0.3, 1, 256);
  const float period = 0.3f;  // 256 texels of 1.6 mm hold one tile
  for (const float x : {0.0f, 0.11f, 0.299f}) {
    EXPECT_NEAR(texture.sample({x, 0.05f}, point), texture.sample({x + period, 0.05f - period}, point), 1e-3);
  }
}

TEST(Texture, WideFootprintsLeaveTheMean) {
  const Footprint wide{{1.0f, 0}, 0.4f};
  for (const Pattern pattern :
       {Pattern::wood, Pattern::carpet, Pattern::concrete, Pattern::fabric, Pattern::stripes}) {
    const Texture texture(pattern, 0.1, 1, 256);
    EXPECT_GT(contrast(texture, point), 0.1);
    EXPECT_LT(contrast(texture, wide), contrast(texture, point) / 2);
  }
}

TEST(Texture, AveragesAlongTheViewOnly) {
  const Texture stripes(Pattern::stripes, 0.1, 1, 256);  // bands across y
  const auto along_y = [&](const Footprint& footprint) {
    float low = 1, high = 0;
    for (int i = 0; i < 100; ++i) {
      const float value = stripes.sample({0.0f, 0.002f * static_cast<float>(i)}, footprint);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    return high - low;
  };
  EXPECT_GT(along_y({{0.02f, 0}, 0.005f}), 0.6);
  EXPECT_LT(along_y({{0, 0.05f}, 0.0125f}), 0.4);
}

}  // namespace
}  // namespace floorline::render
