// SPDX-License-Identifier: MIT
#include "flight/write_csv.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "text/degrees.hpp"

namespace fantail::flight {
namespace {

const std::string measured_header =
    "time_s,phase,roll_angle_deg,roll_rate_deg_s,reference_deg,excitation_deg,offset_estimate_deg,command_deg,"
    "saturated,command_1_deg,"
    "command_2_deg,command_3_deg,command_4_deg,encoder_1_deg,encoder_2_deg,encoder_3_deg,encoder_4_deg,canard_deg,"
    "specific_force_m_s2,height_m,speed_m_s";

std::string second_line(const Flight& flight) {
  const std::string text = csv(flight);
  const std::size_t begin = text.find('\n') + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

Row some_row() {
  Row row;
  row.time_s = 1.25;
  row.phase = core::Phase::controlling;
  row.roll_angle_rad = text::radians(-12.5);
  row.roll_rate_rad_s = text::radians(100.0);
  row.reference_rad = text::radians(-20.0);
  row.excitation_rad = text::radians(4.0);
  row.offset_estimate_rad = text::radians(-2.0);
  row.command_rad = text::radians(9.0);
  row.saturated = true;
  row.commands_rad = {text::radians(1.0), text::radians(2.0), text::radians(3.0), text::radians(4.0)};
  row.encoders_rad = {text::radians(1.5), text::radians(2.5), text::radians(3.5), text::radians(4.5)};
  row.canard_rad = text::radians(3.0);
  row.specific_force_m_s2 = 9.80665;
  row.height_m = 6.0;
  row.speed_m_s = 25.0;
  return row;
}

TEST(Csv, HeaderIsTheContractWordForWord) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].truth = Truth{};
  const std::string text = csv(flight);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            measured_header +
                ",true_roll_angle_deg,true_roll_rate_deg_s,true_canard_deg,true_height_m,true_speed_m_s,"
                "true_disturbance_deg");
}

TEST(Csv, TheRollThatACameraSeesHasAColumnInSixDegreesOfFreedomOnly) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].truth = Truth{.geometric_roll_rad = text::radians(7.5)};
  const std::string text = csv(flight);
  EXPECT_TRUE(text.substr(0, text.find('\n')).ends_with(",true_disturbance_deg,true_geometric_roll_deg")) << text;
  EXPECT_TRUE(second_line(flight).ends_with(",7.500000")) << text;
}

TEST(Csv, WithoutTruthThereAreNoTrueColumns) {
  Flight flight;
  flight.rows = {some_row()};
  EXPECT_EQ(csv(flight).substr(0, measured_header.size() + 1), measured_header + "\n");
}

TEST(Csv, AFlightWithoutRowsIsAHeader) { EXPECT_EQ(csv(Flight{}), measured_header + "\n"); }

TEST(Csv, ARowHoldsDegreesWithSixDecimalsAndThePhaseAsAWord) {
  Flight flight;
  flight.rows = {some_row()};
  EXPECT_EQ(
      second_line(flight),
      "1.250000,controlling,-12.500000,100.000000,-20.000000,4.000000,-2.000000,9.000000,1,1.000000,2.000000,3.000000,"
      "4.000000,1.500000,2.500000,3.500000,4.500000,3.000000,9.806650,6.000000,25.000000");
}

TEST(Csv, TruthFollowsInItsOwnColumns) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].truth =
      Truth{text::radians(1.0), text::radians(-2.0), text::radians(3.0), 400.5, 80.25, text::radians(-7.3)};
  EXPECT_TRUE(second_line(flight).ends_with(",25.000000,1.000000,-2.000000,3.000000,400.500000,80.250000,-7.300000"));
}

TEST(Csv, WhatNobodyKnewIsAnEmptyCell) {
  Flight flight;
  flight.rows = {some_row(), some_row()};
  flight.rows[0].commands_rad[0].reset();
  flight.rows[0].encoders_rad[2].reset();
  flight.rows[0].canard_rad.reset();
  flight.rows[1].truth = Truth{};
  const std::string line = second_line(flight);
  EXPECT_NE(line.find(",1,,2.000000,"), std::string::npos);
  EXPECT_NE(line.find(",2.500000,,4.500000,,9.806650,"), std::string::npos);
  EXPECT_TRUE(line.ends_with(",25.000000,,,,,,"));
}

TEST(Csv, EveryRowHasAsManyCellsAsTheHeader) {
  Flight flight;
  flight.rows = {some_row(), Row{}, some_row()};
  flight.rows[2].truth = Truth{};
  const std::string text = csv(flight);
  std::size_t begin = 0;
  for (int line = 0; line < 4; ++line) {
    const std::size_t end = text.find('\n', begin);
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(std::count(text.begin() + static_cast<std::ptrdiff_t>(begin),
                         text.begin() + static_cast<std::ptrdiff_t>(end), ','),
              26)
        << "line " << line;
    begin = end + 1;
  }
  EXPECT_EQ(begin, text.size());
}

TEST(Csv, ANegativeZeroIsAZero) {
  Flight flight;
  flight.rows = {some_row()};
  flight.rows[0].roll_angle_rad = -0.0;
  flight.rows[0].roll_rate_rad_s = -1e-12;
  EXPECT_NE(second_line(flight).find("controlling,0.000000,0.000000,"), std::string::npos);
}

TEST(TunnelCsv, HasOneRowForEachReadingOnTheRowsClock) {
  Flight flight;
  flight.tunnel_readings = {{8.0, 570.0, 10.1}, {10.0, 870.0, 10.0}};
  set_time_zero(flight, 10.0);
  EXPECT_EQ(tunnel_csv(flight),
            "time_s,fan_rpm,wind_speed_m_s\n-2.000000,570.000000,10.100000\n0.000000,870.000000,10.000000\n");
}

}  // namespace
}  // namespace fantail::flight
