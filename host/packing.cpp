#include "host/packing.h"

namespace floorline {
namespace {

// The order of the fields is that of the structs; it stands here once for both directions.

template <typename Visitor>
void each_field(LineSetup& e, Visitor visit) {
  visit(e.first_column), visit(e.first_row), visit(e.last_row), visit(e.first_run), visit(e.last_run),
      visit(e.slice), visit(e.remainder), visit(e.divisor), visit(e.first_error), visit(e.leftward),
      visit(e.contact_first);
}

template <typename Visitor>
void each_field(FloorPoint& e, Visitor visit) {
  visit(e.line), visit(e.u), visit(e.v), visit(e.rows), visit(e.x), visit(e.y), visit(e.clipped),
      visit(e.end);
}

template <typename Visitor>
void each_field(Obstacle& e, Visitor visit) {
  visit(e.first_line), visit(e.last_line), visit(e.u), visit(e.v), visit(e.rows), visit(e.x), visit(e.y),
      visit(e.clipped), visit(e.end);
}

template <typename Visitor>
void each_field(LineCount& e, Visitor visit) {
  visit(e.line), visit(e.count), visit(e.end);
}

template <int W>
constexpr int width_of(const ap_uint<W>&) {
  return W;
}
template <int W>
constexpr int width_of(const ap_int<W>&) {
  return W;
}

template <typename Element>
PackedElement pack_fields(Element element) {
  PackedElement words = {};
  int position = 0;
  each_field(element, [&](auto& field) {
    for (int bit = 0; bit < width_of(field); ++bit, ++position) {
      if (field[bit]) words[position / 32] |= 1u << position % 32;
    }
  });
  return words;
}

template <typename Element>
Element unpack_fields(const PackedElement& words) {
  Element element = {};
  int position = 0;
  each_field(element, [&](auto& field) {
    for (int bit = 0; bit < width_of(field); ++bit, ++position) {
      field[bit] = words[position / 32] >> position % 32 & 1;
    }
  });
  return element;
}

}  // namespace

PackedElement pack(const LineSetup& element) { return pack_fields(element); }
PackedElement pack(const FloorPoint& element) { return pack_fields(element); }
PackedElement pack(const Obstacle& element) { return pack_fields(element); }
PackedElement pack(const LineCount& element) { return pack_fields(element); }

FloorPoint unpack_floor_point(const PackedElement& words) { return unpack_fields<FloorPoint>(words); }
Obstacle unpack_obstacle(const PackedElement& words) { return unpack_fields<Obstacle>(words); }
LineCount unpack_line_count(const PackedElement& words) { return unpack_fields<LineCount>(words); }

}  // namespace floorline
