// SPDX-License-Identifier: MIT
#include "rules/departure.hpp"

#include "core/flight_plan_members.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::rules {
namespace {

using text::radians;

/// Every 10 ms from -1 to 5 s, rising at 100 m/s, canards where the plan has their trims.
std::vector<flight::Row> still(const core::FlightPlan& plan) {
  std::vector<flight::Row> rows;
  for (int i = -100; i <= 500; ++i) {
    flight::Row& row = rows.emplace_back();
    row.time_s = i * 0.01;
    row.height_m = i > 0 ? i * 1.0 : 0.0;
    for (std::size_t k = 0; k < core::canard_count; ++k) {
      row.commands_rad[k] = static_cast<double>(plan.canards.each[k].trim.radians());
      row.encoders_rad[k] = row.commands_rad[k];
    }
  }
  return rows;
}

core::FlightPlan plan_with_trims() {
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[1].trim = core::Angle::from_degrees(2.0F);
  return plan;
}

TEST(Departure, IsNoneOfCanardsThatStandAtTheTrimsOfThePlan) {
  const core::FlightPlan plan = plan_with_trims();
  const Departure found = departure(still(plan), plan);
  EXPECT_FALSE(found.time_s);
  EXPECT_FALSE(found.hidden_from_s);
  EXPECT_NEAR(found.since_s, -1.0, 1e-9);
  EXPECT_NEAR(found.until_s, 5.0, 1e-9);
  EXPECT_EQ(departure_text(found), "from -1.00 to 5.00 s, commands within 0 deg and encoders within 0 deg of trim");
}

TEST(Departure, IsTheFirstCommandBeyondATenthOfADegree) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  for (flight::Row& row : rows) {
    *row.commands_rad[1] += row.time_s >= 3.0 ? radians(-0.11) : row.time_s >= 2.0 ? radians(0.09) : 0.0;
  }
  const Departure found = departure(rows, plan);
  ASSERT_TRUE(found.time_s);
  EXPECT_NEAR(*found.time_s, 3.0, 1e-9);
  EXPECT_NEAR(found.row.height_m, 300.0, 1e-9);
  EXPECT_EQ(found.what, "command of canard 2");
  EXPECT_NEAR(found.largest_command_deg, 0.09, 1e-6);
}

// A canard that the air or a broken servo moves has left trim, whatever it was commanded.
TEST(Departure, IsAnEncoderBeyondHalfADegreeWithoutAnyCommand) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  for (flight::Row& row : rows) {
    *row.encoders_rad[3] += row.time_s >= 1.0 ? radians(0.6) : radians(0.4);
  }
  const Departure found = departure(rows, plan);
  ASSERT_TRUE(found.time_s);
  EXPECT_NEAR(*found.time_s, 1.0, 1e-9);
  EXPECT_EQ(found.what, "encoder of canard 4");
}

TEST(Departure, BeforeLiftOffOnlyEndsTheTimeSinceWhichTheyStand) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  for (flight::Row& row : rows) {
    *row.encoders_rad[0] += row.time_s < -0.495 ? radians(3.0) : 0.0;
  }
  const Departure found = departure(rows, plan);
  EXPECT_FALSE(found.time_s);
  EXPECT_NEAR(found.since_s, -0.49, 1e-9);
}

TEST(Departure, IsHiddenFromTheLastAnswerOfAnEncoderThatFallsSilent) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  for (flight::Row& row : rows) {
    row.encoders_rad[2] = row.time_s > 1.005 ? std::nullopt : row.encoders_rad[2];
  }
  const Departure found = departure(rows, plan);
  EXPECT_FALSE(found.time_s);
  ASSERT_TRUE(found.hidden_from_s);
  EXPECT_NEAR(*found.hidden_from_s, 1.0, 1e-9);
}

TEST(Departure, IsNotHiddenByAnEncoderThatMissesSomeTicks) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].encoders_rad[2] = i % 4 == 0 ? rows[i].encoders_rad[2] : std::nullopt;
  }
  EXPECT_FALSE(departure(rows, plan).hidden_from_s);
}

TEST(Departure, IsHiddenByAHoleInTheRows) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  std::erase_if(rows, [](const flight::Row& row) { return row.time_s > 2.0 && row.time_s < 2.5; });
  const Departure found = departure(rows, plan);
  ASSERT_TRUE(found.hidden_from_s);
  EXPECT_NEAR(*found.hidden_from_s, 2.0, 1e-9);
  EXPECT_NEAR(found.hidden_row.height_m, 200.0, 1e-9);
}

TEST(Departure, IsHiddenFromLiftOffOnWithoutAnyEncoder) {
  const core::FlightPlan plan = plan_with_trims();
  std::vector<flight::Row> rows = still(plan);
  for (flight::Row& row : rows) {
    row.encoders_rad = {};
  }
  const Departure found = departure(rows, plan);
  ASSERT_TRUE(found.hidden_from_s);
  EXPECT_EQ(*found.hidden_from_s, 0.0);
}

}  // namespace
}  // namespace fantail::rules
