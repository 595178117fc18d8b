// SPDX-License-Identifier: MIT
#include "listen/mounting.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "logs/refused.hpp"

namespace fantail::listen {
namespace {

using test::expect_refused;
using text::ErrorKind;

Signal steady(double value) {
  Signal signal{.words = "column"};
  for (int i = 0; i < 20; ++i) {
    signal.time_s.push_back(0.01 * i);
    signal.value.push_back(value);
  }
  return signal;
}

/// What a logger reads at rest in an upright rocket that rolls, mounted so; each from its own geometry.
ImuLog log_of(double x, double y, double z) {
  return {.name = "log.csv", .axial = steady(x), .lateral_y = steady(y), .lateral_z = steady(z)};
}

TEST(AMounting, ThatLeansPutsTheWeightBackOnTheAxisOfTheRocket) {
  // Turned by +30 about z, the logger's x axis points to (cos 30, sin 30): it reads g cos 30 along x, -g sin 30 along
  // y.
  const double angle = std::numbers::pi / 6.0;
  ImuLog log = log_of(one_g_m_s2 * std::cos(angle), -one_g_m_s2 * std::sin(angle), 0.5);
  turn_into_rocket(log, parse_mounting("30 about z"), false);
  EXPECT_NEAR(log.axial.value.at(3), one_g_m_s2, 1e-12);
  EXPECT_NEAR(log.lateral_y.value.at(3), 0.0, 1e-12);
  EXPECT_NEAR(log.lateral_z.value.at(3), 0.5, 1e-12);
}

TEST(AMounting, AboutTheAxisMixesTheSidesAlone) {
  // Turned by +45 about x, the logger's y axis lies half way from y to z: 2 along its y is sqrt 2 along each.
  ImuLog log = log_of(one_g_m_s2, 2.0, 0.0);
  turn_into_rocket(log, parse_mounting("45 about x"), true);
  EXPECT_DOUBLE_EQ(log.axial.value.at(0), one_g_m_s2);
  EXPECT_NEAR(log.lateral_y.value.at(0), std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(log.lateral_z.value.at(0), std::numbers::sqrt2, 1e-12);
}

TEST(AMounting, OfTwoTurnsTakesThemInTheirOrderAboutTheAxesOfTheRocket) {
  // 90 about z puts the logger's x on y and its y on -x; then 90 about x puts its x on z and leaves its y on -x.
  ImuLog log = log_of(1.0, 2.0, 3.0);
  log.roll_rate = log.axial;
  log.pitch_rate = log.lateral_y;
  log.yaw_rate = log.lateral_z;
  turn_into_rocket(log, parse_mounting("90 about z, 90 about x"), false);
  EXPECT_NEAR(log.axial.value.at(0), -2.0, 1e-12);
  EXPECT_NEAR(log.lateral_y.value.at(0), -3.0, 1e-12);
  EXPECT_NEAR(log.lateral_z.value.at(0), 1.0, 1e-12);
  EXPECT_NEAR(log.roll_rate.value.at(0), -2.0, 1e-12);
  EXPECT_NEAR(log.yaw_rate.value.at(0), 1.0, 1e-12);
}

TEST(AMounting, CountsOnlySamplesThatAllItsAxesHave) {
  ImuLog log = log_of(one_g_m_s2, 1.0, 1.0);
  log.lateral_y.time_s.erase(log.lateral_y.time_s.begin() + 4);
  log.lateral_y.value.pop_back();
  turn_into_rocket(log, parse_mounting("10 about x"), false);
  EXPECT_EQ(log.axial.time_s.size(), 20U);
  EXPECT_EQ(log.lateral_z.time_s.size(), 19U);
  EXPECT_EQ(log.lateral_z.time_s, log.lateral_y.time_s);
}

TEST(AMounting, IsRefusedWhereTheLogCannotBeTurned) {
  ImuLog without = log_of(one_g_m_s2, 0.0, 0.0);
  without.lateral_z = {};
  expect_refused(ErrorKind::bad_data, {"log.csv", "lateral_z", "45 about x"},
                 [&] { turn_into_rocket(without, parse_mounting("45 about x"), false); });
  expect_refused(ErrorKind::bad_data, {"log.csv", "pad", "about x"}, [] {
    ImuLog log = log_of(one_g_m_s2, 0.0, 0.0);
    turn_into_rocket(log, parse_mounting("5 about y"), true);
  });
  expect_refused(ErrorKind::bad_data, {"same times", "0 of 20"}, [] {
    ImuLog log = log_of(one_g_m_s2, 0.0, 0.0);
    for (double& time_s : log.lateral_z.time_s) {
      time_s += 0.001;
    }
    turn_into_rocket(log, parse_mounting("5 about x"), false);
  });
}

TEST(AMounting, ByThePadPutsTheForceAtRestOnTheNoseWhicheverWayTheLoggerSits) {
  for (const sim::Vector3& up : {sim::Vector3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0.6, -0.48, 0.64}}) {
    ImuLog log = log_of(one_g_m_s2 * up.x, one_g_m_s2 * up.y, one_g_m_s2 * up.z);
    for (std::size_t i = 0; i < log.axial.value.size(); ++i) {
      log.axial.time_s[i] = log.lateral_y.time_s[i] = log.lateral_z.time_s[i] = 0.03 * static_cast<double>(i);
    }
    log.roll_rate = log.axial;  // it spins about the nose with 9.80665 rad/s
    log.pitch_rate = log.lateral_y;
    log.yaw_rate = log.lateral_z;
    for (Signal* const signal : {&log.axial, &log.lateral_y, &log.lateral_z}) {
      signal->value[15] *= 8.0;  // thrust
    }
    turn_into_rocket(log, parse_mounting("pad"), false);
    EXPECT_NEAR(log.axial.value.at(0), one_g_m_s2, 1e-12);
    EXPECT_NEAR(log.axial.value.at(15), 8.0 * one_g_m_s2, 1e-12);
    EXPECT_NEAR(log.lateral_y.value.at(15), 0.0, 1e-12);
    EXPECT_NEAR(log.roll_rate.value.at(3), one_g_m_s2, 1e-12);
    EXPECT_NEAR(log.yaw_rate.value.at(3), 0.0, 1e-12);
  }
}

TEST(AMounting, ByThePadIsRefusedForALogThatDoesNotBeginAtRest) {
  ImuLog log = log_of(3.0 * one_g_m_s2, 0.0, 0.0);
  expect_refused(ErrorKind::bad_data, {"log.csv", "0.2 s at rest", "--mounting"},
                 [&] { turn_into_rocket(log, parse_mounting("pad"), false); });
}

TEST(AMounting, ThatIsNoneIsRefusedWithWhatIsAllowed) {
  for (const char* words : {"", "45", "45 about", "45 about w", "x about 45", "361 about x", "nan about x",
                            "45 about x,", "45 about xy", "45 degrees about x"}) {
    expect_refused(ErrorKind::bad_configuration, {"not a mounting", "-360 to 360", "10 about x"},
                   [&] { (void)parse_mounting(words); });
  }
}

}  // namespace
}  // namespace fantail::listen
