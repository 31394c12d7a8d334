/// Elements of hls/types.h as the words of rtl/floorline_top: fields in the order of the struct, packed from
/// bit 0.
#ifndef FLOORLINE_HOST_PACKING_H
#define FLOORLINE_HOST_PACKING_H

#include <array>
#include <cstdint>

#include "hls/types.h"

namespace floorline {

/// A packed element, bit 0 first; 128 bits hold the widest.
using PackedElement = std::array<std::uint32_t, 4>;

PackedElement pack(const LineSetup& element);
PackedElement pack(const FloorPoint& element);
PackedElement pack(const Obstacle& element);
PackedElement pack(const LineCount& element);

FloorPoint unpack_floor_point(const PackedElement& words);
Obstacle unpack_obstacle(const PackedElement& words);
LineCount unpack_line_count(const PackedElement& words);

}  // namespace floorline

#endif
