#include "design/shared_phis.h"

#include <gtest/gtest.h>

namespace hlsc {
namespace {

/// Loops one after the other, each with counters that begin at 0.
class SharedPhis : public ::testing::Test {
 protected:
  ValueId add(Operation op, unsigned bits) {
    op.type_width = op.bits = bits;
    process.operations.push_back(op);
    ValueId id = process.operations.size() - 1;
    if (op.block >= 0) process.blocks[op.block].operations.push_back(id);
    return id;
  }

  ValueId constant(unsigned value, unsigned bits) {
    Operation op;
    op.constant = llvm::APInt(bits, value);
    return add(op, bits);
  }

  int loop() {
    int block = process.blocks.size();
    process.blocks.emplace_back();
    process.blocks.back().is_loop = true;
    process.blocks.back().predecessors = {block - 1, block};
    return block;
  }

  ValueId counter(int block, unsigned step, unsigned bits) {
    Operation op;
    op.kind = OpKind::kPhi;
    op.block = block;
    op.operands = {constant(0, bits), kNoValue};
    ValueId phi = add(op, bits);
    op.kind = OpKind::kAdd;
    op.operands = {phi, constant(step, bits)};
    process[phi].operands[1] = add(op, bits);
    return phi;
  }

  Process process;
  using Pairs = std::map<ValueId, ValueId>;
};

TEST_F(SharedPhis, CountersThatStepAlikeAreOneRegister) {
  ValueId first = counter(loop(), 1, 8), second = counter(loop(), 1, 8), third = counter(loop(), 1, 8);
  EXPECT_EQ(shared_phis(process), (Pairs{{second, first}, {third, first}}));
}

TEST_F(SharedPhis, OthersAreNot) {
  counter(loop(), 1, 8);
  counter(loop(), 2, 8);
  counter(loop(), 1, 9);
  EXPECT_EQ(shared_phis(process), Pairs{});
}

TEST_F(SharedPhis, CountersOfOneLoopAreNot) {
  int early = loop();
  ValueId first = counter(early, 1, 8);
  int late = loop();
  ValueId second = counter(late, 1, 8);
  counter(late, 1, 8);
  EXPECT_EQ(shared_phis(process), (Pairs{{second, first}}));
}

TEST_F(SharedPhis, ACounterThatWaitsForAnotherIsComparedWithIt) {
  // Every step adds the counter beside it.
  auto sum = [&](int block, ValueId counter) {
    Operation op;
    op.kind = OpKind::kPhi;
    op.block = block;
    op.operands = {constant(0, 8), kNoValue};
    ValueId phi = add(op, 8);
    op.kind = OpKind::kAdd;
    op.operands = {phi, counter};
    process[phi].operands[1] = add(op, 8);
    return phi;
  };
  int early = loop();
  ValueId one = counter(early, 1, 8), sum_of_one = sum(early, one);
  int late = loop();
  ValueId same = counter(late, 1, 8), sum_of_same = sum(late, same);
  int last = loop();
  ValueId two = counter(last, 2, 8);
  sum(last, two);
  EXPECT_EQ(shared_phis(process), (Pairs{{same, one}, {sum_of_same, sum_of_one}}));
}

}  // namespace
}  // namespace hlsc
