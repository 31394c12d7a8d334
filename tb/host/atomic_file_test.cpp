#include "host/atomic_file.h"

#include <sys/resource.h>

#include <csignal>
#include <opencv2/imgcodecs.hpp>

#include "host/text_file.h"
#include "test_files.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

/// Files cannot grow beyond some bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_;
  sighandler_t handler_;
};

std::size_t entries(const fs::path& folder) { return std::distance(fs::directory_iterator(folder), {}); }

TEST(WriteFile, ReplacesTheContent) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "first, and longer");
  write_file(folder / "a.txt", "second");
  EXPECT_EQ(read_text(folder / "a.txt"), "second");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(WriteFile, OnAFullDiskTheFormerContentStays) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "former");
  {
    const FullDisk full(1000);
    EXPECT_REFUSED(write_file(folder / "a.txt", std::string(100000, 'x')), "free some space");
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "former");
  EXPECT_EQ(entries(folder.path()), 1u) << "no partial file is left";
}

TEST(WriteFile, WritesToADevice) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/null", folder / "null");
  fs::create_symlink("/dev/full", folder / "full");
  EXPECT_NO_THROW(write_file(folder / "null", "gone"));
  EXPECT_REFUSED(write_file(folder / "full", "x"), "cannot be written (No space left on device)");
  EXPECT_TRUE(fs::is_character_file(folder / "null"));
  EXPECT_TRUE(fs::is_character_file(folder / "full"));
}

TEST(WriteFile, NamesAFolderThatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_REFUSED(write_file(folder / "none/a.txt", "x"),
                 "none/a.txt: cannot be written (No such file or directory)");
}

TEST(WriteFile, DoesNotReplaceAFolder) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "a/b");
  EXPECT_REFUSED(write_file(folder / "a", "x"), "cannot be written");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(WriteImage, WritesWhatIsReadBack) {
  const TemporaryFolder folder;
  cv::Mat image(7, 9, CV_8UC3);
  cv::randu(image, 0, 256);
  write_image(folder / "a.png", image);
  EXPECT_EQ(cv::norm(cv::imread((folder / "a.png").string()), image, cv::NORM_INF), 0);
}

TEST(StagedFolder, AppearsWhenCommitted) {
  const TemporaryFolder folder;
  {
    StagedFolder staged(folder / "out/");
    write_file(staged.path() / "a.txt", "x");
    EXPECT_FALSE(fs::exists(folder / "out"));
    staged.commit();
  }
  EXPECT_EQ(read_text(folder / "out/a.txt"), "x");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(StagedFolder, LeavesNothingWhenDropped) {
  const TemporaryFolder folder;
  {
    write_file(StagedFolder(folder / "out").path() / "a.txt", "x");
  }
  EXPECT_EQ(entries(folder.path()), 0u);
}

TEST(StagedFolder, DoesNotTouchWhatIsThere) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "out");
  EXPECT_REFUSED(StagedFolder(folder / "out"), "is there already");
  write_text(folder / "file", "");
  EXPECT_REFUSED(StagedFolder(folder / "file/out"), "cannot be written");
  StagedFolder late(folder / "late");
  fs::create_directories(folder / "late/occupied");
  EXPECT_REFUSED(late.commit(), "cannot be written");
}

}  // namespace
}  // namespace floorline
