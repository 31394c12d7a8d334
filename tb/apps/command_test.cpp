/// The floorline command as a user meets it: exit codes, messages, files, and what is left after a failure.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

struct Outcome {
  int code;
  std::string out, err;
};

/// A folder with a tiny rendered sequence and settings that fit it, made once; each test works in a copy.
class CommandTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    template_ = fs::path(testing::TempDir()) / "floorline_command_template";
    fs::remove_all(template_);
    fs::create_directories(template_);
    write(template_ / "scene.yaml",
          "name: tiny\nimage: {width: 64, height: 48, samples: 1}\ncamera: {focal_px: 42}\n"
          "obstacles:\n  - {kind: box, position: [1.6, 0.1], size: [0.3, 0.5, 0.4]}\n"
          "path: {segments: [{frames: 6, step_m: 0.06}]}\n");
    write(template_ / "settings.yaml",
          "line_count: 40\nmin_rows: 2\nroi_margin_rows: 2\nreference_every: 1\n");
    const Outcome rendered = run_in(template_, "render scene.yaml --output sequence");
    ASSERT_EQ(rendered.code, 0) << rendered.err;
  }
  static void TearDownTestSuite() { fs::remove_all(template_); }

  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("floorline_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::copy(template_, folder_, fs::copy_options::recursive);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Runs `prefix floorline arguments` with `folder` as the working directory.
  static Outcome run_in(const fs::path& folder, const std::string& arguments,
                        const std::string& prefix = "") {
    const fs::path out = fs::path(testing::TempDir()) / "floorline_stdout",
                   err = fs::path(testing::TempDir()) / "floorline_stderr";
    const std::string line = "cd '" + folder.string() + "' && " + prefix + " " + FLOORLINE_COMMAND + " " +
                             arguments + " >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), text_of(out), text_of(err)};
  }
  Outcome run(const std::string& arguments, const std::string& prefix = "") const {
    return run_in(folder_, arguments, prefix);
  }

  /// Bad input: exit code 3 and one sentence that names what is wrong.
  void expect_refused(const std::string& arguments, const std::string& words) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(outcome.err.substr(0, 7), "error: ");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }

  /// The same for the sequence as the test left it; nothing may have been written.
  void expect_sequence_refused(const std::string& words) const {
    const std::size_t before = entries(folder_);
    expect_refused("golden sequence --settings settings.yaml --output found", words);
    EXPECT_EQ(entries(folder_), before);
  }

  fs::path frame(int index) const {
    return folder_ / "sequence" / "frames" / ("00000" + std::to_string(index) + ".png");
  }

  void replace_in(const char* file, const std::string& old_text, const std::string& new_text) const {
    std::string text = text_of(folder_ / "sequence" / file);
    const std::size_t at = text.find(old_text);
    ASSERT_NE(at, std::string::npos);
    write(folder_ / "sequence" / file, text.replace(at, old_text.size(), new_text));
  }

  /// Lines of odometry.csv, the header first.
  std::vector<std::string> odometry_lines() const {
    std::ifstream in(folder_ / "sequence" / "odometry.csv");
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line + "\n");
    return lines;
  }
  void write_odometry(const std::vector<std::string>& lines) const {
    std::string text;
    for (const std::string& line : lines) text += line;
    write(folder_ / "sequence" / "odometry.csv", text);
  }

  static fs::path template_;
  fs::path folder_;
};

fs::path CommandTest::template_;

TEST_F(CommandTest, EverySubcommandShowsExamples) {
  EXPECT_NE(run("--help").out.find("Exit codes:"), std::string::npos);
  for (const std::string name : {"import", "render", "golden", "csim", "check", "score", "report"}) {
    const Outcome help = run(name + " --help");
    EXPECT_EQ(help.code, 0) << name;
    EXPECT_NE(help.out.find("Examples:\n"), std::string::npos) << name;
  }
}

TEST_F(CommandTest, BadUsageIsTwo) {
  for (const std::string line : {"", "fly", "check", "render --output x", "render --seeds 5..2 --output x",
                                 "render --seed 1 --seeds 1..2 --output x", "check sequence --rule best",
                                 "import images sequence/frames --output x", "golden sequence --stages"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 2) << line << outcome.err;
    EXPECT_NE(outcome.err.find("--help' shows how"), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(folder_ / "x"));
}

TEST_F(CommandTest, ChecksTheSequenceWithAVerdict) {
  const Outcome outcome = run("check sequence --settings settings.yaml --json check.json");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const json facts = json::parse(text_of(folder_ / "check.json"));
  EXPECT_EQ(facts["verdict"], "ok");
  EXPECT_EQ(facts["frames"], 6);
  EXPECT_EQ(facts["figures"].back()["name"], "contacts_within_1px");
  EXPECT_EQ(facts["figures"].size(), 13u);
}

TEST_F(CommandTest, JsonOnStdoutMovesTheTextToStderr) {
  const Outcome outcome = run("csim sequence --settings settings.yaml --json -");
  EXPECT_EQ(json::parse(outcome.out)["frames"], 6);
  EXPECT_NE(outcome.err.find("frames a second"), std::string::npos);
}

TEST_F(CommandTest, BothModelsWriteTablesAndStages) {
  for (const std::string model : {"golden", "csim"}) {
    ASSERT_EQ(run(model + " sequence --settings settings.yaml --output " + model + " --stages").code, 0);
    EXPECT_EQ(text_of(folder_ / model / "contacts.csv").substr(0, 29), "frame,mature,line,u,v,rows,cl")
        << model;
    EXPECT_TRUE(fs::exists(folder_ / model / "obstacles.csv"));
    for (const char* stage :
         {"luma", "frame_ring", "difference", "displacement", "gaussian", "binarize", "erode", "roi"})
      EXPECT_EQ(entries(folder_ / model / "stages" / stage), 6u) << stage;
  }
  const cv::Mat golden =
      cv::imread((folder_ / "golden/stages/difference/000004.png").string(), cv::IMREAD_GRAYSCALE);
  const cv::Mat csim =
      cv::imread((folder_ / "csim/stages/difference/000004.png").string(), cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(golden.size(), cv::Size(64, 48));
  EXPECT_GT(cv::countNonZero(csim), 0);
}

TEST_F(CommandTest, ScoreMissesABoundWhenNothingIsDetected) {
  write(folder_ / "blind.yaml", "line_count: 0\nreference_every: 1\n");
  const Outcome outcome = run("score sequence --settings blind.yaml --json score.json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const json facts = json::parse(text_of(folder_ / "score.json"));
  EXPECT_EQ(facts["verdict"], "short");
  EXPECT_EQ(facts["figures"][0]["name"], "frame.recall");
  EXPECT_EQ(facts["figures"][0]["value"], 0.0);
}

TEST_F(CommandTest, ReportIsOneFile) {
  write(folder_ / "hardware.json",
        R"([{"title": "Cycles a frame", "columns": ["stage", "cycles"], "rows": [["polar", 12345]]}])");
  const Outcome outcome =
      run("report sequence --settings settings.yaml --output out/page.html --picture out/page.png --hardware "
          "hardware.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(entries(folder_ / "out"), 2u);
  const std::string page = text_of(folder_ / "out/page.html");
  for (const char* part :
       {"Cycles a frame", "12345", "each frame: recall", "\"frame_ring\"", "threshold_low"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_FALSE(cv::imread((folder_ / "out/page.png").string()).empty());
}

TEST_F(CommandTest, ImportsImages) {
  ASSERT_EQ(run("import images sequence/frames --camera sequence/camera.yaml --mount sequence/mount.yaml "
                "--odometry sequence/odometry.csv "
                "--output copy")
                .code,
            0);
  EXPECT_EQ(run("check copy --settings settings.yaml").code, 0);
  expect_refused("score copy --settings settings.yaml", "no ground truth");
}

TEST_F(CommandTest, KeepsWhatIsThereUnlessForced) {
  expect_refused("render scene.yaml --output sequence", "is there already");
  EXPECT_EQ(run("render scene.yaml --output sequence --force").code, 0);
  EXPECT_EQ(entries(folder_), 3u);
}

TEST_F(CommandTest, RefusesAMissingImage) {
  fs::remove(frame(2));
  expect_sequence_refused("000002.png");
}

TEST_F(CommandTest, RefusesATruncatedImage) {
  fs::resize_file(frame(2), fs::file_size(frame(2)) / 2);
  expect_sequence_refused("000002.png");
}

TEST_F(CommandTest, RefusesAnImageOfAnotherSize) {
  cv::imwrite(frame(3).string(), cv::Mat(40, 64, CV_8UC1, cv::Scalar(9)));
  expect_sequence_refused("64x40");
}

TEST_F(CommandTest, RefusesColourWhereGreyIsDue) {
  cv::imwrite(frame(3).string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(9, 99, 199)));
  expect_sequence_refused("colour");
}

TEST_F(CommandTest, RefusesASingularCamera) {
  const std::string text = text_of(folder_ / "sequence/camera.yaml");
  const std::size_t at = text.find("data: [") + 8;
  write(folder_ / "sequence/camera.yaml", text.substr(0, at) + "0.0" + text.substr(text.find(',', at)));
  expect_sequence_refused("camera.yaml");
}

TEST_F(CommandTest, RefusesAMountThatIsNotFinite) {
  write(folder_ / "sequence/mount.yaml",
        "robot_from_camera: [.nan, 0, 1, 0, -1, 0, 0, 0, 0, -1, 0, 0.5, 0, 0, 0, 1]\n");
  expect_sequence_refused("mount.yaml");
}

TEST_F(CommandTest, RefusesACameraThatSeesNoFloor) {
  // Looks straight up.
  write(folder_ / "sequence/mount.yaml",
        "robot_from_camera: [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1]\n");
  expect_sequence_refused("floor");
}

TEST_F(CommandTest, RefusesOdometryWithAGap) {
  std::vector<std::string> lines = odometry_lines();
  lines.erase(lines.begin() + 3);
  write_odometry(lines);
  expect_sequence_refused("odometry.csv");
}

TEST_F(CommandTest, RefusesOdometryOutOfOrder) {
  std::vector<std::string> lines = odometry_lines();
  std::swap(lines[2], lines[4]);
  write_odometry(lines);
  expect_sequence_refused("odometry.csv");
}

TEST_F(CommandTest, RefusesLinesThatCannotKeepUp) {
  write(folder_ / "settings.yaml", "line_count: 60\n");
  expect_sequence_refused("lines");
}

TEST_F(CommandTest, RefusesAFolderThatIsNoSequence) { expect_refused("check .", "sequence.yaml"); }

TEST_F(CommandTest, RefusesSettingsThatItDoesNotKnow) {
  for (const auto& [yaml, words] : std::vector<std::pair<std::string, std::string>>{
           {"line_cuont: 9\n", "'line_cuont' is no setting"},
           {"line_count: many\n", "'line_count' has a value of the wrong kind"},
           {"line_count: 999\n", "'line_count' must lie between 0 and 256"},
           {"rule: best\n", "'rule' has a value of the wrong kind"},
           {"- 1\n", "no YAML mapping"}}) {
    write(folder_ / "settings.yaml", yaml);
    expect_sequence_refused(words);
  }
}

TEST_F(CommandTest, RefusesASceneThatItDoesNotKnow) {
  write(folder_ / "scene.yaml", "image: {widht: 64}\n");
  expect_refused("render scene.yaml --output other", "widht");
  EXPECT_FALSE(fs::exists(folder_ / "other"));
}

TEST_F(CommandTest, FullDiskLeavesNothing) {
  const std::size_t before = entries(folder_);
  // A file-size limit of 4 KiB stands for the full disk.
  const Outcome outcome =
      run("report sequence --settings settings.yaml --output page.html", "trap '' XFSZ; ulimit -f 8;");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("page.html: cannot be written"), std::string::npos) << outcome.err;
  EXPECT_EQ(entries(folder_), before);
}

TEST_F(CommandTest, InterruptLeavesNothing) {
  write(folder_ / "scene.yaml",
        "image: {width: 64, height: 48}\npath: {segments: [{frames: 5000, step_m: 0.0001}]}\n");
  const std::size_t before = entries(folder_);
  // --foreground: one signal. Otherwise timeout also sends it to its process group, and a second Ctrl-C ends
  // at once.
  const Outcome outcome =
      run("render scene.yaml --output long", "timeout --foreground --preserve-status -s INT 1");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(outcome.err, "error: interrupted; nothing half-written was left.\n");
  EXPECT_EQ(entries(folder_), before);
}

TEST_F(CommandTest, MountIsFittedToTheImages) {
  const Outcome fitted = run("mount sequence --output fitted.yaml --json -");
  ASSERT_EQ(fitted.code, 0) << fitted.err;
  const json facts = json::parse(fitted.out);
  EXPECT_LE(facts["fitted"]["residual"], facts["before"]["residual"]);
  EXPECT_NEAR(facts["fitted"]["height_m"].get<double>(), facts["before"]["height_m"].get<double>(), 0.1);
  EXPECT_NE(text_of(folder_ / "fitted.yaml").find("robot_from_camera"), std::string::npos);
}

}  // namespace
