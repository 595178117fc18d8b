// SPDX-License-Identifier: MIT
#include "campaign/landing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "common/seed.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"

namespace fantail::campaign {
namespace {

/// Of a normal law: 300 m and 100 m along and across a bearing of 30 degrees, about 500 m east and 200 m south.
class Law {
 public:
  OverGround next(std::mt19937_64& random) {
    const double along = 300.0 * normal_(random);
    const double across = 100.0 * normal_(random);
    const double bearing = std::numbers::pi / 6.0;
    return {.east_m = 500.0 + along * std::sin(bearing) + across * std::cos(bearing),
            .north_m = -200.0 + along * std::cos(bearing) - across * std::sin(bearing)};
  }

 private:
  std::normal_distribution<double> normal_;
};

TEST(TheEllipseOfLandings, HoldsTheNextOneInNineteenOfTwentyCases) {
  std::mt19937_64 random{test::seed()};
  Law law;
  constexpr int cases = 20'000;
  for (const std::size_t landings : {std::size_t{10}, std::size_t{50}}) {
    int inside = 0;
    for (int i = 0; i < cases; ++i) {
      std::vector<OverGround> seen(landings);
      std::ranges::generate(seen, [&] { return law.next(random); });
      inside += ellipse_of_next(seen)->holds(law.next(random)) ? 1 : 0;
    }
    // Five standard deviations of a share of 20 000.
    EXPECT_NEAR(static_cast<double>(inside) / cases, 0.95, 5.0 * std::sqrt(0.95 * 0.05 / cases));
  }
}

TEST(TheEllipseOfLandings, HasTheAxesOfTheLawThatTheyFollow) {
  std::mt19937_64 random{1};
  Law law;
  std::vector<OverGround> seen(100'000);
  std::ranges::generate(seen, [&] { return law.next(random); });
  const Ellipse ellipse = ellipse_of_next(seen).value();
  // Of a known normal law in the plane 95 % lie within sqrt(-2 ln 0.05) = 2.4477 standard deviations.
  EXPECT_NEAR(ellipse.half_length_m, 2.4477 * 300.0, 10.0);
  EXPECT_NEAR(ellipse.half_width_m, 2.4477 * 100.0, 4.0);
  EXPECT_NEAR(ellipse.bearing_rad, std::numbers::pi / 6.0, 0.01);
  EXPECT_NEAR(ellipse.centre.east_m, 500.0, 4.0);
  EXPECT_NEAR(ellipse.centre.north_m, -200.0, 4.0);
}

TEST(TheEllipseOfLandings, IsNotMadeOfFewerThanTen) {
  EXPECT_FALSE(ellipse_of_next(std::vector<OverGround>(9)).has_value());
  EXPECT_TRUE(ellipse_of_next(std::vector<OverGround>(10))->holds({}));
}

TEST(ALineAroundTheEllipse, LiesEverywhereThatFarOutside) {
  const Ellipse ellipse{.centre = {10.0, 20.0}, .half_length_m = 300.0, .half_width_m = 50.0, .bearing_rad = 1.0};
  const std::vector<OverGround> fine = [&] {
    std::vector<OverGround> all;
    for (int i = 0; i < 20'000; ++i) {  // by its definition, not by line()
      const double turn = 2.0 * std::numbers::pi * i / 20'000.0;
      const double along = 300.0 * std::cos(turn);
      const double across = 50.0 * std::sin(turn);
      all.push_back({10.0 + along * std::sin(1.0) + across * std::cos(1.0),
                     20.0 + along * std::cos(1.0) - across * std::sin(1.0)});
    }
    return all;
  }();
  for (const OverGround& at : ellipse.line(70.0)) {
    double nearest = 1e9;
    for (const OverGround& one : fine) {
      nearest = std::min(nearest, std::hypot(at.east_m - one.east_m, at.north_m - one.north_m));
    }
    EXPECT_NEAR(nearest, 70.0, 0.1);
  }
}

TEST(TheLandingsOfACampaign, AreKnownOnlyUnderAParachuteInSixDegreesOfFreedom) {
  const Campaign straight{.scenario = "tasha3_launch2", .runs = 1};
  EXPECT_FALSE(landings_of(straight, {}, 1, [] {}).has_value());
  const Campaign without{.scenario = "tasha3_launch2_irec", .runs = 1};
  EXPECT_FALSE(landings_of(without, {}, 1, [] {}).has_value());
}

TEST(TheLandingsOfACampaign, AreWhereTheWholeFlightsOfItsRunsEnd) {
  const Campaign campaign{.scenario = "kestrel", .runs = 3};
  FlownCampaign flown;
  for (std::uint64_t run = 0; run < campaign.runs; ++run) {
    flown.runs.push_back({.run = run, .outcome = run == 1 ? "refused" : "held"});
  }
  int looks = 0;
  const Landings found = landings_of(campaign, flown, 2, [&looks] { ++looks; }).value();
  EXPECT_GT(looks, 0);
  EXPECT_EQ(found.runs, 2U);
  EXPECT_FALSE(found.ellipse.has_value());
  EXPECT_GE(found.failed_flights, 48U);
  EXPECT_GT(found.failed_away_m.value(), 1.0);
  ASSERT_EQ(found.landed.size(), 2U);
  // What `fly` shows of the scenario itself, whose own run ends a second after apogee.
  const flight::Flight shown = fly::fly_scenario(input::load_scenario("kestrel", {}));
  EXPECT_NEAR(shown.path.back().height_m, 0.0, 0.1);
  EXPECT_NEAR(shown.path.back().east_m, found.healthy.value().east_m, 0.1);
  EXPECT_NEAR(shown.path.back().north_m, found.healthy.value().north_m, 0.1);
  EXPECT_LT(shown.events.parachute_s.value(), shown.path.back().time_s - 60.0);
  for (std::size_t i = 0; i < 2; ++i) {
    // The avionics run to the ground here, and its path is what a flight report shows.
    sim::Scenario whole = repeat_run(campaign, 2 * i).scenario;
    whole.time_after_end_s = 600.0;
    const flight::Flight flight = fly::fly_without_rows(whole, [](const auto&, const auto&) {});
    const flight::PathPoint& end = flight.path.back();
    EXPECT_NEAR(end.height_m, 0.0, 1.0);
    EXPECT_NEAR(found.landed[i].east_m, end.east_m, 1.0);
    EXPECT_NEAR(found.landed[i].north_m, end.north_m, 1.0);
  }
}

}  // namespace
}  // namespace fantail::campaign
