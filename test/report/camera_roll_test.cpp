// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "report/answer.hpp"
#include "report/figures.hpp"
#include "report/results.hpp"
#include "report/sections.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

/// Coning of 5 deg at 2 Hz since the pad: the camera turns by 2.74 deg/s, which no integral of a roll rate has.
constexpr double cone_deg = 5.0;
const double apart_deg_s = 720.0 * (1.0 - std::cos(cone_deg * std::numbers::pi / 180.0));

flight::Flight coning() {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth->geometric_roll_rad = row.truth->roll_angle_rad + text::radians(apart_deg_s * (row.time_s + 0.5));
  }
  synthetic.end_control(3.6, core::PhaseReason::control_time_over);
  return synthetic.flight;
}

TEST(CameraRoll, CountsFromLaunchDetectionToTheEndOfControl) {
  const Figures f = figures(coning());
  ASSERT_TRUE(f.camera_roll);
  // Detection at 0.2 s, the last row under control at 3.599 s.
  EXPECT_NEAR(text::degrees(f.camera_roll->at_end_rad), 3.399 * apart_deg_s, 1e-9);
  EXPECT_EQ(f.camera_roll->largest_rad, f.camera_roll->at_end_rad);
}

TEST(CameraRoll, IsToldOnThePageAndInTheSummary) {
  const flight::Flight flight = coning();
  const Figures f = figures(flight);
  const Verdict v = verdict(flight, f);
  const auto camera = json::parse(result::json(summary(flight, f, v)))["camera_roll"];
  EXPECT_NEAR(camera["largest_apart_deg"].number(), 3.399 * apart_deg_s, 1e-4);
  EXPECT_NEAR(camera["at_end_apart_deg"].number(), 3.399 * apart_deg_s, 1e-4);
  const std::string page = result::html(answer(flight, f, v));
  EXPECT_NE(page.find("The rocket coned: what a camera sees of its roll came up to 9.3 deg away from the roll angle"),
            std::string::npos);
}

TEST(CameraRoll, IsNotMentionedWhereNothingIsKnownOfIt) {
  const flight::Flight flight = SyntheticFlight{}.flight;
  const Figures f = figures(flight);
  const Verdict v = verdict(flight, f);
  EXPECT_FALSE(f.camera_roll);
  EXPECT_FALSE(json::parse(result::json(summary(flight, f, v))).contains("camera_roll"));
  EXPECT_EQ(result::html(answer(flight, f, v)).find("camera"), std::string::npos);
}

}  // namespace
}  // namespace fantail::report
