#include "hls/birdseye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "golden/birdseye.h"
#include "host/fixed_point.h"

namespace floorline {
namespace {

const cv::Rect kRoi(0, 160, 640, 320);

/// Pixel -> floor of a camera 0.4 m above the floor that looks down by `pitch`: the rays of a pinhole meet
/// the plane.
Eigen::Matrix3d floor_from_pixel(double pitch) {
  const double height = 0.4, f = 500.0, c = std::cos(pitch), s = std::sin(pitch);
  Eigen::Matrix3d from_ray, ray;
  from_ray << 0, -s * height, c * height, -height, 0, 0, 0, c, s;
  ray << 1 / f, 0, -319.5 / f, 0, 1 / f, -239.5 / f, 0, 0, 1;
  return from_ray * ray;
}

std::vector<FloorPoint> run(const std::vector<golden::Contact>& frame, const ProjectiveMap& map) {
  hls::stream<Contact> contacts("contacts");
  hls::stream<FloorPoint> points("points");
  for (const golden::Contact& c : frame) contacts.write({c.line, c.u, c.v, c.rows, c.clipped, 0});
  contacts.write({0, 0, 0, 0, 0, 1});
  birdseye(contacts, points, map);
  EXPECT_TRUE(contacts.empty());
  std::vector<FloorPoint> result;
  for (FloorPoint p = points.read(); !p.end; p = points.read()) result.push_back(p);
  EXPECT_TRUE(points.empty());
  return result;
}

double metres(ap_int<24> value) { return value.to_double() / 65536.0; }

/// A map that says X, Y and Z of every pixel outright.
ProjectiveMap constant_map(double x, double y, double z) {
  ProjectiveMap map = {};
  map.x1 = static_cast<int>(x * (1 << 18));
  map.y1 = static_cast<int>(y * (1 << 18));
  map.z1 = static_cast<int>(z * (1 << 28));
  return map;
}

std::vector<golden::Contact> random_contacts(int count, int seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> line(0, 127), u(-200, 840), v(0, 479), rows(1, 400), coin(0, 1);
  std::vector<golden::Contact> contacts;
  for (int i = 0; i < count; ++i) {
    contacts.push_back({line(random), u(random), v(random), rows(random), coin(random) == 1});
  }
  return contacts;
}

TEST(Birdseye, EqualsGoldenWithinTheStatedError) {
  for (const double pitch : {0.15, 0.35, 0.8}) {
    const ProjectiveMap map = pack_birdseye(floor_from_pixel(pitch), kRoi).map;
    const Eigen::Matrix3d m = unpack(map);
    const cv::Matx33d exact(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2));
    const std::vector<golden::Contact> contacts = random_contacts(20000, 7);
    const std::vector<FloorPoint> ours = run(contacts, map);
    const std::vector<golden::FloorPoint> expected = golden::birdseye(contacts, exact);
    ASSERT_EQ(ours.size(), expected.size()) << "pitch " << pitch;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const golden::FloorPoint& e = expected[i];
      const double z = (exact * cv::Vec3d(e.contact.u, e.contact.v, 1))[2];
      ASSERT_NEAR(metres(ours[i].x), e.x, std::abs(e.x) / (1 << 15) + 1 / (z * (1 << 14)) + 1.0 / (1 << 16));
      ASSERT_NEAR(metres(ours[i].y), e.y, std::abs(e.y) / (1 << 15) + 1 / (z * (1 << 14)) + 1.0 / (1 << 16));
      ASSERT_EQ((golden::Contact{ours[i].line.to_int(), ours[i].u.to_int(), ours[i].v.to_int(),
                                 ours[i].rows.to_int(), ours[i].clipped != 0}),
                e.contact);
    }
  }
}

TEST(Birdseye, DropsTheHorizonAndWhatIsBeyondItsRange) {
  const std::vector<golden::Contact> one = {{3, 100, 200, 20, false}};
  EXPECT_EQ(run(one, constant_map(2, -1, 1)).size(), 1u);
  for (const double z : {0.0, -1.0, -7.9, 0.0625}) EXPECT_TRUE(run(one, constant_map(2, -1, z)).empty()) << z;
  EXPECT_EQ(run(one, constant_map(2, -1, 0.0626)).size(), 1u);
  EXPECT_EQ(run(one, constant_map(127, -127, 1)).size(), 1u);
  EXPECT_TRUE(run(one, constant_map(129, 0, 1)).empty());
  EXPECT_TRUE(run(one, constant_map(0, -129, 1)).empty());
  EXPECT_TRUE(run(one, constant_map(8000, 0, 1)).empty());
  EXPECT_EQ(run(one, constant_map(1000, -1000, 7.9)).size(), 1u);
}

TEST(Birdseye, DropsADenominatorThatLeavesItsFormat) {
  ProjectiveMap map = constant_map(2, -1, 1);
  map.zu = 1 << 26;  // Z = 1 + 100 / 4 at u = 100, which would wrap to 10
  EXPECT_TRUE(run({{3, 100, 200, 20, false}}, map).empty());
}

TEST(Birdseye, PassesAFrameWithoutContacts) { EXPECT_TRUE(run({}, constant_map(2, -1, 1)).empty()); }

}  // namespace
}  // namespace floorline
