#include "hls/lens.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "golden/lens.h"
#include "image_stream.h"

namespace floorline {
namespace {

constexpr int kRadius = 20;

/// Most that the kernel's coordinates may differ from real ones, in pixels.
constexpr double kCoordinateBound = 0.05;

/// A camera: matrix and k1 k2 p1 p2 k3.
struct Camera {
  std::string name;
  cv::Size size;
  cv::Matx33d matrix;
  std::array<double, 5> distortion;
};

std::vector<Camera> cameras() {
  return {
      {"no distortion", {60, 40}, {50, 0, 30, 0, 50, 20, 0, 0, 1}, {0, 0, 0, 0, 0}},
      {"barrel", {160, 120}, {130, 0, 81.3, 0, 131, 58.9, 0, 0, 1}, {-0.28, 0.09, 0, 0, 0}},
      {"pincushion", {160, 120}, {150, 0, 79, 0, 150, 61, 0, 0, 1}, {0.2, 0.05, 0, 0, 0.01}},
      {"tangential", {160, 120}, {140, 0, 75, 0, 140, 66, 0, 0, 1}, {0, 0, 0.01, -0.02, 0}},
      {"off centre", {97, 35}, {60, 0, -10, 0, 60, 44, 0, 0, 1}, {-0.1, 0.01, 0.001, 0.002, 0}},
      {"as a cheap VGA camera",
       {640, 480},
       {517.3, 0, 318.6, 0, 516.5, 255.3, 0, 0, 1},
       {0.2624, -0.9531, -0.0054, 0.0026, 1.1633}},
  };
}

/// Parameters of the kernel for a camera, as LensParameters defines them.
LensParameters pack(const Camera& camera) {
  const double fx = camera.matrix(0, 0), fy = camera.matrix(1, 1), cx = camera.matrix(0, 2),
               cy = camera.matrix(1, 2);
  const auto [k1, k2, p1, p2, k3] = camera.distortion;
  double s = 0;
  for (const double u : {0, camera.size.width - 1}) {
    for (const double v : {0, camera.size.height - 1})
      s = std::max(s, std::hypot((u - cx) / fx, (v - cy) / fy));
  }
  const auto fixed = [](double value, int fraction) { return std::llround(std::ldexp(value, fraction)); };
  LensParameters lens;
  lens.x_first = fixed(-cx / fx / s, 30), lens.x_step = fixed(1 / fx / s, 30);
  lens.y_first = fixed(-cy / fy / s, 30), lens.y_step = fixed(1 / fy / s, 30);
  lens.skew_first = fixed(-2 * (p1 * cy / fy + p2 * cx / fx), 30);
  lens.skew_u = fixed(2 * p2 / fx, 30), lens.skew_v = fixed(2 * p1 / fy, 30);
  lens.radial1 = fixed(k1 * s * s, 21), lens.radial2 = fixed(k2 * std::pow(s, 4), 21);
  lens.radial3 = fixed(k3 * std::pow(s, 6), 21);
  lens.centre_u = fixed(cx, 6), lens.centre_v = fixed(cy, 6);
  lens.shift_u = fixed(p2 * fx * s * s, 16), lens.shift_v = fixed(p1 * fy * s * s, 16);
  return lens;
}

golden::Lens golden_lens(const Camera& camera, golden::Interpolation interpolation) {
  return golden::Lens(camera.matrix, camera.distortion, camera.size, interpolation);
}

template <bool BILINEAR>
cv::Mat run(const cv::Mat& image, const LensParameters& parameters) {
  hls::stream<Pixel> in("pixels");
  hls::stream<Pixel> out("rectified");
  send(image, in);
  lens<640, 480, kRadius, BILINEAR>(in, out, image.cols, image.rows, parameters);
  EXPECT_TRUE(in.empty());
  return receive(image.size(), out);
}

TEST(Lens, CoordinatesAreWithinTheBound) {
  double worst = 0;
  for (const Camera& camera : cameras()) {
    const golden::Lens exact = golden_lens(camera, golden::Interpolation::nearest);
    const LensParameters parameters = pack(camera);
    LensMap map(parameters);
    for (RasterPosition<2048, 2048> at(camera.size.width, camera.size.height); at.inside; at.advance()) {
      const LensPoint found = map.point(at.u, at.v, parameters);
      const cv::Point2d expected = exact.source(at.u.to_int(), at.v.to_int());
      const cv::Point2d error = cv::Point2d(found.x.to_double(), found.y.to_double()) / 256 - expected;
      worst = std::max({worst, std::abs(error.x), std::abs(error.y)});
      map.advance(at.at_row_end());
    }
  }
  expect_figure("lens_coordinate_error_px", worst, kCoordinateBound);
}

TEST(Lens, WithoutDistortionTheImagePasses) {
  const Camera camera = cameras()[0];
  const cv::Mat image = noise(camera.size, 1);
  EXPECT_EQ(greatest_difference(run<false>(image, pack(camera)), image), 0);
  EXPECT_EQ(greatest_difference(run<true>(image, pack(camera)), image), 0);
}

/// 255 where a coordinate that is off by no more than the bound may round to another pixel.
cv::Mat undecided(const golden::Lens& lens, cv::Size size) {
  cv::Mat mask(size, CV_8UC1);
  const auto near_half = [](double x) { return std::abs(x - 0.5 - std::round(x - 0.5)) <= kCoordinateBound; };
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const cv::Point2d p = lens.source(u, v);
      mask.at<uchar>(v, u) = near_half(p.x) || near_half(p.y) ? 255 : 0;
    }
  }
  return mask;
}

TEST(Lens, NearestEqualsGolden) {
  for (const Camera& camera : cameras()) {
    const golden::Lens golden = golden_lens(camera, golden::Interpolation::nearest);
    ASSERT_LE(golden.ring_radius(), kRadius) << camera.name;
    const cv::Mat image = noise(camera.size, 2);
    cv::Mat found = run<false>(image, pack(camera));
    cv::Mat expected = golden.rectify(image);
    const cv::Mat ignored = undecided(golden, camera.size);
    EXPECT_LT(cv::countNonZero(ignored), 0.25 * camera.size.area()) << camera.name;
    found.setTo(0, ignored);
    expected.setTo(0, ignored);
    EXPECT_EQ(greatest_difference(found, expected), 0) << camera.name;
  }
}

TEST(Lens, BilinearIsNearGoldenOnASmoothImage) {
  for (const Camera& camera : cameras()) {
    cv::Mat image(camera.size, CV_8UC1);
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        image.at<uchar>(v, u) = static_cast<uchar>(128 + 60 * std::sin(u * 0.1) + 60 * std::cos(v * 0.08));
      }
    }
    const cv::Mat expected = golden_lens(camera, golden::Interpolation::bilinear).rectify(image);
    // Where part of the cell is outside the image, a coordinate error meets an edge as high as the pixel
    // itself.
    const cv::Mat inside = expected > 0;
    cv::Mat border_free;
    cv::erode(inside, border_free, cv::Mat());
    cv::Mat found = run<true>(image, pack(camera));
    found.setTo(0, ~border_free);
    cv::Mat masked = expected.clone();
    masked.setTo(0, ~border_free);
    EXPECT_LE(greatest_difference(found, masked), 1) << camera.name;
  }
}

TEST(Lens, RowsBeyondTheRadiusReadZero) {
  Camera camera = cameras()[0];
  LensParameters parameters = pack(camera);
  parameters.centre_v = 0;
  parameters.radial1 = 0;
  parameters.shift_v = 0;
  parameters.skew_u = 0;
  parameters.skew_first = 1 << 30;  // every row v comes from row 2 v
  const cv::Mat image(camera.size, CV_8UC1, cv::Scalar(200));
  const cv::Mat found = run<false>(image, parameters);
  for (int v = 0; v < image.rows; ++v) {
    EXPECT_EQ(found.at<uchar>(v, 30), v <= kRadius && 2 * v < image.rows ? 200 : 0) << v;
  }
}

TEST(Lens, TinyImagesPass) {
  for (const cv::Size size : {cv::Size(1, 1), {2, 2}, {3, 3}, {1, 9}, {9, 1}}) {
    const cv::Mat image = noise(size, 5);
    const Camera camera = {"tiny", size, {100, 0, 0, 0, 100, 0, 0, 0, 1}, {0.1, 0, 0, 0, 0}};
    EXPECT_EQ(greatest_difference(run<false>(image, pack(camera)), image), 0) << size;
  }
}

}  // namespace
}  // namespace floorline
