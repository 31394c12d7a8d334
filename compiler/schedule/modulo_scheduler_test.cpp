#include <gtest/gtest.h>

#include "schedule/problem.h"

namespace hlsc {
namespace {

ScheduleOperation operation(double delay, int latency = 0, int resource = -1) {
  ScheduleOperation made;
  made.delay = latency ? 0 : delay;
  made.output_delay = latency ? delay : 0;
  made.latency = latency;
  made.resource = resource;
  return made;
}

Dependence data(int from, int to, int distance = 0) {
  Dependence made;
  made.from = from;
  made.to = to;
  made.distance = distance;
  return made;
}

class ModuloScheduler : public ::testing::Test {
 protected:
  bool solved() {
    bool found = solve(problem, schedule, failure);
    if (found) {
      EXPECT_EQ(verify(problem, schedule), "");
    }
    return found;
  }
  bool solved_at(int ii) {
    problem.ii = ii;
    return solved();
  }
  ScheduleProblem problem;
  Schedule schedule;
  ScheduleFailure failure;
};

TEST_F(ModuloScheduler, ChainsWhatFitsInACycle) {
  problem.period = 5;
  problem.operations = {operation(2), operation(2), operation(2)};
  problem.dependences = {data(0, 1), data(1, 2)};
  ASSERT_TRUE(solved());
  EXPECT_EQ(schedule.cycle, (std::vector<int>{0, 0, 1}));
}

TEST_F(ModuloScheduler, EveryCycleBeginsWhenRegistersAreThere) {
  problem.period = 5;
  problem.operations = {operation(2), operation(2), operation(2), operation(9)};
  for (ScheduleOperation& op : problem.operations) op.launch = 2;
  problem.dependences = {data(0, 1), data(1, 2), data(2, 3)};
  ASSERT_TRUE(solved());
  EXPECT_EQ(schedule.cycle, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(schedule.begin, (std::vector<double>{2, 2, 2, 2}));
}

TEST_F(ModuloScheduler, SharesAResourceModuloIi) {
  problem.operations = {operation(1, 0, 0), operation(1, 0, 0), operation(1, 0, 0)};
  problem.limits = {1};
  EXPECT_EQ(resource_ii(problem), 3);
  EXPECT_FALSE(solved_at(2));
  EXPECT_EQ(failure.resource, 0);
  EXPECT_TRUE(solved_at(3));
}

TEST_F(ModuloScheduler, RefusesAnIiBelowTheRecurrenceAndNamesIt) {
  problem.period = 5;
  problem.operations = {operation(4), operation(4)};  // Two cycles around.
  problem.dependences = {data(0, 1), data(1, 0, 1)};
  EXPECT_FALSE(solved_at(1));
  EXPECT_EQ(failure.dependence, 1);
  EXPECT_TRUE(solved_at(2));
}

TEST_F(ModuloScheduler, MovesARecurrenceToItsLateOperand) {
  problem.operations = {operation(0), operation(3, 4), operation(1)};  // A phi, a slow load, their sum.
  problem.dependences = {data(0, 2), data(1, 2), data(2, 0, 1)};
  ASSERT_TRUE(solved_at(1));
  EXPECT_EQ(schedule.cycle[0], schedule.cycle[2]);
  EXPECT_EQ(schedule.cycle[2], 4);
}

TEST_F(ModuloScheduler, SavesRegistersByWideningLate) {
  // A flag that comes at once, 32 bits made of it, and what waits for a slow load beside them.
  problem.operations = {operation(0), operation(1), operation(3, 4), operation(1)};
  problem.operations[0].bits = 1;
  problem.operations[1].bits = 32;
  for (int fixed : {0, 2, 3}) problem.operations[fixed].is_fixed = true;
  problem.dependences = {data(0, 1), data(1, 3), data(2, 3)};
  problem.ii = 1;
  ASSERT_TRUE(solved());
  EXPECT_EQ(register_bits(problem, schedule), 4 * 32u);
  save_registers(problem, schedule);
  EXPECT_EQ(verify(problem, schedule), "");
  EXPECT_EQ(schedule.cycle, (std::vector<int>{0, 4, 0, 4}));
  EXPECT_EQ(register_bits(problem, schedule), 4u);
}

TEST_F(ModuloScheduler, ARegisterOfTheNextIterationIsACopy) {
  // What comes at once waits a cycle for a load; the next iteration takes it, too.
  problem.operations = {operation(0), operation(0), operation(3, 1), operation(1)};
  problem.operations[0].is_register = true;
  problem.operations[0].bits = problem.operations[1].bits = 8;
  problem.dependences = {data(1, 0, 1), data(1, 3), data(2, 3)};
  ASSERT_TRUE(solved_at(1));
  ASSERT_EQ(schedule.cycle, (std::vector<int>{0, 0, 0, 1}));
  EXPECT_EQ(register_bits(problem, schedule), 0u);
  problem.operations[0].bits = 9;
  EXPECT_EQ(register_bits(problem, schedule), 8u);
}

TEST_F(ModuloScheduler, VerifyFindsAWrongSchedule) {
  problem.operations = {operation(2), operation(2)};
  problem.dependences = {data(0, 1)};
  ASSERT_TRUE(solved());
  schedule.begin[1] = 0;
  EXPECT_NE(verify(problem, schedule), "");
}

}  // namespace
}  // namespace hlsc
