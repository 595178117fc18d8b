// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include "report/answer.hpp"
#include "report/sections.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

/// 400 m above the guide at 3 s; on the ground 30 m north and 40 m east of it from 60 s on.
SyntheticFlight flight_to_the_ground() {
  SyntheticFlight synthetic;
  synthetic.end_control(3.0, core::PhaseReason::apogee);
  synthetic.flight.events.apogee_s = 3.0;
  synthetic.flight.path = {{.time_s = 0.0},
                           {.time_s = 3.0, .height_m = 400.0},
                           {.time_s = 59.0, .north_m = 29.0, .east_m = 39.0, .height_m = 5.0},
                           {.time_s = 60.0, .north_m = 30.0, .east_m = 40.0},
                           {.time_s = 90.0, .north_m = 30.0, .east_m = 40.0}};
  return synthetic;
}

std::string landed_page(const flight::Flight& flight) {
  const Figures f = figures(flight);
  return result::html(answer(flight, f, verdict(flight, f)));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Landing, IsWhereAParachuteFirstBringsTheRocketToTheGround) {
  SyntheticFlight synthetic = flight_to_the_ground();
  synthetic.flight.events.parachute_s = 3.5;
  const auto landing = landing_of(synthetic.flight);
  ASSERT_TRUE(landing);
  EXPECT_EQ(landing->at.time_s, 60.0);
  EXPECT_TRUE(landing->under_parachute);
  const std::string page = landed_page(synthetic.flight);
  EXPECT_TRUE(has(page, "50 <span>m</span><small>towards north-east, at 60.0 s, under the parachute")) << page;
  EXPECT_TRUE(has(page, "launch guide"));
  EXPECT_FALSE(has(page, "outside the model: no landing"));
}

TEST(Landing, OfAFallWithoutAParachuteIsNotGiven) {
  const SyntheticFlight synthetic = flight_to_the_ground();
  const std::string page = landed_page(synthetic.flight);
  EXPECT_TRUE(has(page, "outside the model: no landing point is given"));
  EXPECT_FALSE(has(page, "landing, from the guide"));
}

TEST(Landing, IsUnknownWhereTheFlightEndsInTheAirOrItsPathHasNoDirection) {
  SyntheticFlight in_the_air = flight_to_the_ground();
  in_the_air.flight.path.resize(3);
  EXPECT_FALSE(landing_of(in_the_air.flight));
  SyntheticFlight in_a_plane = flight_to_the_ground();
  in_a_plane.flight.path_frame = flight::PathFrame::plane;
  EXPECT_FALSE(landing_of(in_a_plane.flight));
  EXPECT_FALSE(has(landed_page(in_a_plane.flight), "no landing point"));
}

}  // namespace
}  // namespace fantail::report
