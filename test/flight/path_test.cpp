// SPDX-License-Identifier: MIT
#include "flight/path.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fantail::flight
