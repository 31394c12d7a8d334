#include "host/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "host/error.h"
#include "host/text_file.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

/// Decoders fill what is missing of a truncated file with grey, so its end is looked at.
bool truncated(std::string_view content) {
  using namespace std::literals;
  if (content.starts_with("\x89PNG"sv)) return !content.ends_with("IEND\xae\x42\x60\x82"sv);
  // Cameras append data of their own to JPEG files; the end marker is within.
  if (content.starts_with("\xff\xd8"sv)) return content.rfind("\xff\xd9"sv) == std::string_view::npos;
  return false;
}

}  // namespace

cv::Mat read_image(const fs::path& file) {
  std::string content = read_text(file);
  if (truncated(content))
    throw Error(fmt::format("{}: the image is truncated; copy it again.", file.string()));
  cv::Mat image;
  if (!content.empty()) {
    const cv::Mat bytes(1, static_cast<int>(content.size()), CV_8U, content.data());
    image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  }
  if (image.empty()) throw Error(fmt::format("{}: is no image; give a PNG or JPEG file.", file.string()));
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3) {
    throw Error(fmt::format("{}: has {} channels of {} bits; convert it to 8-bit grey or colour.",
                            file.string(), image.channels(), 8 * image.elemSize1()));
  }
  return image;
}

std::vector<fs::path> image_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") files.push_back(entry.path());
  }
  if (files.empty()) {
    throw Error(fmt::format("{}: holds no PNG or JPEG images; give the folder that does.", folder.string()));
  }
  std::ranges::sort(files);
  return files;
}

void require_same_format(const cv::Mat& image, const cv::Mat& first, const std::string& name) {
  if (image.size() != first.size()) {
    throw Error(fmt::format("{}: is {}x{} while the images before are {}x{}; use images of one size.", name,
                            image.cols, image.rows, first.cols, first.rows));
  }
  if (image.type() != first.type()) {
    const auto kind = [](const cv::Mat& m) { return m.channels() == 1 ? "grey" : "in colour"; };
    throw Error(fmt::format("{}: is {} while the images before are {}; convert them to one kind.", name,
                            kind(image), kind(first)));
  }
}

}  // namespace floorline
