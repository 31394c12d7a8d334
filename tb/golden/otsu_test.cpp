#include "golden/otsu.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "test_image.h"

namespace floorline::golden {
namespace {

/// eq. (11) of every cut, in exact integers; the first greatest. (N s - q S)^2 / (q (N - q)) compared by
/// cross multiplication.
int exhaustive(const cv::Mat& image) {
  std::array<long, 256> histogram{};
  for (auto pixel = image.begin<uchar>(); pixel != image.end<uchar>(); ++pixel) ++histogram[*pixel];
  const long n = static_cast<long>(image.total());
  long sum = 0;
  for (int level = 0; level < 256; ++level) sum += level * histogram[level];
  int best = 0;
  long below = 0, below_sum = 0;
  __int128 best_numerator = 0, best_denominator = 1;
  for (int t = 0; t < 256; ++t) {
    below += histogram[t];
    below_sum += t * histogram[t];
    if (below == 0 || below == n) continue;
    const __int128 spread = static_cast<__int128>(n) * below_sum - static_cast<__int128>(below) * sum;
    const __int128 numerator = spread * spread;
    const __int128 denominator = static_cast<__int128>(below) * (n - below);
    if (numerator * best_denominator > best_numerator * denominator) {
      best = t;
      best_numerator = numerator;
      best_denominator = denominator;
    }
  }
  return best;
}

TEST(Otsu, IsTheBestCutOfAllImages) {
  for (int seed = 1; seed <= 50; ++seed) {
    cv::Mat image = random_image({64, 48}, CV_8UC1, 40 + 4 * seed, seed);
    image(cv::Rect(0, 0, seed, 48)) *= 0.3;
    EXPECT_EQ(otsu(image), exhaustive(image)) << seed;
  }
}

TEST(Otsu, TakesTheLowestThresholdOfACut) {
  cv::Mat image(10, 10, CV_8UC1, cv::Scalar(20));
  image.rowRange(0, 4).setTo(90);
  EXPECT_EQ(otsu(image), 20);
}

TEST(Otsu, IsZeroWithoutTwoClasses) {
  for (const int level : {0, 77, 255})
    EXPECT_EQ(otsu(cv::Mat(10, 10, CV_8UC1, cv::Scalar(level))), 0) << level;
}

TEST(Otsu, SplitsAnImageAsOpenCvDoes) {
  const cv::Mat image = random_image({80, 60}, CV_8UC1, 200, 9) / 3;
  cv::Mat expected;
  cv::threshold(image, expected, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  EXPECT_TRUE(equal(image > otsu(image), expected));
}

}  // namespace
}  // namespace floorline::golden
