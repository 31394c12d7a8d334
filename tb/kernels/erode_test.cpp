#include "hls/erode.h"

#include "golden/erode.h"
#include "image_stream.h"

namespace floorline {
namespace {

cv::Mat run(const golden::Masks& masks, bool erode_high) {
  hls::stream<Mask> in("masks");
  hls::stream<Mask> out("eroded");
  send(packed(masks), in);
  erode<640, 480>(in, out, masks.high.cols, masks.high.rows, erode_high);
  EXPECT_TRUE(in.empty());
  return receive(masks.high.size(), out);
}

/// Images whose eroded masks differ from golden's anywhere.
int mismatches(const std::vector<NamedImage>& images) {
  int count = 0;
  for (const auto& [name, image] : images) {
    const golden::Masks masks = golden::binarize(image, 100, 50);
    const bool equal = greatest_difference(run(masks, true), packed(golden::erode(masks))) == 0;
    EXPECT_TRUE(equal) << name;
    if (!equal) ++count;
  }
  return count;
}

TEST(Erode, EqualsGoldenOnSyntheticImages) {
  expect_figure("erode_mismatches", mismatches(synthetic_images()), 0);
}

TEST(Erode, EqualsGoldenOnRealImages) {
  FLOORLINE_REAL_IMAGES_OR_SKIP(images);
  expect_figure("erode_mismatches_real", mismatches(images), 0);
}

TEST(Erode, TheBorderDoesNotEatASetImage) {
  const golden::Masks set = golden::binarize(cv::Mat(6, 9, CV_8UC1, cv::Scalar(255)), 0, 0);
  EXPECT_EQ(greatest_difference(run(set, true), packed(set)), 0);
}

TEST(Erode, PassesWhenSwitchedOff) {
  const golden::Masks masks = golden::binarize(noise({50, 40}, 3), 128, 40);
  EXPECT_EQ(greatest_difference(run(masks, false), packed(masks)), 0);
}

}  // namespace
}  // namespace floorline
