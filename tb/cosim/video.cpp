#include "tb/cosim/video.h"

namespace floorline::cosim {

void queue_video(const cv::Mat& image, int first, int end, std::deque<VideoBeat>& queue) {
  for (int v = first; v < end; ++v) {
    const uchar* row = image.ptr(v);
    for (int u = 0; u < image.cols; ++u) {
      const uchar* bgr = row + 3 * u;
      const std::uint32_t data =
          image.channels() == 1 ? row[u] : std::uint32_t{bgr[2]} << 16 | bgr[0] << 8 | bgr[1];
      queue.push_back({data, u == 0 && v == 0, u == image.cols - 1});
    }
  }
}

}  // namespace floorline::cosim
