#include "host/text_file.h"

#include "test_files.h"

namespace floorline {
namespace {

using testing::ElementsAre;

TEST(Split, CutsAtTheSeparatorAndTrims) {
  EXPECT_THAT(split("a, b ,,c\r", ','), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split("  a \t b  ", ' '), ElementsAre("a", "b"));
  EXPECT_THAT(split("", ' '), testing::IsEmpty());
}

TEST(FiniteNumber, IsAWholeField) {
  EXPECT_EQ(finite_number("-1.5e2"), -150);
  for (const char* text : {"", "1.5x", "nan", "inf", "--1", "1e999"})
    EXPECT_EQ(finite_number(text), std::nullopt) << text;
}

TEST(ReadNumbers, SkipsCommentsAndBlankLines) {
  const TemporaryFolder folder;
  write_text(folder / "a.txt", "# comment\n1 2\n\n3\t4\r\n");
  const std::vector<NumberRow> rows = read_numbers(folder / "a.txt", ' ', 2);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[1].values, ElementsAre(3, 4));
  EXPECT_EQ(rows[1].line, 4);
}

TEST(ReadNumbers, NamesFileLineAndFault) {
  const TemporaryFolder folder;
  write_text(folder / "a.csv", "a,b\n1,2\n1,x\n");
  EXPECT_REFUSED(read_numbers(folder / "a.csv", ',', 2, "a,b"),
                 "a.csv:3: 'x' is no finite number; correct the line.");
  write_text(folder / "a.csv", "a,b\n1,2,3\n");
  EXPECT_REFUSED(read_numbers(folder / "a.csv", ',', 2, "a,b"), "a.csv:2: there are 3 numbers instead of 2");
  write_text(folder / "a.csv", "1,2\n");
  EXPECT_REFUSED(read_numbers(folder / "a.csv", ',', 2, "a,b"), "a.csv:1: the header should be 'a,b'");
  EXPECT_REFUSED(read_numbers(folder / "none.csv", ',', 2), "none.csv: cannot be read");
  EXPECT_REFUSED(read_numbers(folder.path(), ',', 2), "cannot be read");
}

TEST(ReadText, RefusesWhatHasNoEnd) {
  EXPECT_REFUSED(read_text("/dev/zero"), "/dev/zero: is larger than 256 MiB; give the right file.");
}

TEST(Error, KeepsItsSentencePrintable) {
  EXPECT_STREQ(Error(std::string("a\0b\nc\x1b[2J", 9)).what(), "a?b?c?[2J");
}

}  // namespace
}  // namespace floorline
