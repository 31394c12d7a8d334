/// Output that is either complete or not there: written under another name, then renamed.
#ifndef FLOORLINE_HOST_ATOMIC_FILE_H
#define FLOORLINE_HOST_ATOMIC_FILE_H

#include <filesystem>
#include <opencv2/core.hpp>
#include <string_view>

namespace floorline {

/// Writes `content` to `file`, which keeps its former content until the new one is complete. A device or
/// a pipe is written to. Throws Error when it cannot, for example because the disk is full; no partial file
/// is left.
void write_file(const std::filesystem::path& file, std::string_view content);

/// The same for an image, encoded by the extension of the name (.png).
void write_image(const std::filesystem::path& file, const cv::Mat& image);

/// A folder that appears under its name only when commit() is called; dropped, it leaves nothing behind.
class StagedFolder {
 public:
  /// Throws Error when `folder` is there already or nothing can be created beside it.
  explicit StagedFolder(std::filesystem::path folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Where to put the files until then.
  const std::filesystem::path& path() const { return staging_; }
  void commit();

 private:
  std::filesystem::path folder_;
  std::filesystem::path staging_;
};

}  // namespace floorline

#endif
