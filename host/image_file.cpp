#include "host/image_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>

#include "host/camera.h"
#include "host/error.h"
#include "host/text_file.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

/// What is known of an image before it is decoded. Decoders fill what is missing of a truncated file with
/// grey, and allocate whatever size it claims, so both are looked at first.
struct Outline {
  bool complete = false;
  bool damaged = false;
  std::uint32_t width = 0, height = 0;
};

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

/// Whether the check sums of all chunks agree. libpng would find out too, and print a line of its own.
bool png_intact(std::string_view content) {
  constexpr std::size_t signature = 8, frame = 12;  // A chunk: length, name, data, check sum.
  std::size_t at = signature;
  while (at + frame <= content.size()) {
    const std::size_t length = big_endian(content.substr(at, 4));
    if (length > content.size() - at - frame) return false;
    const auto* checked = reinterpret_cast<const Bytef*>(content.data() + at + 4);
    if (crc32(0, checked, static_cast<uInt>(length + 4)) != big_endian(content.substr(at + 8 + length, 4)))
      return false;
    at += frame + length;
  }
  return at == content.size();
}

Outline png_outline(std::string_view content) {
  constexpr std::size_t header_end =
      24;  // Signature, then length, name, width and height of the first chunk.
  if (content.size() < header_end || !content.ends_with("IEND\xae\x42\x60\x82")) return {};
  return {true, !png_intact(content), big_endian(content.substr(16, 4)), big_endian(content.substr(20, 4))};
}

/// Walks the segments to the pixel data: thumbnails within a segment have an end marker too.
Outline jpeg_outline(std::string_view content) {
  constexpr std::string_view end_marker = "\xff\xd9";
  Outline outline;
  std::size_t at = 2;
  while (at + 9 <= content.size()) {
    const auto marker = static_cast<unsigned char>(content[at + 1]);
    // Where decoders would search for the next segment, the walk ends: they must not find another size.
    const bool without_length = marker < 0xc0 || (marker >= 0xd0 && marker <= 0xd9);
    if (content[at] != '\xff' || without_length) break;
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) {
      outline.height = big_endian(content.substr(at + 5, 2));
      outline.width = big_endian(content.substr(at + 7, 2));
    }
    if (marker == 0xda) {
      // Cameras append data of their own, so the end marker need not be the last.
      outline.complete = content.find(end_marker, at) != std::string_view::npos;
      break;
    }
    at += marker == 0xff ? 1 : 2 + big_endian(content.substr(at + 2, 2));
  }
  return outline;
}

cv::Mat decode(std::string& content) {
  try {
    const cv::Mat bytes(1, static_cast<int>(content.size()), CV_8U, content.data());
    return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace

cv::Mat read_image(const fs::path& file) {
  std::string content = read_text(file);
  const bool png = content.starts_with("\x89PNG");
  if (!png && !content.starts_with("\xff\xd8"))
    throw Error(fmt::format("{}: is no image; give a PNG or JPEG file.", file.string()));
  const Outline outline = png ? png_outline(content) : jpeg_outline(content);
  if (!outline.complete)
    throw Error(fmt::format("{}: the image is truncated; copy it again.", file.string()));
  if (std::max(outline.width, outline.height) > largest_side) {
    throw Error(fmt::format("{}: is {}x{}; scale it to at most {} pixels a side.", file.string(),
                            outline.width, outline.height, largest_side));
  }
  const cv::Mat image = outline.damaged ? cv::Mat() : decode(content);
  if (image.empty()) throw Error(fmt::format("{}: is damaged; copy it again.", file.string()));
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
