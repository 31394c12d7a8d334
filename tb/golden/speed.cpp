/// Frames a second of the golden pipeline on one core: VGA in colour, every stage. Prints the number.
#include <chrono>
#include <cstdio>

#include "golden/pipeline.h"
#include "scene.h"

int main() {
  using namespace floorline::golden;
  constexpr int frames = 40;
  const cv::Size size(640, 480);
  cv::setNumThreads(1);
  std::vector<cv::Mat> images;
  for (int frame = 0; frame < frames; ++frame) {
    cv::cvtColor(view(size, frame, {280, 120, 120, 140}), images.emplace_back(), cv::COLOR_GRAY2BGR);
  }
  Parameters parameters = parameters_of(size);
  parameters.erode_high = true;
  Pipeline pipeline(size.height + 32);
  const auto start = std::chrono::steady_clock::now();
  for (const cv::Mat& image : images) pipeline.process(image, parameters);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%.1f\n", frames / seconds.count());
}
