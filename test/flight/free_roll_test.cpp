// SPDX-License-Identifier: MIT
#include <numbers>

#include <gtest/gtest.h>

#include "flight/path.hpp"

namespace fantail::flight {
namespace {

TEST(FreeRoll, IsWrittenInDegreesAndReadAsItWasWritten) {
  constexpr double degree_rad = std::numbers::pi / 180.0;
  const std::vector<FreeRollPoint> points{
      {.time_s = -0.01},
      {.time_s = 0.0, .true_roll_angle_rad = -400.0 * degree_rad, .true_roll_rate_rad_s = 3.0 * degree_rad}};
  const std::string text = free_roll_csv(points);
  EXPECT_EQ(text,
            "time_s,true_roll_angle_deg,true_roll_rate_deg_s\n"
            "-0.010000,0.000000,0.000000\n"
            "0.000000,-400.000000,3.000000\n");
  EXPECT_EQ(free_roll_csv(read_free_roll(Table::parse(text, "without_control.csv"))), text);
}

// Points are ten milliseconds apart, and a flight may end between two of them.
TEST(FreeRoll, StaysAtItsLastPointUntilAnotherOneWouldHaveCome) {
  const std::vector<FreeRollPoint> points{{.time_s = 1.0, .true_roll_angle_rad = 2.0},
                                          {.time_s = 1.01, .true_roll_angle_rad = 2.5}};
  EXPECT_DOUBLE_EQ(free_roll_angle_rad(points, 1.019).value(), 2.5);
  EXPECT_FALSE(free_roll_angle_rad(points, 1.021));
}

TEST(FreeRoll, IsOnTheLineBetweenTwoPointsAndUnknownOutsideOfThem) {
  const std::vector<FreeRollPoint> points{{.time_s = 1.0, .true_roll_angle_rad = 2.0},
                                          {.time_s = 2.0, .true_roll_angle_rad = 6.0},
                                          {.time_s = 4.0, .true_roll_angle_rad = 0.0}};
  EXPECT_DOUBLE_EQ(free_roll_angle_rad(points, 1.0).value(), 2.0);
  EXPECT_DOUBLE_EQ(free_roll_angle_rad(points, 1.25).value(), 3.0);
  EXPECT_DOUBLE_EQ(free_roll_angle_rad(points, 3.5).value(), 1.5);
  EXPECT_DOUBLE_EQ(free_roll_angle_rad(points, 4.0).value(), 0.0);
  EXPECT_FALSE(free_roll_angle_rad(points, 0.999));
  EXPECT_FALSE(free_roll_angle_rad(points, 4.011));
  EXPECT_FALSE(free_roll_angle_rad({}, 0.0));
}

}  // namespace
}  // namespace fantail::flight
