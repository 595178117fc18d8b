// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "logs/roll_log.hpp"

namespace fantail::logs {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;

// A roll that swings by `amplitude` at 2 rad/s, with canards of `canard`: the numbers of a file, in its own unit.
RollLog swinging(double amplitude, double canard, double unit = 1.0) {
  RollLog log;
  for (int i = 0; i < 500; ++i) {
    const double t = i * 0.01;
    log.time_s.push_back(t);
    log.roll_angle_rad.push_back(unit * amplitude * std::sin(2.0 * t));
    log.roll_rate_rad_s.push_back(unit * amplitude * 2.0 * std::cos(2.0 * t));
    log.canard_rad.push_back(unit * canard * std::cos(2.0 * t));
  }
  return log;
}

std::string doubts(RollLog log, AngleUnit stated) {
  if (stated == AngleUnit::degrees) {
    for (auto* list : {&log.roll_angle_rad, &log.roll_rate_rad_s, &log.canard_rad, &log.reference_rad}) {
      std::ranges::for_each(*list, [](double& angle) { angle /= degrees_per_radian; });
    }
  }
  note_doubtful_units(log, {.angles = stated});
  note_doubtful_motion(log);
  std::string all;
  std::ranges::for_each(log.warnings, [&](const std::string& warning) { all += warning + "\n"; });
  return all;
}

TEST(DoubtfulUnits, RadiansInADegreeColumnAreNoticed) {
  for (const double canard_deg : {4.0, 6.0, 9.0, 20.0}) {
    for (const double amplitude_deg : {10.0, 45.0, 200.0}) {
      EXPECT_NE(doubts(swinging(amplitude_deg, canard_deg, 1.0 / degrees_per_radian), AngleUnit::degrees)
                    .find("look like radians"),
                std::string::npos)
          << canard_deg << " " << amplitude_deg;
    }
  }
}

TEST(DoubtfulUnits, DegreesAreNotTakenForRadians) {
  for (const double canard_deg : {0.0, 0.04, 1.0, 6.0, 20.0}) {
    for (const double amplitude_deg : {0.05, 3.0, 45.0, 700.0}) {
      EXPECT_EQ(doubts(swinging(amplitude_deg, canard_deg), AngleUnit::degrees), "")
          << canard_deg << " " << amplitude_deg;
    }
  }
}

TEST(DoubtfulUnits, AReferenceOfManyUnitsIsInDegrees) {
  RollLog log = swinging(2.0, 0.5);
  log.reference_rad.assign(log.time_s.size(), 15.0);
  EXPECT_EQ(doubts(log, AngleUnit::degrees), "");
}

TEST(DoubtfulUnits, ARocketAtRestIsNotDoubted) { EXPECT_EQ(doubts(swinging(0.0, 0.3), AngleUnit::degrees), ""); }

TEST(DoubtfulUnits, DegreesInARadianColumnAreNoticed) {
  EXPECT_NE(doubts(swinging(20.0, 6.0), AngleUnit::radians).find("look like degrees"), std::string::npos);
  EXPECT_EQ(doubts(swinging(20.0, 6.0, 1.0 / degrees_per_radian), AngleUnit::radians), "");
}

TEST(DoubtfulUnits, TimeInMillisecondsIsNoticed) {
  RollLog log = swinging(20.0, 6.0);
  std::ranges::for_each(log.time_s, [](double& t) { t *= 1000.0; });
  std::ranges::for_each(log.roll_rate_rad_s, [](double& p) { p /= 1000.0; });
  EXPECT_NE(doubts(log, AngleUnit::degrees).find("samples are 10 s apart"), std::string::npos);
}

TEST(DoubtfulMotion, ARateInAnotherUnitThanTheAngleIsNoticed) {
  RollLog log = swinging(20.0, 6.0);
  std::ranges::for_each(log.roll_rate_rad_s, [](double& p) { p /= degrees_per_radian; });
  EXPECT_NE(doubts(log, AngleUnit::degrees).find("one of them seems to be in radians"), std::string::npos);
  log = swinging(20.0, 6.0);
  std::ranges::for_each(log.roll_angle_rad, [](double& a) { a /= degrees_per_radian; });
  EXPECT_NE(doubts(log, AngleUnit::degrees).find("one of them seems to be in radians"), std::string::npos);
}

TEST(DoubtfulMotion, ARateOfTheWrongSignIsNoticed) {
  RollLog log = swinging(20.0, 6.0);
  std::ranges::for_each(log.roll_rate_rad_s, [](double& p) { p = -p; });
  EXPECT_NE(doubts(log, AngleUnit::degrees).find("wrong sign"), std::string::npos);
}

TEST(DoubtfulMotion, AnAngleAndARateThatDoNotGoTogetherAreLeftAlone) {
  RollLog log = swinging(20.0, 6.0);
  std::ranges::for_each(log.roll_angle_rad, [](double& a) { a = 3.0; });
  EXPECT_EQ(doubts(log, AngleUnit::degrees), "");
}

}  // namespace
}  // namespace fantail::logs
