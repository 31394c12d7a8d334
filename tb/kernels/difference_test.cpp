#include "hls/difference.h"

#include "golden/difference.h"
#include "image_stream.h"

namespace floorline {
namespace {

cv::Mat run(const golden::PixelPairs& pairs, bool tolerant) {
  hls::stream<PixelPair> in("pairs");
  hls::stream<Pixel> out("difference");
  for (int v = 0; v < pairs.current.rows; ++v) {
    for (int u = 0; u < pairs.current.cols; ++u) {
      PixelPair pair;
      pair.current = pairs.current.at<uchar>(v, u);
      pair.nearest = pairs.nearest.at<uchar>(v, u);
      pair.low = pairs.low.at<uchar>(v, u);
      pair.high = pairs.high.at<uchar>(v, u);
      pair.valid = pairs.valid.at<uchar>(v, u) != 0;
      in.write(pair);
    }
  }
  difference<640, 480>(in, out, pairs.current.cols, pairs.current.rows, tolerant);
  EXPECT_TRUE(in.empty());
  return receive(pairs.current.size(), out);
}

/// Random pairs with low <= nearest <= high, one in four not valid.
golden::PixelPairs random_pairs(cv::Size size) {
  golden::PixelPairs pairs = {noise(size, 1), noise(size, 2), {}, {}, noise(size, 3) > 63};
  pairs.low = cv::min(pairs.nearest, noise(size, 4));
  pairs.high = cv::max(pairs.nearest, noise(size, 5));
  return pairs;
}

TEST(Difference, EqualsGolden) {
  int worst = 0;
  for (const cv::Size size : {cv::Size(1, 1), {17, 5}, {640, 480}}) {
    const golden::PixelPairs pairs = random_pairs(size);
    for (const bool tolerant : {false, true}) {
      worst = std::max(worst, greatest_difference(run(pairs, tolerant), golden::difference(pairs, tolerant)));
    }
  }
  expect_figure("difference_error_lsb", worst, 0);
}

TEST(Difference, IsZeroWithoutCorrespondence) {
  golden::PixelPairs pairs = random_pairs({20, 10});
  pairs.valid = cv::Scalar(0);
  EXPECT_EQ(cv::countNonZero(run(pairs, false)), 0);
  EXPECT_EQ(cv::countNonZero(run(pairs, true)), 0);
}

}  // namespace
}  // namespace floorline
