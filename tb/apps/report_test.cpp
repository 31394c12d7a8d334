/// The report as a library: the page holds all it needs, and hardware files are checked.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "report/hardware.h"
#include "report/html.h"
#include "report/picture.h"

namespace floorline::report {
namespace {

namespace fs = std::filesystem;

Document small_document() {
  Document document;
  document.title = "room <1> & more";
  document.image_width = 64;
  document.image_height = 48;
  document.figures = {{"contacts", "Contact points within 1 px", 0.995, Relation::at_least, 0.99, ""},
                      {"gaussian", "Gaussian, worst pixel", 2, Relation::at_most, 1, "LSB"}};
  document.stages = {{"difference", "What moved.", 64, {}}};
  Frame frame;
  frame.camera = cv::Mat(48, 64, CV_8UC1, cv::Scalar(90));
  frame.stages = {{frame.camera, frame.camera, cv::Mat::zeros(48, 64, CV_8UC1), "identical"}};
  frame.kernel_contacts = {{30, 20, false}};
  frame.obstacles = {{2.0, 0.1}};
  document.frames = {frame, frame};
  document.frames[1].obstacles.push_back({1.0, 0.4});
  document.field_of_view = {{0.5, 0.3}, {4, 2}, {4, -2}, {0.5, -0.3}};
  return document;
}

/// The JSON inside a page.
nlohmann::json page_data(const std::string& page) {
  const std::string open = "id=\"report-data\">";
  const std::size_t first = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
}

class HardwareFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  nlohmann::json read(const std::string& content) {
    std::ofstream(folder_ / "hardware.json") << content;
    return read_hardware(folder_ / "hardware.json");
  }

  std::string message(const std::string& content) {
    try {
      read(content);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST(ReportPage, HoldsEverythingItShows) {
  const std::string page = to_html(small_document());
  for (const char* reference : {"src=\"", "url(http", "@import", "<link"})
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  const nlohmann::json data = page_data(page);
  ASSERT_EQ(data["frames"].size(), 2u);
  for (const char* picture : {"kernel", "golden", "difference"})
    EXPECT_EQ(data["frames"][0]["stages"][0][picture].get<std::string>().substr(0, 11), "data:image/")
        << picture;
}

TEST(ReportPage, EscapesTheTitleAndScriptEnds) {
  Document document = small_document();
  document.subtitle = "</script><b>";
  const std::string page = to_html(document);
  EXPECT_NE(page.find("<title>room &lt;1> &amp; more</title>"), std::string::npos);
  EXPECT_EQ(page_data(page)["subtitle"], "</script><b>");
}

TEST(ReportPage, TellsWhichFigureIsShort) {
  const nlohmann::json figures = page_data(to_html(small_document()))["figures"];
  EXPECT_EQ(figures[0]["verdict"], "ok");
  EXPECT_EQ(figures[0]["bound"], "≥ 0.99");
  EXPECT_EQ(figures[1]["verdict"], "short");
  EXPECT_EQ(figures[1]["value"], "2 LSB");
}

TEST(ReportPage, ShrinksWidePicturesButKeepsLoneDifferences) {
  Document document = small_document();
  cv::Mat difference = cv::Mat::zeros(300, 1280, CV_8UC1);
  difference.at<uchar>(101, 333) = 255;
  const cv::Mat wide(300, 1280, CV_8UC1, cv::Scalar(5));
  document.frames[0].stages = {{wide, wide, difference, ""}};
  document.frames[1].stages = {{wide, wide, cv::Mat::zeros(300, 1280, CV_8UC1), ""}};
  const nlohmann::json frames = page_data(to_html(document))["frames"];
  EXPECT_NE(frames[0]["stages"][0]["difference"], frames[1]["stages"][0]["difference"]);
}

TEST(Figure, NotANumberIsShort) {
  const Figure figure{"recall", "Recall", NAN, Relation::at_least, 0.9, ""};
  EXPECT_FALSE(figure.ok());
  EXPECT_TRUE(to_json(figure)["value"].is_null());
}

TEST(Histogram, OutliersCountInTheOuterBins) {
  const Histogram histogram = make_histogram("error", "m", {-1, 0.1, 0.9, 7}, 0, 1, 4);
  EXPECT_EQ(histogram.counts, (std::vector<int>{2, 0, 0, 2}));
  EXPECT_EQ(histogram.note, "4 values, median 0.9 m, greatest 7 m");
}

TEST(Picture, TakesTheFrameWithMostObstacles) {
  const Document document = small_document();
  EXPECT_EQ(liveliest_frame(document), 1u);
  const cv::Mat picture = compose_picture(document, 1, "difference");
  EXPECT_GT(picture.cols, picture.rows);
  EXPECT_THROW(compose_picture(document, 0, "lens"), std::logic_error);
}

TEST_F(HardwareFile, EmbedsPicturesThatLieBesideIt) {
  std::ofstream(folder_ / "cycles.svg") << "<svg/>";
  const nlohmann::json sections = read(
      R"([{"title": "Cycles", "columns": ["stage", "cycles"], "rows": [["polar", 12]], "picture": "cycles.svg"}])");
  EXPECT_EQ(sections[0]["picture"], "data:image/svg+xml;base64,PHN2Zy8+");
  EXPECT_EQ(sections[0]["rows"][0][1], 12);
}

TEST_F(HardwareFile, SaysWhatIsWrong) {
  EXPECT_NE(message("{").find("not a JSON list of sections"), std::string::npos);
  EXPECT_NE(message("[{}]").find("a \"title\""), std::string::npos);
  EXPECT_NE(message(R"([{"title": "Cycles", "columns": ["stage"], "rows": [[1, 2]]}])")
                .find("each row of section 'Cycles'"),
            std::string::npos);
  EXPECT_NE(message(R"([{"title": "Cycles", "picture": "none.svg"}])").find("cannot be read"),
            std::string::npos);
  EXPECT_NE(message(R"([{"title": "Cycles", "picture": "a.gif"}])").find("neither .svg nor .png"),
            std::string::npos);
  EXPECT_THROW(read_hardware(folder_ / "missing.json"), std::runtime_error);
}

}  // namespace
}  // namespace floorline::report
