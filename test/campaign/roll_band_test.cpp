// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "campaign/results.hpp"
#include "fly/fly_scenario.hpp"

namespace fantail::campaign {
namespace {

TEST(QuantilesOverTracks, EndWhereFewerThanTheShareGoOn) {
  const std::array<double, 3> longest{1.0, 2.0, 3.0};
  const std::array<double, 2> shorter{5.0, 4.0};
  const std::array<std::span<const double>, 2> tracks{longest, shorter};
  const std::vector<Quantiles> all = quantiles_over(tracks, 1.0);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_DOUBLE_EQ(all[0].p50, 3.0);
  EXPECT_DOUBLE_EQ(all[1].p50, 3.0);
  EXPECT_DOUBLE_EQ(all[1].p5, 2.1);  // 5 % of the way from 2 to 4
  const std::vector<Quantiles> half = quantiles_over(tracks, 0.5);
  ASSERT_EQ(half.size(), 3U);
  EXPECT_DOUBLE_EQ(half[2].p95, 3.0);
  EXPECT_TRUE(quantiles_over({}, 0.5).empty());
}

// Held against the rows of the same flights, flown whole.
TEST(RollBand, IsTheRollOfTheRunsThatFlewBetweenLiftOffAndTheEndOfControl) {
  const Campaign campaign{.scenario = "tasha3_launch2", .changes = {}, .seed = 3, .runs = 4};
  FlownCampaign flown;
  for (std::uint64_t run = 0; run < campaign.runs; ++run) {
    flown.runs.push_back({.run = run, .outcome = run == 1 ? "refused" : "held"});
  }
  int looks = 0;
  const RollBand band = roll_band_of(campaign, flown, [&looks] { ++looks; });
  EXPECT_EQ(looks, 3);
  EXPECT_EQ(band.runs, 3U);
  EXPECT_FALSE(band.in_tunnel);
  std::vector<flight::Flight> flights;
  for (const std::uint64_t run : {0U, 2U, 3U}) {
    flights.push_back(fly::fly_scenario(repeat_run(campaign, run).scenario));
  }
  for (const double time_s : {0.0, 0.5, 2.0, 2.7, 6.0, 9.0}) {
    const auto instant = std::ranges::find_if(
        band.instants, [time_s](const RollBand::Instant& one) { return std::abs(one.time_s - time_s) < 1e-6; });
    ASSERT_NE(instant, band.instants.end()) << time_s;
    std::vector<double> rolls_rad;
    for (const flight::Flight& flight : flights) {
      const auto row =
          std::ranges::find_if(flight.rows, [time_s](const flight::Row& one) { return one.time_s >= time_s - 1e-9; });
      ASSERT_NE(row, flight.rows.end());
      rolls_rad.push_back(row->truth.value().roll_angle_rad);
    }
    std::ranges::sort(rolls_rad);
    EXPECT_DOUBLE_EQ(instant->roll_rad.p50, rolls_rad[1]) << time_s;
    EXPECT_EQ(instant->reference_rad.has_value(), time_s > 0.6) << time_s;
  }
  double last_end_s = 0.0;
  for (const flight::Flight& flight : flights) {
    last_end_s = std::max(last_end_s, std::min(*flight.events.apogee_s, *flight.events.control_end_s));
  }
  EXPECT_LE(band.instants.back().time_s, last_end_s);
}

}  // namespace
}  // namespace fantail::campaign
