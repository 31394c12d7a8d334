#include "image_uri.h"

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace floorline::report {
namespace {

std::string base64(const std::vector<unsigned char>& bytes) {
  static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? alphabet[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// quality: 1 to 100, or 101 for lossless.
std::string webp_uri(const cv::Mat& picture, int quality) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".webp", picture, bytes, {cv::IMWRITE_WEBP_QUALITY, quality}))
    throw std::runtime_error("a picture of the report could not be encoded as WebP.");
  return data_uri("image/webp", bytes);
}

}  // namespace

std::string data_uri(std::string_view media_type, const std::vector<unsigned char>& bytes) {
  return "data:" + std::string(media_type) + ";base64," + base64(bytes);
}

std::string lossless_uri(const cv::Mat& picture) { return webp_uri(picture, 101); }

std::string photograph_uri(const cv::Mat& picture) { return webp_uri(picture, 80); }

}  // namespace floorline::report
