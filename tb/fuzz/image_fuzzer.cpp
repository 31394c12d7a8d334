/// The reader of frames and masks.
#include "host/image_file.h"
#include "reader_contract.h"

namespace fuzz = floorline::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  file.fill(data, size);
  fuzz::load_or_refuse([] {
    const cv::Mat image = floorline::read_image(file.path());
    if (image.empty() || (image.type() != CV_8UC1 && image.type() != CV_8UC3))
      fuzz::finding("an image that no stage can take");
  });
  return 0;
}
