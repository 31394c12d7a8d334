/// hls::stream in C simulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ap_int.h"
#include "hls_stream.h"

namespace {

TEST(Stream, IsFirstInFirstOut) {
  hls::stream<int> s("numbers");
  int written = 0, read = 0;
  for (int burst = 1; burst < 100; ++burst) {  // grows while wrapped around
    for (int i = 0; i < burst; ++i) s.write(written++);
    for (int i = 0; i < burst / 2; ++i) ASSERT_EQ(s.read(), read++);
  }
  EXPECT_EQ(s.size(), static_cast<std::size_t>(written - read));
  while (!s.empty()) ASSERT_EQ(s.read(), read++);
  EXPECT_EQ(read, written);
}

TEST(Stream, HasTheVitisForms) {
  hls::stream<ap_uint<8>> s;
  ap_uint<8> x = 3, y = 0;
  s << x;
  s >> y;
  EXPECT_EQ(y, 3);
  s.write(4);
  s.read(y);
  EXPECT_EQ(y, 4);
  EXPECT_TRUE(s.empty() && !s.full());
  EXPECT_FALSE(s.read_nb(y));
  EXPECT_TRUE(s.write_nb(5));
  EXPECT_TRUE(s.read_nb(y));
  EXPECT_EQ(y, 5);
}

TEST(Stream, ReadingAnEmptyOneNamesIt) {
  hls::stream<int> s("edges");
  try {
    s.read();
    FAIL() << "no error";
  } catch (const hls::stream_error& error) {
    EXPECT_STREQ(error.what(),
                 "Stream \"edges\" is read while it is empty; write to it before, or read less.");
  }
  s.set_name("renamed");
  EXPECT_EQ(s.name(), "renamed");
}

void pass(hls::stream<int>& in, hls::stream<int>& out) { out.write(in.read()); }

TEST(Stream, DepthIsNoLimitInCSimulation) {
  hls::stream<int, 2> in("in"), out("out");
  for (int i = 0; i < 5; ++i) in.write(i);
  pass(in, out);
  EXPECT_EQ(out.read(), 0);
  EXPECT_EQ(in.size(), 4u);  // leftovers
}

TEST(Stream, ABoundMakesItAFifo) {
  hls::stream<int> s("narrow");
  s.bound(2);
  EXPECT_EQ(s.capacity(), 2u);
  s.write(1);
  s.write(2);
  EXPECT_TRUE(s.full());
  EXPECT_FALSE(s.write_nb(3));
  EXPECT_THAT([&] { s.write(3); }, testing::ThrowsMessage<hls::stream_error>(
                                       testing::HasSubstr("\"narrow\" is written while its 2 places")));
  EXPECT_EQ(s.read(), 1);
  EXPECT_TRUE(s.write_nb(3));
}

}  // namespace
