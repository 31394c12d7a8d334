#include "hls/otsu.h"

#include <array>
#include <cmath>

#include "golden/otsu.h"
#include "image_stream.h"

namespace floorline {
namespace {

/// Otsu by its definition in integers of 128 bits: the lowest of the best thresholds, 0 without two classes.
int exact_otsu(const cv::Mat& image) {
  std::array<long long, 256> histogram{};
  for (auto level = image.begin<uchar>(); level != image.end<uchar>(); ++level) ++histogram[*level];
  const long long total = static_cast<long long>(image.total());
  long long total_sum = 0;
  for (int t = 0; t < 256; ++t) total_sum += t * histogram[t];

  int best = 0;
  unsigned __int128 best_square = 0, best_product = 1;
  long long below = 0, below_sum = 0;
  for (int t = 0; t < 256; ++t) {
    below += histogram[t];
    below_sum += t * histogram[t];
    if (below == 0 || below == total) continue;
    const __int128 deviation =
        static_cast<__int128>(total) * below_sum - static_cast<__int128>(below) * total_sum;
    const unsigned __int128 square = deviation * deviation;
    const unsigned __int128 product = static_cast<unsigned __int128>(below) * (total - below);
    if (square * best_product > best_square * product) {
      best = t;
      best_square = square;
      best_product = product;
    }
  }
  return best;
}

/// The threshold that the kernel finds on `image`; it comes with the next frame, here one of a single pixel.
int run(const cv::Mat& image) {
  hls::stream<Pixel> in("pixels");
  hls::stream<Pixel> out("pixels passed on");
  hls::stream<Pixel> thresholds("thresholds");
  send(image, in);
  otsu<640, 480>(in, out, thresholds, image.cols, image.rows);
  EXPECT_TRUE(in.empty());
  EXPECT_EQ(greatest_difference(receive(image.size(), out), image), 0) << "the pixels pass unchanged";
  thresholds.read();

  in.write(0);
  otsu<640, 480>(in, out, thresholds, 1, 1);
  out.read();
  const int threshold = thresholds.read().to_int();
  EXPECT_TRUE(thresholds.empty());
  return threshold;
}

/// Images whose threshold is not the exact one.
int mismatches(const std::vector<NamedImage>& images) {
  int count = 0;
  for (const auto& [name, image] : images) {
    const int found = run(image);
    const int expected = exact_otsu(image);
    EXPECT_EQ(found, expected) << name;
    if (found != expected) ++count;
  }
  return count;
}

TEST(Otsu, IsExactOnSyntheticImages) { expect_figure("otsu_mismatches", mismatches(synthetic_images()), 0); }

TEST(Otsu, IsExactOnRealImages) {
  FLOORLINE_REAL_IMAGES_OR_SKIP(images);
  expect_figure("otsu_mismatches_real", mismatches(images), 0);
}

TEST(Otsu, EqualsGoldenOnRealImages) {
  FLOORLINE_REAL_IMAGES_OR_SKIP(images);
  for (const auto& [name, image] : images) EXPECT_EQ(run(image), golden::otsu(image)) << name;
}

TEST(Otsu, ImagesOfAFewPixelsAreExact) {
  cv::RNG random(5);
  for (int i = 0; i < 3000; ++i) {
    cv::Mat image(1, random.uniform(1, 7), CV_8UC1);
    random.fill(image, cv::RNG::UNIFORM, 0, random.uniform(2, 257));
    ASSERT_EQ(run(image), exact_otsu(image)) << image;
  }
}

/// Levels 0 to 255 whose variance hardly hangs on the threshold: a tail that falls with the square of the
/// level.
TEST(Otsu, ManyContendersAreComparedExactly) {
  for (const double scale : {1e4, 1e5, 3e5}) {
    std::vector<uchar> pixels(200000, 0);
    for (int level = 1; level < 256; ++level) {
      const int count = static_cast<int>(scale / (level * level * level));
      pixels.insert(pixels.end(), std::min<std::size_t>(count, 640 * 480 - pixels.size()),
                    static_cast<uchar>(level));
    }
    pixels.resize(pixels.size() / 640 * 640);
    const cv::Mat image(static_cast<int>(pixels.size() / 640), 640, CV_8UC1, pixels.data());
    EXPECT_EQ(run(image), exact_otsu(image)) << scale;
  }
}

TEST(Otsu, ScoresAreWithinTheProvenError) {
  double worst = 0;
  const auto check = [&](unsigned long x) {
    const double found = otsu_scan::logarithm<44>(x).to_double();
    worst = std::max(worst, std::abs(found - std::ldexp(std::log2(x), 19)));
  };
  for (unsigned long x = 1; x < 1 << 20; ++x) check(x);
  cv::RNG random(8);
  for (int i = 0; i < 1000000; ++i)
    check(((static_cast<unsigned long>(random.next()) << 32 | random.next()) >> 20 | 1) >>
              random.uniform(0, 43) |
          1);
  expect_figure("otsu_score_error", worst, otsu_scan::LOGARITHM_ERROR);
}

TEST(Otsu, OfEqualSplitsTheLowestIsTaken) {
  const cv::Mat symmetric = (cv::Mat_<uchar>(1, 3) << 10, 20, 30);
  EXPECT_EQ(run(symmetric), 10);
}

TEST(Otsu, BilevelImagesSplitAtTheLowerLevel) {
  for (const auto& [low, high] : {std::pair(0, 255), {0, 1}, {254, 255}, {10, 200}}) {
    const cv::Mat image = (cv::Mat_<uchar>(1, 4) << high, low, low, high);
    EXPECT_EQ(run(image), low);
  }
}

TEST(Otsu, ASingleGreyLevelGivesZero) {
  for (const int level : {0, 7, 255}) EXPECT_EQ(run(cv::Mat(9, 5, CV_8UC1, cv::Scalar(level))), 0) << level;
}

TEST(Otsu, AThresholdBelongsToTheFrameBefore) {
  hls::stream<Pixel> in("pixels");
  hls::stream<Pixel> out("pixels passed on");
  hls::stream<Pixel> thresholds("thresholds");
  std::vector<cv::Mat> frames;
  for (int i = 0; i < 6; ++i) frames.push_back(noise({40 + i, 30}, i) / (i + 1));
  run(cv::Mat::zeros(1, 1, CV_8UC1));
  int before = 0;
  for (const cv::Mat& frame : frames) {
    send(frame, in);
    otsu<640, 480>(in, out, thresholds, frame.cols, frame.rows);
    receive(frame.size(), out);
    EXPECT_EQ(thresholds.read().to_int(), before);
    before = golden::otsu(frame);
  }
}

}  // namespace
}  // namespace floorline
