#include "hls/roi.h"

#include "golden/roi.h"
#include "image_stream.h"

namespace floorline {
namespace {

cv::Mat run(const golden::Masks& masks, int first_row, int last_row) {
  hls::stream<Mask> in("masks");
  hls::stream<Mask> out("region");
  send(packed(masks), in);
  roi<640, 480>(in, out, masks.high.cols, masks.high.rows, first_row, last_row);
  EXPECT_TRUE(in.empty());
  return receive(masks.high.size(), out);
}

TEST(Roi, EqualsGolden) {
  const golden::Masks masks = golden::binarize(noise({17, 12}, 1), 100, 50);
  for (const auto& [first, last] :
       {std::pair(0, 11), {3, 8}, {5, 5}, {0, 0}, {11, 11}, {4, 2000}, {12, 20}}) {
    EXPECT_EQ(greatest_difference(run(masks, first, last), packed(golden::roi(masks, first, last))), 0)
        << first << " to " << last;
  }
}

TEST(Roi, NothingPassesWhenTheRowsAreReversed) {
  const golden::Masks masks = golden::binarize(noise({17, 12}, 1), 0, 0);
  EXPECT_EQ(cv::countNonZero(run(masks, 8, 3)), 0);
}

}  // namespace
}  // namespace floorline
