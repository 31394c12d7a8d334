/// Reading of image files: whole or not at all.
#ifndef FLOORLINE_HOST_IMAGE_FILE_H
#define FLOORLINE_HOST_IMAGE_FILE_H

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

namespace floorline {

/// An 8-bit image, CV_8UC1 or CV_8UC3 (B G R). Throws Error when the file is missing, truncated, no image,
/// larger than any camera may be, or of another depth or number of channels.
cv::Mat read_image(const std::filesystem::path& file);

/// The .png, .jpg and .jpeg files of a folder by name. Throws Error when the folder is missing or holds none.
std::vector<std::filesystem::path> image_files(const std::filesystem::path& folder);

/// Throws Error when `image` differs from `first` in size or in being grey or colour; `name` is how the
/// message calls it.
void require_same_format(const cv::Mat& image, const cv::Mat& first, const std::string& name);

}  // namespace floorline

#endif
