/// Folders and files for tests of readers and writers.
#ifndef FLOORLINE_TB_HOST_TEST_FILES_H
#define FLOORLINE_TB_HOST_TEST_FILES_H

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "host/error.h"

namespace floorline {

/// A folder that goes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string name =
        std::string(test->test_suite_name()) + "." + test->name() + "." + std::to_string(getpid());
    path_ = std::filesystem::temp_directory_path() / ("floorline." + name);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// Real data that is not part of the project; tests skip without it.
inline std::filesystem::path shared_data(const std::string& name) {
  return std::filesystem::path(FLOORLINE_SHARED_DATA) / name;
}

}  // namespace floorline

/// The statement throws Error with a message that holds `part`.
#define EXPECT_REFUSED(statement, part) \
  EXPECT_THAT([&] { statement; }, testing::ThrowsMessage<floorline::Error>(testing::HasSubstr(part)))

#define SKIP_WITHOUT_SHARED_DATA(name) \
  if (!std::filesystem::exists(shared_data(name))) GTEST_SKIP() << "needs " << shared_data(name)

#endif
