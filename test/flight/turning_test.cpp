// SPDX-License-Identifier: MIT
#include <numbers>

#include <gtest/gtest.h>

#include "flight/path.hpp"

namespace fantail::flight {
namespace {

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

}  // namespace
}  // namespace fantail::flight
