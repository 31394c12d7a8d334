#include "hls/difference.h"

#include "golden/difference.h"
#include "image_stream.h"

namespace floorline {
namespace {

/// The differences; expects that `changes` carries them too, with the gradients.
cv::Mat run(const golden::PixelPairs& pairs) {
  hls::stream<PixelPair> in("pairs");
  hls::stream<Pixel> out("difference");
  hls::stream<Change> changes("changes");
  const cv::Size size = pairs.current.size();
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      PixelPair pair;
      pair.current = pairs.current.at<uchar>(v, u);
      pair.reference = pairs.reference.at<uchar>(v, u);
      pair.gradient = pairs.gradient.at<uchar>(v, u);
      pair.valid = pairs.valid.at<uchar>(v, u) != 0;
      in.write(pair);
    }
  }
  difference<640, 480>(in, out, changes, size.width, size.height);
  EXPECT_TRUE(in.empty());
  const cv::Mat differences = receive(size, out);
  int unlike = 0;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const Change change = changes.read();
      unlike += change.difference != differences.at<uchar>(v, u) ||
                change.gradient != pairs.gradient.at<uchar>(v, u);
    }
  }
  EXPECT_EQ(unlike, 0);
  EXPECT_TRUE(changes.empty());
  return differences;
}

/// One pair in four is not valid.
golden::PixelPairs random_pairs(cv::Size size) {
  return {noise(size, 1), noise(size, 2), noise(size, 4), noise(size, 3) > 63};
}

TEST(Difference, EqualsGolden) {
  int worst = 0;
  for (const cv::Size size : {cv::Size(1, 1), {17, 5}, {640, 480}}) {
    const golden::PixelPairs pairs = random_pairs(size);
    worst = std::max(worst, greatest_difference(run(pairs), golden::difference(pairs)));
  }
  expect_figure("difference_error_lsb", worst, 0);
}

TEST(Difference, IsZeroWithoutCorrespondence) {
  golden::PixelPairs pairs = random_pairs({20, 10});
  pairs.valid = cv::Scalar(0);
  EXPECT_EQ(cv::countNonZero(run(pairs)), 0);
}

}  // namespace
}  // namespace floorline
