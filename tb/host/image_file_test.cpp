#include "host/image_file.h"

#include <opencv2/imgcodecs.hpp>

#include "host/text_file.h"
#include "test_files.h"

namespace floorline {
namespace {

/// Writes noise, which leaves no long runs in the file, so that a cut loses pixels.
cv::Mat write_noise(const std::filesystem::path& file, int type) {
  cv::Mat image(48, 64, type);
  cv::RNG(3).fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::imwrite(file.string(), image);
  return image;
}

void cut(const std::filesystem::path& file, double share) {
  const std::string content = read_text(file);
  write_text(file, content.substr(0, static_cast<std::size_t>(share * static_cast<double>(content.size()))));
}

TEST(ReadImage, KeepsGreyAndColour) {
  const TemporaryFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat image = write_noise(folder / "a.png", type);
    const cv::Mat read = read_image(folder / "a.png");
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0);
  }
}

TEST(ReadImage, RefusesATruncatedFile) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.jpg"}) {
    for (const double share : {0.5, 0.95}) {
      write_noise(folder / name, CV_8UC1);
      EXPECT_NO_THROW(read_image(folder / name));
      cut(folder / name, share);
      EXPECT_REFUSED(read_image(folder / name), "is truncated; copy it again");
    }
  }
}

TEST(ReadImage, TakesNoThumbnailForTheEndOfAJpeg) {
  const TemporaryFolder folder;
  write_noise(folder / "a.jpg", CV_8UC1);
  const std::string image = read_text(folder / "a.jpg");
  const std::string thumbnail =
      std::string("\xff\xe1\x00\x04\xff\xd9", 6);  // A segment that holds an end marker.
  write_text(folder / "a.jpg", image.substr(0, 2) + thumbnail + image.substr(2));
  EXPECT_NO_THROW(read_image(folder / "a.jpg"));
  cut(folder / "a.jpg", 0.9);
  EXPECT_REFUSED(read_image(folder / "a.jpg"), "is truncated");
}

TEST(ReadImage, RefusesADamagedFile) {
  const TemporaryFolder folder;
  write_noise(folder / "a.png", CV_8UC1);
  std::string content = read_text(folder / "a.png");
  content[content.size() / 2] ^= 1;
  write_text(folder / "a.png", content);
  testing::internal::CaptureStderr();
  EXPECT_REFUSED(read_image(folder / "a.png"), "is damaged; copy it again");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "the sentence is ours alone";
  write_text(folder / "b.jpg", "\xff\xd8 and no segments");
  EXPECT_REFUSED(read_image(folder / "b.jpg"), "is truncated");
}

TEST(ReadImage, RefusesAHugeImageBeforeItIsDecoded) {
  const TemporaryFolder folder;
  for (const char* name : {"wide.png", "wide.jpg"}) {
    cv::imwrite((folder / name).string(), cv::Mat::zeros(1, 2048, CV_8U));
    EXPECT_REFUSED(read_image(folder / name), "is 2048x1; scale it to at most 2047 pixels a side");
  }
}

TEST(ReadImage, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  EXPECT_REFUSED(read_image(folder / "none.png"), "none.png: cannot be read");
  write_text(folder / "text.png", "no image");
  EXPECT_REFUSED(read_image(folder / "text.png"), "is no image");
  write_text(folder / "empty.png", "");
  EXPECT_REFUSED(read_image(folder / "empty.png"), "is no image");
  write_noise(folder / "deep.png", CV_16UC1);
  EXPECT_REFUSED(read_image(folder / "deep.png"), "has 1 channels of 16 bits");
  write_noise(folder / "alpha.png", CV_8UC4);
  EXPECT_REFUSED(read_image(folder / "alpha.png"), "has 4 channels of 8 bits");
}

TEST(ImageFiles, AreSortedAndOnlyImages) {
  const TemporaryFolder folder;
  for (const char* name : {"b.png", "a.jpg", "c.jpeg", "notes.txt"}) write_text(folder / name, "");
  EXPECT_THAT(image_files(folder.path()),
              testing::ElementsAre(folder / "a.jpg", folder / "b.png", folder / "c.jpeg"));
  EXPECT_REFUSED(image_files(folder / "none"), "holds no PNG or JPEG images");
}

TEST(SameFormat, RefusesOtherSizesAndKinds) {
  const cv::Mat first(48, 64, CV_8UC1);
  EXPECT_NO_THROW(require_same_format(cv::Mat(48, 64, CV_8UC1), first, "frame 3"));
  EXPECT_REFUSED(require_same_format(cv::Mat(48, 63, CV_8UC1), first, "frame 3"), "frame 3: is 63x48");
  EXPECT_REFUSED(require_same_format(cv::Mat(48, 64, CV_8UC3), first, "frame 3"), "is in colour while");
}

}  // namespace
}  // namespace floorline
