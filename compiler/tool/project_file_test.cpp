#include "tool/project_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace hlsc {
namespace {

std::string written(const std::string& name, const std::string& text) {
  std::string path = (std::filesystem::temp_directory_path() / name).string();
  std::ofstream(path) << text;
  return path;
}

TEST(ProjectFile, ReadsAVitisConfig) {
  ProjectFile project = read_config(written("hlsc_project_test.cfg",
                                            "part=xc7z020clg400-1\n[hls]\nflow_target=vivado\nclock=125MHz\n"
                                            "syn.top=fir\nsyn.file=src/fir.cpp\nsyn.file=src/fir.h\n"
                                            "syn.cflags=-Iinclude -DTAPS=8 -std=c++14\ntb.file=fir_tb.cpp\n"
                                            "syn.directive.pipeline=fir/TAP II=2\n"));
  EXPECT_EQ(project.top, "fir");
  ASSERT_EQ(project.files.size(), 1u);
  EXPECT_EQ(std::filesystem::path(project.files[0]).filename(), "fir.cpp");
  EXPECT_EQ(project.defines, std::vector<std::string>{"TAPS=8"});
  EXPECT_EQ(project.standard, "c++14");
  EXPECT_EQ(project.target, "xc7");
  EXPECT_DOUBLE_EQ(project.period, 8);
  ASSERT_EQ(project.directives.size(), 1u);
  EXPECT_EQ(project.directives[0].label, "TAP");
  EXPECT_EQ(project.directives[0].text, "pipeline II=2");
}

TEST(ProjectFile, ReadsTclDirectives) {
  std::vector<PlacedDirective> directives = read_tcl_directives(
      written("hlsc_project_test.tcl",
              "# a comment\nset_directive_array_partition -type complete -dim 1 \"fir\" taps\n"
              "set_directive_pipeline -off \"fir/TAP\"\nopen_project fir\n"));
  ASSERT_EQ(directives.size(), 2u);
  EXPECT_EQ(directives[0].function, "fir");
  EXPECT_EQ(directives[0].variable, "taps");
  EXPECT_EQ(directives[0].text, "array_partition type=complete dim=1");
  EXPECT_EQ(directives[1].text, "pipeline off");
}

TEST(ProjectFile, RefusesAClockWithoutSense) {
  EXPECT_THROW(read_config(written("hlsc_project_test_clock.cfg", "clock=fast\n")), CompileError);
}

}  // namespace
}  // namespace hlsc
