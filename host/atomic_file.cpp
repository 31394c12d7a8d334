#include "host/atomic_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "host/error.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

/// A name beside `target` that no other process uses.
fs::path staging_name(const fs::path& target) {
  return target.parent_path() / fmt::format(".{}.{}.partial", target.filename().string(), getpid());
}

/// False, and errno, when not all of it has met the disk.
bool write_bytes(const fs::path& file, std::string_view content) {
  std::ofstream out(file, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();  // Only now the last bytes have met the disk.
  return !out.fail();
}

[[noreturn]] void refuse(const fs::path& target, const std::string& reason) {
  throw Error(fmt::format("{}: cannot be written ({}); free some space or choose another place.",
                          target.string(), reason));
}

}  // namespace

void write_file(const fs::path& file, std::string_view content) {
  // A device or a pipe is written to; what is staged beside it would take its place.
  if (fs::exists(file) && !fs::is_regular_file(file)) {
    if (!write_bytes(file, content)) refuse(file, std::strerror(errno));
    return;
  }
  const fs::path staging = staging_name(file);
  std::error_code failure;
  if (write_bytes(staging, content)) {
    fs::rename(staging, file, failure);
    if (!failure) return;
  }
  const std::string reason = failure ? failure.message() : std::strerror(errno);
  fs::remove(staging, failure);
  refuse(file, reason);
}

void write_image(const fs::path& file, const cv::Mat& image) {
  std::vector<uchar> encoded;
  cv::imencode(file.extension().string(), image, encoded, {cv::IMWRITE_PNG_COMPRESSION, 1});
  write_file(file, {reinterpret_cast<const char*>(encoded.data()), encoded.size()});
}

StagedFolder::StagedFolder(fs::path folder) : folder_(std::move(folder)) {
  if (folder_.filename().empty()) folder_ = folder_.parent_path();
  if (fs::exists(folder_)) {
    throw Error(fmt::format("{}: is there already; remove it or choose another name.", folder_.string()));
  }
  staging_ = staging_name(folder_);
  std::error_code failure;
  fs::create_directories(staging_, failure);
  if (failure) refuse(folder_, failure.message());
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

void StagedFolder::commit() {
  std::error_code failure;
  fs::rename(staging_, folder_, failure);
  if (failure) refuse(folder_, failure.message());
}

}  // namespace floorline
