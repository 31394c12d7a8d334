#include "hls/binarize.h"

#include "golden/binarize.h"
#include "image_stream.h"

namespace floorline {
namespace {

ThresholdParameters thresholds(int floor, int override_high, int low) {
  ThresholdParameters parameters;
  parameters.floor = floor;
  parameters.override_high = override_high;
  parameters.low = low;
  return parameters;
}

cv::Mat run(const cv::Mat& image, int otsu, const ThresholdParameters& parameters) {
  hls::stream<Pixel> in("pixels");
  hls::stream<Pixel> otsu_thresholds("thresholds");
  hls::stream<Mask> out("masks");
  hls::stream<Pixel> used("threshold_used");
  send(image, in);
  otsu_thresholds.write(otsu);
  binarize<640, 480>(in, otsu_thresholds, out, used, image.cols, image.rows, parameters);
  EXPECT_EQ(used.read(), high_threshold(otsu, parameters));
  EXPECT_TRUE(in.empty());
  EXPECT_TRUE(otsu_thresholds.empty());
  return receive(image.size(), out);
}

TEST(Binarize, EqualsGolden) {
  struct Case {
    int otsu, floor, override_high, low;
  };
  for (const auto& [name, image] : synthetic_images()) {
    for (const Case c : {Case{0, 0, 0, 0}, Case{90, 20, 0, 11}, Case{10, 20, 0, 11}, Case{90, 20, 60, 200},
                         Case{90, 255, 1, 255}, Case{255, 0, 0, 254}}) {
      const int high = golden::high_threshold({c.floor, c.override_high, c.low}, c.otsu);
      EXPECT_EQ(greatest_difference(run(image, c.otsu, thresholds(c.floor, c.override_high, c.low)),
                                    packed(golden::binarize(image, high, c.low))),
                0)
          << name << " otsu " << c.otsu;
    }
  }
}

TEST(Binarize, TheThresholdItselfIsNotAbove) {
  const cv::Mat pixels = (cv::Mat_<uchar>(1, 4) << 29, 30, 31, 255);
  const cv::Mat expected = (cv::Mat_<uchar>(1, 4) << 1, 1, 3, 3);
  EXPECT_EQ(greatest_difference(run(pixels, 30, thresholds(0, 0, 28)), expected), 0);
}

}  // namespace
}  // namespace floorline
