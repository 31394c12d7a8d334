#include "hls/frame_ring.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "golden/frame_ring.h"
#include "image_stream.h"

namespace floorline {
namespace {

constexpr int kMaxWidth = 64;
constexpr int kMaxHeight = 48;
constexpr int kMargin = 8;

/// Most that the kernel's coordinates may differ from real ones, in pixels.
constexpr double kCoordinateBound = 0.05;
/// What it really is on frames of up to 64 columns, with a margin.
constexpr double kSmallFrameError = 0.004;

ProjectiveMap pack(const cv::Matx33d& homography, cv::Size size) {
  const cv::Matx33d from_middle(1, 0, -(size.width / 2), 0, 1, -(size.height / 2), 0, 0, 1);
  const cv::Matx33d h = from_middle * homography;
  const auto fixed = [](double value, int fraction) {
    return ap_int<32>(std::llround(std::ldexp(value, fraction)));
  };
  ProjectiveMap map;
  map.xu = fixed(h(0, 0), 18), map.xv = fixed(h(0, 1), 18), map.x1 = fixed(h(0, 2), 18);
  map.yu = fixed(h(1, 0), 18), map.yv = fixed(h(1, 1), 18), map.y1 = fixed(h(1, 2), 18);
  map.zu = fixed(h(2, 0), 28), map.zv = fixed(h(2, 1), 28), map.z1 = fixed(h(2, 2), 28);
  return map;
}

cv::Matx33d shift(double x, double y) { return {1, 0, x, 0, 1, y, 0, 0, 1}; }

/// A ground homography as a forward motion with a little rotation gives it, Z about 1 at the image centre.
cv::Matx33d random_homography(cv::RNG& random, cv::Size size) {
  const auto about = [&](double centre, double spread) { return centre + random.uniform(-spread, spread); };
  const double extent = std::max(size.width, size.height);
  const cv::Matx33d h(about(1, 0.1), about(0, 0.1), about(0, 0.05 * extent),  //
                      about(0, 0.1), about(1, 0.1), about(0, 0.05 * extent),  //
                      about(0, 0.4 / extent), about(0, 0.4 / extent), 1);
  return h * (1 / (h(2, 0) * size.width / 2 + h(2, 1) * size.height / 2 + 1));
}

/// The kernel after reset, and the number of null pixels of its last frame.
template <int MAX_WIDTH, int MAX_HEIGHT, int MARGIN>
class Kernel {
 public:
  static constexpr int ring_rows = MAX_HEIGHT + MARGIN;

  /// Frames of two sizes without replacement drop whatever reference an earlier test left.
  Kernel() {
    pair(cv::Mat::zeros(1, 1, CV_8UC1), shift(0, 0), false);
    pair(cv::Mat::zeros(1, 2, CV_8UC1), shift(0, 0), false);
  }

  golden::PixelPairs pair(const cv::Mat& image, const cv::Matx33d& homography, bool replace) {
    hls::stream<Pixel> in("pixels");
    hls::stream<PixelPair> out("pairs");
    hls::stream<ap_uint<24>> nulls("null pixels");
    send(image, in);
    frame_ring<MAX_WIDTH, MAX_HEIGHT, MARGIN>(in, out, nulls, image.cols, image.rows, replace,
                                              pack(homography, image.size()));
    EXPECT_TRUE(in.empty());
    null_pixels = nulls.read().to_int();
    EXPECT_TRUE(nulls.empty());

    golden::PixelPairs pairs;
    for (cv::Mat* part : {&pairs.current, &pairs.reference, &pairs.gradient, &pairs.valid}) {
      part->create(image.size(), CV_8UC1);
    }
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        const PixelPair pair = out.read();
        pairs.current.at<uchar>(v, u) = pair.current.to_int();
        pairs.reference.at<uchar>(v, u) = pair.reference.to_int();
        pairs.gradient.at<uchar>(v, u) = pair.gradient.to_int();
        pairs.valid.at<uchar>(v, u) = pair.valid ? 255 : 0;
      }
    }
    EXPECT_TRUE(out.empty());
    EXPECT_EQ(null_pixels, image.size().area() - cv::countNonZero(pairs.valid));
    return pairs;
  }

  int null_pixels = 0;
};

using SmallKernel = Kernel<kMaxWidth, kMaxHeight, kMargin>;

/// 255 where a coordinate that is off by no more than kSmallFrameError may be rounded to another step of the
/// interpolation.
cv::Mat undecided(const cv::Matx33d& h, cv::Size size) {
  cv::Mat mask(size, CV_8UC1);
  const auto near_step = [&](double x) {
    constexpr int steps = 64;
    const double rounded = steps * x + 0.5;
    return std::abs(rounded - std::round(rounded)) <= steps * kSmallFrameError;
  };
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const cv::Vec3d p = h * cv::Vec3d(u, v, 1);
      mask.at<uchar>(v, u) = near_step(p[0] / p[2]) || near_step(p[1] / p[2]) ? 255 : 0;
    }
  }
  return mask;
}

void expect_equal(golden::PixelPairs found, golden::PixelPairs expected, const cv::Mat& ignored) {
  for (golden::PixelPairs* pairs : {&found, &expected}) {
    for (cv::Mat* part : {&pairs->reference, &pairs->gradient, &pairs->valid}) part->setTo(0, ignored);
  }
  EXPECT_EQ(greatest_difference(found.current, expected.current), 0);
  EXPECT_EQ(greatest_difference(found.valid, expected.valid), 0);
  EXPECT_EQ(greatest_difference(found.reference, expected.reference), 0);
  EXPECT_EQ(greatest_difference(found.gradient, expected.gradient), 0);
}

/// Whole steps of the interpolation, which both sides hold exactly.
const double kQuarter = 0.25;

TEST(FrameRing, TheFirstFrameHasNoValidPixel) {
  SmallKernel kernel;
  const golden::PixelPairs pairs = kernel.pair(noise({20, 10}, 1), shift(0, 0), true);
  EXPECT_EQ(cv::countNonZero(pairs.valid), 0);
  EXPECT_EQ(cv::countNonZero(pairs.reference | pairs.gradient), 0);
  EXPECT_EQ(kernel.null_pixels, 200);
}

TEST(FrameRing, ShiftsEqualGoldenAtEverySizeAndBorder) {
  for (const cv::Size size :
       {cv::Size(1, 1), {2, 2}, {3, 3}, {1, 9}, {9, 1}, {17, 5}, {16, 16}, {64, 48}, {63, 47}}) {
    SmallKernel kernel;
    golden::FrameRing golden(SmallKernel::ring_rows);
    int seed = 0;
    for (const auto& [x, y] :
         {std::pair(0.0, 0.0), {0.0, 0.0}, {2.0, 0.0}, {-1.0, 3.0}, {-5.0, -2.0}, {0.0, 20.0}}) {
      for (const double quarter_x : {-kQuarter, kQuarter}) {
        const cv::Mat image = noise(size, ++seed);
        const cv::Matx33d h = shift(x + quarter_x, y + kQuarter);
        SCOPED_TRACE(testing::Message() << size << " by " << x + quarter_x << ", " << y + kQuarter);
        expect_equal(kernel.pair(image, h, true), golden.pair(image, h, true), cv::Mat::zeros(size, CV_8UC1));
      }
    }
  }
}

TEST(FrameRing, HomographiesEqualGoldenOverManyFrames) {
  SmallKernel kernel;
  golden::FrameRing golden(SmallKernel::ring_rows);
  cv::RNG random(11);
  for (int frame = 0; frame < 200; ++frame) {
    const cv::Size size(kMaxWidth, kMaxHeight - frame / 50);
    const cv::Mat image = noise(size, frame);
    const cv::Matx33d h = random_homography(random, size);
    const bool replace = random.uniform(0, 3) > 0;
    SCOPED_TRACE(testing::Message() << "frame " << frame << (replace ? " replaces" : " holds"));
    expect_equal(kernel.pair(image, h, replace), golden.pair(image, h, replace), undecided(h, size));
  }
}

TEST(FrameRing, FullVgaFollowsGolden) {
  static Kernel<640, 480, 32> kernel;
  golden::FrameRing golden(kernel.ring_rows);
  cv::RNG random(4);
  for (int frame = 0; frame < 4; ++frame) {
    const cv::Size size(640, 480);
    // A coordinate that is off by the bound, on a slope of a few grey levels a pixel, is a grey level at
    // most.
    cv::Mat image;
    cv::GaussianBlur(noise(size, frame), image, {0, 0}, 5);
    const cv::Matx33d h = random_homography(random, size);
    const golden::PixelPairs found = kernel.pair(image, h, true), expected = golden.pair(image, h, true);
    const cv::Mat both = found.valid & expected.valid;
    EXPECT_LE(cv::countNonZero(found.valid != expected.valid), size.width + size.height) << "border pixels";
    EXPECT_EQ(greatest_difference(found.current, expected.current), 0);
    EXPECT_LE(greatest_difference(found.reference & both, expected.reference & both), 1);
  }
}

TEST(FrameRing, AHeldReferenceStaysWhole) {
  SmallKernel kernel;
  const cv::Size size(40, kMaxHeight);
  const cv::Mat reference = noise(size, 1);
  kernel.pair(reference, shift(0, 0), true);
  for (int frame = 0; frame < 3; ++frame) {
    const golden::PixelPairs pairs = kernel.pair(noise(size, 2 + frame), shift(0, 0), false);
    EXPECT_EQ(greatest_difference(pairs.reference, reference), 0);
    EXPECT_EQ(kernel.null_pixels, 0);
  }
}

TEST(FrameRing, AReplacingFrameLosesRowsBeyondTheMargin) {
  SmallKernel kernel;
  const cv::Size size(40, kMaxHeight);
  kernel.pair(noise(size, 1), shift(0, 0), true);
  const golden::PixelPairs kept = kernel.pair(noise(size, 2), shift(0, 1 - kMargin), true);
  EXPECT_EQ(cv::countNonZero(kept.valid), 40 * (kMaxHeight - kMargin + 1))
      << "only rows above the image are lost";
  const golden::PixelPairs lost = kernel.pair(noise(size, 3), shift(0, -kMargin), true);
  EXPECT_EQ(cv::countNonZero(lost.valid), 0);
}

TEST(FrameRing, AChangedSizeDropsTheReference) {
  SmallKernel kernel;
  const cv::Size size(40, 30), other(30, 40);
  kernel.pair(noise(size, 1), shift(0, 0), true);
  EXPECT_EQ(cv::countNonZero(kernel.pair(noise(other, 2), shift(0, 0), false).valid), 0);
  EXPECT_EQ(cv::countNonZero(kernel.pair(noise(size, 3), shift(0, 0), false).valid), 0)
      << "dropped, not kept aside";
  EXPECT_EQ(cv::countNonZero(kernel.pair(noise(size, 4), shift(0, 0), true).valid), 0);
  EXPECT_EQ(cv::countNonZero(kernel.pair(noise(size, 5), shift(0, 0), true).valid), size.area());
}

TEST(FrameRing, DenominatorsOutOfRangeGiveNullPixels) {
  SmallKernel kernel;
  const cv::Size size(20, 20);
  kernel.pair(noise(size, 1), shift(0, 0), true);
  for (const double z : {-1.0, 0.0, 1.0 / 16}) {
    const cv::Matx33d h(z, 0, 0, 0, z, 0, 0, 0, z);
    EXPECT_EQ(cv::countNonZero(kernel.pair(noise(size, 2), h, false).valid), 0) << z;
  }
  const cv::Matx33d h(7.9, 0, 2, 0, 7.9, 2, 0, 0, 7.9);
  EXPECT_EQ(cv::countNonZero(kernel.pair(noise(size, 2), h, false).valid), size.area());
}

/// Greatest distance between the kernel's coordinates, before they are rounded, and real ones.
double worst_coordinate(const cv::Matx33d& h, cv::Size size) {
  const ProjectiveMap map = pack(h, size);
  LinearWalk x_walk(map.x1 + 64, map.xu, map.xv), y_walk(map.y1 + 64, map.yu, map.yv),
      z_walk(map.z1 - 1, map.zu, map.zv);
  double worst = 0;
  for (RasterPosition<2048, 2048> at(size.width, size.height); at.inside; at.advance()) {
    const cv::Vec3d p = h * cv::Vec3d(at.u.to_int(), at.v.to_int(), 1);
    const cv::Point2d exact(p[0] / p[2], p[1] / p[2]);
    const Reciprocal denominator = reciprocal(z_walk.value);
    if (denominator.valid && cv::Rect2d(-0.5, -0.5, size.width, size.height).contains(exact)) {
      // 11 fraction bits, rounded down.
      const auto coordinate = [&](const LinearWalk& walk, int middle) {
        return middle + (quotient<13>(walk.value >> 7, denominator).to_double() + 0.5) / 2048;
      };
      const double x = coordinate(x_walk, size.width / 2), y = coordinate(y_walk, size.height / 2);
      worst = std::max({worst, std::abs(x - exact.x), std::abs(y - exact.y)});
    }
    x_walk.advance(at.at_row_end());
    y_walk.advance(at.at_row_end());
    z_walk.advance(at.at_row_end());
  }
  return worst;
}

TEST(FrameRing, WholePixelShiftsKeepTheirCell) {
  static Kernel<2048, 4, 2> kernel;
  golden::FrameRing golden(kernel.ring_rows);
  const cv::Size size(2048, 4);
  for (int frame = 0; frame < 3; ++frame) {
    const cv::Mat image = noise(size, frame);
    expect_equal(kernel.pair(image, shift(frame, 0), true), golden.pair(image, shift(frame, 0), true),
                 cv::Mat::zeros(size, CV_8UC1));
  }
}

TEST(FrameRing, CoordinatesAreWithinTheBound) {
  cv::RNG random(3);
  double worst = 0;
  for (int i = 0; i < 10; ++i) {
    for (const cv::Size size : {cv::Size(640, 480), cv::Size(1280, 384)}) {
      worst = std::max(worst, worst_coordinate(random_homography(random, size), size));
    }
  }
  expect_figure("frame_ring_coordinate_error_px", worst, kCoordinateBound);
}

}  // namespace
}  // namespace floorline
