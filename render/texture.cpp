#include "texture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "noise.h"

namespace floorline::render {
namespace {

constexpr double texel_m = 0.0016;
constexpr int most_taps = 4;  // along the major axis; longer footprints use a coarser level

// Uniform [0, 1) of a lattice point.
float lattice(std::uint64_t seed, int x, int y) {
  const auto key =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) | static_cast<std::uint32_t>(y);
  return static_cast<float>(mix(seed ^ mix(key)) >> 40) * 0x1.0p-24f;
}

// std::floor calls the library on machines without SSE 4.1; this is two instructions.
int floor_of(float x) {
  const int whole = static_cast<int>(x);
  return whole - (x < static_cast<float>(whole));
}

float smooth(float t) { return t * t * (3 - 2 * t); }

int wrapped(int value, int period) {
  const int rest = value % period;
  return rest < 0 ? rest + period : rest;
}

// Value noise on a torus: x and y in [0, 1) hold nx and ny cells.
float value_noise(std::uint64_t seed, float x, float y, int nx, int ny) {
  const float gx = x * static_cast<float>(nx), gy = y * static_cast<float>(ny);
  const int x0 = floor_of(gx), y0 = floor_of(gy);
  const float fx = smooth(gx - static_cast<float>(x0)), fy = smooth(gy - static_cast<float>(y0));
  const auto corner = [&](int dx, int dy) {
    return lattice(seed, wrapped(x0 + dx, nx), wrapped(y0 + dy, ny));
  };
  const float top = std::lerp(corner(0, 0), corner(1, 0), fx);
  const float bottom = std::lerp(corner(0, 1), corner(1, 1), fx);
  return std::lerp(top, bottom, fy);
}

// Octaves of value noise from `first` cells a period on, halving in amplitude; mean 0, within about +-0.5.
float fractal_noise(std::uint64_t seed, float x, float y, int first, int octaves) {
  float sum = 0, amplitude = 0.5f;
  for (int octave = 0; octave < octaves; ++octave, amplitude *= 0.5f, first *= 2) {
    sum += amplitude * (value_noise(seed + static_cast<std::uint64_t>(octave), x, y, first, first) - 0.5f) *
           2.0f;
  }
  return sum;
}

// The patterns take x and y in [0, 1) of a period of `period` metres that holds `cells` pitches.
struct Pitch {
  float period;
  int cells;
};

float tiles(std::uint64_t seed, float x, float y, Pitch pitch) {
  const float cx = x * static_cast<float>(pitch.cells), cy = y * static_cast<float>(pitch.cells);
  const int ix = static_cast<int>(cx), iy = static_cast<int>(cy);
  const float tile_m = pitch.period / static_cast<float>(pitch.cells);
  const auto edge = [&](float c) { return std::min(c - std::floor(c), 1 - (c - std::floor(c))) * tile_m; };
  constexpr float half_grout_m = 0.0025f;
  if (std::min(edge(cx), edge(cy)) < half_grout_m) return 0.05f;
  return 0.7f + 0.2f * (lattice(seed, ix, iy) - 0.5f) + 0.35f * fractal_noise(seed + 7, x, y, 16, 6);
}

float wood(std::uint64_t seed, float x, float y, Pitch pitch) {
  const int planks = pitch.cells;
  const float across = y * static_cast<float>(planks);
  const int plank = static_cast<int>(across);
  const float shift = lattice(seed, plank, 0);
  const float along = x * 2 + shift;  // two boards a period, each plank shifted
  const int board = wrapped(static_cast<int>(std::floor(along)), 2);
  const float plank_m = pitch.period / static_cast<float>(planks);
  const float gap_m = std::min(across - std::floor(across), 1 - (across - std::floor(across))) * plank_m;
  const float end_m = std::min(along - std::floor(along), 1 - (along - std::floor(along))) * pitch.period / 2;
  if (std::min(gap_m, end_m) < 0.001f) return 0.05f;
  const auto board_seed = seed + static_cast<std::uint64_t>(plank * 2 + board + 11);
  const float grain = value_noise(board_seed, x, y, 12, 256) + 0.5f * value_noise(board_seed, x, y, 24, 640);
  return 0.35f + 0.35f * (lattice(seed, plank, board + 3) - 0.5f) + 0.4f * (grain - 0.35f);
}

float carpet(std::uint64_t seed, float x, float y, Pitch) {
  return 0.5f + 0.25f * fractal_noise(seed, x, y, 3, 3) +
         0.9f * (value_noise(seed + 5, x, y, 512, 512) - 0.5f) +
         0.4f * (value_noise(seed + 6, x, y, 200, 200) - 0.5f);
}

float concrete(std::uint64_t seed, float x, float y, Pitch) {
  const float speckle = value_noise(seed + 9, x, y, 400, 400);
  return 0.5f + 0.8f * fractal_noise(seed, x, y, 4, 8) - (speckle > 0.93f ? 0.3f : 0.0f);
}

float fabric(std::uint64_t seed, float x, float y, Pitch pitch) {
  const float threads = static_cast<float>(pitch.cells) * 2 * static_cast<float>(M_PI);
  return 0.5f + 0.15f * std::sin(x * threads) * std::sin(y * threads) +
         0.6f * fractal_noise(seed, x, y, 8, 6);
}

float stripes(std::uint64_t seed, float x, float y, Pitch pitch) {
  const int band = static_cast<int>(y * static_cast<float>(pitch.cells) * 2);
  return (band % 2 ? 0.9f : 0.1f) + 0.15f * fractal_noise(seed, x, y, 16, 4);
}

// A sheet of random size and tone in about half of the cells, with a smaller one of another tone on it.
float posters(std::uint64_t seed, float x, float y, Pitch pitch) {
  const float cx = x * static_cast<float>(pitch.cells), cy = y * static_cast<float>(pitch.cells);
  const int ix = static_cast<int>(cx), iy = static_cast<int>(cy);
  const float fx = std::abs(cx - static_cast<float>(ix) - 0.5f),
              fy = std::abs(cy - static_cast<float>(iy) - 0.5f);
  const float wall = 0.7f + 0.1f * fractal_noise(seed + 3, x, y, 8, 6);
  const float size = 0.15f + 0.3f * lattice(seed + 1, ix, iy);
  if (lattice(seed, ix, iy) < 0.5f || fx > size || fy > size * 0.8f) return wall;
  const auto tone = static_cast<std::uint64_t>(fx < size * 0.6f && fy < size * 0.4f ? 5 : 4);
  return lattice(seed + tone, ix, iy) + 0.1f * fractal_noise(seed + 3, x, y, 32, 4);
}

float plain(std::uint64_t seed, float x, float y, Pitch) {
  return 0.5f + 0.3f * fractal_noise(seed, x, y, 3, 7);
}

float pattern_value(Pattern pattern, std::uint64_t seed, float x, float y, Pitch pitch) {
  switch (pattern) {
    case Pattern::plain:
      return plain(seed, x, y, pitch);
    case Pattern::tiles:
      return tiles(seed, x, y, pitch);
    case Pattern::wood:
      return wood(seed, x, y, pitch);
    case Pattern::carpet:
      return carpet(seed, x, y, pitch);
    case Pattern::concrete:
      return concrete(seed, x, y, pitch);
    case Pattern::fabric:
      return fabric(seed, x, y, pitch);
    case Pattern::stripes:
      return stripes(seed, x, y, pitch);
    case Pattern::posters:
      return posters(seed, x, y, pitch);
  }
  return 0;
}

constexpr float full_scale = 65535.0f;

}  // namespace

Texture::Texture(Pattern pattern, double size_m, std::uint64_t seed, int texels) {
  const int cells = std::max(1, static_cast<int>(std::lround(texels * texel_m / size_m)));
  const Pitch pitch{static_cast<float>(cells * size_m), cells};
  period_m_ = pitch.period;
  levels_.push_back({texels, std::vector<std::uint16_t>(static_cast<std::size_t>(texels) * texels)});
  std::vector<std::uint16_t>& values = levels_[0].values;
  tbb::parallel_for(0, texels, [&](int row) {
    for (int column = 0; column < texels; ++column) {
      const float x = (static_cast<float>(column) + 0.5f) / static_cast<float>(texels);
      const float y = (static_cast<float>(row) + 0.5f) / static_cast<float>(texels);
      const float value = std::clamp(pattern_value(pattern, seed, x, y, pitch), 0.0f, 1.0f);
      values[static_cast<std::size_t>(row) * texels + column] =
          static_cast<std::uint16_t>(value * full_scale);
    }
  });
  add_coarser_levels();
}

void Texture::add_coarser_levels() {
  while (levels_.back().side > 1) {
    const Level& fine = levels_.back();
    Level coarse{fine.side / 2, {}};
    coarse.values.reserve(static_cast<std::size_t>(coarse.side) * coarse.side);
    for (int row = 0; row < coarse.side; ++row) {
      const std::uint16_t* above = &fine.values[static_cast<std::size_t>(2 * row) * fine.side];
      const std::uint16_t* below = above + fine.side;
      for (int c = 0; c < coarse.side; ++c) {
        const unsigned sum = above[2 * c] + above[2 * c + 1] + below[2 * c] + below[2 * c + 1];
        coarse.values.push_back(static_cast<std::uint16_t>((sum + 2) / 4));
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

float Texture::bilinear(const Level& level, Eigen::Vector2f at) const {
  const Eigen::Vector2f texel =
      at * (static_cast<float>(level.side) / period_m_) - Eigen::Vector2f(0.5f, 0.5f);
  const int x = floor_of(texel.x()), y = floor_of(texel.y());
  const int mask = level.side - 1;  // the side is a power of two, so that & wraps negative numbers too
  const int x0 = x & mask, x1 = (x + 1) & mask, y0 = y & mask, y1 = (y + 1) & mask;
  const std::uint16_t* top = &level.values[static_cast<std::size_t>(y0) * level.side];
  const std::uint16_t* bottom = &level.values[static_cast<std::size_t>(y1) * level.side];
  const float fx = texel.x() - static_cast<float>(x), fy = texel.y() - static_cast<float>(y);
  const float upper = static_cast<float>(top[x0]) * (1 - fx) + static_cast<float>(top[x1]) * fx;
  const float lower = static_cast<float>(bottom[x0]) * (1 - fx) + static_cast<float>(bottom[x1]) * fx;
  return (upper * (1 - fy) + lower * fy) * (1 / full_scale);
}

float Texture::sample(Eigen::Vector2f at, const Footprint& footprint) const {
  const float major = footprint.major.norm();
  const float minor = std::max(footprint.minor, major / most_taps);
  const int taps = std::clamp(static_cast<int>(std::ceil(major / minor)), 1, most_taps);
  const float finest_m = period_m_ / static_cast<float>(levels_[0].side);
  const float level =
      std::clamp(std::log2(2 * minor / finest_m), 0.0f, static_cast<float>(levels_.size() - 1));
  const auto fine = static_cast<std::size_t>(level);
  const std::size_t coarse = std::min(fine + 1, levels_.size() - 1);
  const float blend = level - static_cast<float>(fine);
  float sum = 0;
  for (int tap = 0; tap < taps; ++tap) {
    const float offset = (static_cast<float>(tap) + 0.5f) / static_cast<float>(taps) * 2 - 1;
    const Eigen::Vector2f position = at + footprint.major * offset;
    sum += std::lerp(bilinear(levels_[fine], position), bilinear(levels_[coarse], position), blend);
  }
  return sum / static_cast<float>(taps);
}

}  // namespace floorline::render
