#include "frontend/directive.h"

#include <gtest/gtest.h>

namespace hlsc {
namespace {

TEST(Directive, ReadsKindFlagsAndOptionsInAnyCase) {
  Directive directive = parse_directive("array_partition Variable=taps CYCLIC factor=4");
  EXPECT_EQ(directive.kind, "ARRAY_PARTITION");
  EXPECT_TRUE(directive.has("cyclic"));
  EXPECT_EQ(directive.text("variable"), "taps");
  EXPECT_EQ(directive.integer("factor", 0), 4);
  EXPECT_EQ(directive.integer("dim", 1), 1);
}

TEST(Directive, TextReadsBackAsItself) {
  Directive directive = parse_directive("PIPELINE ii=2 rewind");
  EXPECT_EQ(to_text(parse_directive(to_text(directive))), to_text(directive));
}

TEST(Directive, RefusesAnOptionThatIsNoNumber) {
  EXPECT_THROW(parse_directive("PIPELINE ii=fast").integer("ii", 1), std::invalid_argument);
}

}  // namespace
}  // namespace hlsc
