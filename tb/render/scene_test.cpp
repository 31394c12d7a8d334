#include "render/scene.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "render/scene_generator.h"

namespace floorline::render {
namespace {

using testing::HasSubstr;

std::string message_of(const std::string& yaml) {
  try {
    parse_scene(yaml, "room.yaml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Scene, KeepsDefaultsOfKeysThatAreLeftOut) {
  const Scene scene = parse_scene("camera: {height_m: 0.7}", "room.yaml");
  EXPECT_EQ(scene.camera.height_m, 0.7);
  EXPECT_EQ(scene.camera.pitch_deg, Camera().pitch_deg);
  EXPECT_EQ(scene.frame_count(), PathSegment().frames);
}

TEST(Scene, WritesWhatItReads) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::string yaml = scene_to_yaml(generate_scene(seed));
    EXPECT_EQ(scene_to_yaml(parse_scene(yaml, "written")), yaml) << "seed " << seed;
  }
}

TEST(Scene, ReadsAllScenesOfTheProject) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLOORLINE_SCENES)) {
    const Scene scene = read_scene(entry.path());
    EXPECT_EQ(scene.name, entry.path().stem());
    ++count;
  }
  EXPECT_GE(count, 12);
}

TEST(Scene, SaysWhatIsWrong) {
  EXPECT_THAT(message_of("camera: {hight_m: 1}"),
              HasSubstr("'hight_m' is no key here; known are distortion"));
  EXPECT_THAT(message_of("camera: {height_m: tall}"),
              HasSubstr("room.yaml.camera: 'height_m' must be a number"));
  EXPECT_THAT(message_of("camera: {height_m: .nan}"), HasSubstr("must lie between"));
  EXPECT_THAT(message_of("image: {width: 12.5}"), HasSubstr("must lie between 16 and 2047"));
  EXPECT_THAT(message_of("image: {width: 20.5}"), HasSubstr("must be a whole number"));
  EXPECT_THAT(message_of("image: {colour: maybe}"), HasSubstr("true or false"));
  EXPECT_THAT(message_of("room: {low: [1]}"), HasSubstr("a list of 2 numbers"));
  EXPECT_THAT(message_of("room: {low: [9, 0]}"), HasSubstr("room.low must be below room.high"));
  EXPECT_THAT(message_of("obstacles: [{kind: sphere}]"), HasSubstr("choose from box, cylinder"));
  EXPECT_THAT(message_of("obstacles: {kind: box}"), HasSubstr("must be a list"));
  EXPECT_THAT(message_of("markings: [{polygon: [[0, 0], [1, 1]]}]"), HasSubstr("at least 3 points"));
  EXPECT_THAT(message_of("markings: [{polygon: [[0, 0], [1, 1], [1, 0], [0, 1]]}]"), HasSubstr("convex"));
  EXPECT_THAT(message_of("path: {segments: []}"), HasSubstr("at least one segment"));
  EXPECT_THAT(message_of("path: {segments: [{frames: 60000}, {frames: 60000}]}"), HasSubstr("shorten"));
  EXPECT_THAT(message_of("{"), HasSubstr("room.yaml:"));
  EXPECT_THAT(message_of("5"), HasSubstr("key: value"));
  EXPECT_THROW(read_scene("no/such/file.yaml"), std::runtime_error);
}

TEST(SceneGenerator, IsVariedAndRepeatable) {
  EXPECT_EQ(scene_to_yaml(generate_scene(5)), scene_to_yaml(generate_scene(5)));
  EXPECT_NE(scene_to_yaml(generate_scene(5)), scene_to_yaml(generate_scene(6)));
  std::size_t obstacles = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) obstacles += generate_scene(seed).obstacles.size();
  EXPECT_GT(obstacles, 3u * 50);
}

}  // namespace
}  // namespace floorline::render
