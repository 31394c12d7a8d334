#include "hls/histogram.h"

#include <opencv2/imgproc.hpp>

#include "image_stream.h"

namespace floorline {
namespace {

TEST(Histogram, counts_the_levels_that_opencv_counts) {
  for (const NamedImage& named : synthetic_images()) {
    const cv::Mat& image = named.image;
    hls::stream<Pixel> in("pixels"), out("pixels passed on");
    HistogramTotals<640 * 480>::Count histogram[LEVELS] = {};
    send(image, in);
    const auto totals = count_levels<640, 480>(in, out, histogram, image.cols, image.rows);
    EXPECT_EQ(greatest_difference(receive(image.size(), out), image), 0) << "the pixels pass unchanged";
    EXPECT_EQ(totals.pixels.to_uint(), image.total());
    EXPECT_EQ(totals.sum.to_uint64(), cv::sum(image)[0]);

    cv::Mat expected;
    cv::calcHist(std::vector<cv::Mat>{image}, {0}, cv::noArray(), expected, {LEVELS}, {0, LEVELS});
    for (int level = 0; level < LEVELS; ++level)
      EXPECT_EQ(histogram[level].to_uint(), expected.at<float>(level)) << named.name << ", level " << level;
  }
}

}  // namespace
}  // namespace floorline
