// SPDX-License-Identifier: MIT
#include "flight/path.hpp"

#include <cstdio>

#include "flight/columns.hpp"
#include "seed.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::flight {
namespace {

const std::vector<PathPoint> path{{.time_s = 0.0, .tilt_rad = 0.1},
                                  {.time_s = 0.01,
                                   .north_m = 3.0,
                                   .east_m = -4.0,
                                   .height_m = 5.5,
                                   .north_m_s = 1.0,
                                   .east_m_s = 2.0,
                                   .up_m_s = 30.0}};

Table table(const std::string& text) { return Table::parse(text, "trajectory.csv"); }

TEST(Path, IsReadAsItWasWritten) {
  const std::vector<PathPoint> read =
      read_trajectory(table(trajectory_csv(path, PathFrame::compass)), PathFrame::compass);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_NEAR(read[0].tilt_rad, 0.1, 1e-8);
  EXPECT_EQ(read[1].east_m, -4.0);
  EXPECT_EQ(read[1].up_m_s, 30.0);
  EXPECT_EQ(trajectory_csv(read, PathFrame::compass), trajectory_csv(path, PathFrame::compass));
}

TEST(Path, OfAPlaneHoldsWhatIsKnownOfIt) {
  const std::vector<PathPoint> across{
      {.time_s = 0.5, .north_m = 3.0, .height_m = 5.5, .north_m_s = 1.0, .up_m_s = 30.0}};
  const std::string text = trajectory_csv(across, PathFrame::plane);
  EXPECT_EQ(text,
            "time_s,across_m,height_m,across_m_s,up_m_s,tilt_deg\n"
            "0.500000,3.000000,5.500000,1.000000,30.000000,0.000000\n");
  EXPECT_EQ(path_frame(table(text)), PathFrame::plane);
  EXPECT_EQ(path_frame(table(trajectory_csv(across, PathFrame::compass))), PathFrame::compass);
  EXPECT_EQ(read_trajectory(table(text), PathFrame::plane).at(0).north_m, 3.0);
}

TEST(Path, WhatIsNoTrajectoryIsRefusedByLine) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      (void)read_trajectory(table(text), PathFrame::compass);
    } catch (const text::Error& error) {
      return error.what();
    }
    return {};
  };
  std::string text = trajectory_csv(path, PathFrame::compass);
  EXPECT_NE(complaint("time_s,north_m\n0,0\n").find("no column east_m"), std::string::npos);
  EXPECT_EQ(complaint(text + "0.005000,0,0,0,0,0,0,0,0\n"), "trajectory.csv:4: time_s must increase");
  text.replace(text.find("3.000000"), 8, "x");
  EXPECT_EQ(complaint(text), "trajectory.csv:3: north_m = \"x\" is not a number");
}

TEST(Path, APointIsTheLastAtOrBeforeATime) {
  EXPECT_EQ(point_at(path, -0.1), nullptr);
  EXPECT_EQ(point_at(path, 0.005), path.data());
  EXPECT_EQ(point_at(path, 0.01), &path[1]);
  EXPECT_EQ(distance_m(path[1]), 5.0);
}

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

TEST(Turning, IsWrittenInDegreesAndReadAsItWasWritten) {
  constexpr double degree_rad = std::numbers::pi / 180.0;
  const std::vector<TurnPoint> turning{{.time_s = -0.01},
                                       {.time_s = 0.0,
                                        .true_roll_rate_rad_s = degree_rad,
                                        .true_pitch_rate_rad_s = 2.0 * degree_rad,
                                        .true_yaw_rate_rad_s = 3.0 * degree_rad,
                                        .true_tilt_rad = 4.0 * degree_rad,
                                        .gyro_roll_rate_rad_s = 5.0 * degree_rad,
                                        .gyro_pitch_rate_rad_s = 6.0 * degree_rad,
                                        .gyro_yaw_rate_rad_s = -7.0 * degree_rad,
                                        .tilt_rad = 8.0 * degree_rad}};
  const std::string text = turning_csv(turning);
  EXPECT_EQ(text,
            "time_s,true_roll_rate_deg_s,true_pitch_rate_deg_s,true_yaw_rate_deg_s,true_tilt_deg,"
            "gyro_roll_rate_deg_s,gyro_pitch_rate_deg_s,gyro_yaw_rate_deg_s,tilt_deg\n"
            "-0.010000,0.000000,0.000000,0.000000,0.000000,0.000000,0.000000,0.000000,0.000000\n"
            "0.000000,1.000000,2.000000,3.000000,4.000000,5.000000,6.000000,-7.000000,8.000000\n");
  EXPECT_EQ(turning_csv(read_turning(Table::parse(text, "turning.csv"))), text);
}

// What the C library says, which rounds the exact binary value.
std::string printed(double value) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.6f", value);
  return std::string{text.data()} == "-0.000000" ? "0.000000" : text.data();
}

TEST(SixDecimals, AreThoseOfPrintf) {
  for (const double value :
       {0.0,       -0.0,      1.0,    -1.0,      0.1,       1e-7,       -1e-7,          4.9999999e-7,        5e-7,
        0.1234565, 0.1234575, 2.5e-6, 0.0078125, 0.0234375, -0.0078125, 999999.9999995, 123456789.123456789, 3.9e9,
        4.1e9,     -4.1e9,    1e15,   1e22,      1e300,     -1e300}) {
    EXPECT_EQ(SixDecimals{value}.text(), printed(value)) << value;
  }
}

TEST(SixDecimals, AreThoseOfPrintfForAnyNumber) {
  std::mt19937_64 random{test::seed()};
  std::uniform_real_distribution<double> mantissa{-1.0, 1.0};
  std::uniform_int_distribution<int> exponent{-12, 16};
  for (int i = 0; i < 200'000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    ASSERT_EQ(SixDecimals{value}.text(), printed(value));
  }
}

TEST(SixDecimals, AreThoseOfPrintfNextToEveryTie) {
  // 2^-7 of a millionth's multiples: exact ties, and the doubles on both sides.
  for (int i = 1; i < 20'000; i += 2) {
    const double tie = i / 128.0;
    for (const double value : {tie, std::nextafter(tie, 0.0), std::nextafter(tie, 1e9), -tie}) {
      ASSERT_EQ(SixDecimals{value}.text(), printed(value));
    }
  }
}

TEST(SixDecimals, BrieflyHaveNoZerosAtTheEnd) {
  EXPECT_EQ(SixDecimals{0.25}.brief(), "0.25");
  EXPECT_EQ(SixDecimals{-70.0}.brief(), "-70");
  EXPECT_EQ(SixDecimals{0.0}.brief(), "0");
  EXPECT_EQ(SixDecimals{0.000001}.brief(), "0.000001");
}

TEST(SixDecimals, WhatIsNoNumberIsStillText) {
  EXPECT_EQ(SixDecimals{std::numeric_limits<double>::infinity()}.text(), "inf");
  EXPECT_EQ(SixDecimals{std::nan("")}.text(), "nan");
}

}  // namespace

}  // namespace fantail::flight
