// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "airframe/summary.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "json/value.hpp"

namespace fantail::airframe {
namespace {

constexpr double calibre_m = 0.08;

/// A stable rocket whose design stores its own numbers.
sim::Vehicle rocket() {
  sim::Vehicle vehicle =
      input::read_vehicle(input::Document::load(input::find_input(input::Shipped::vehicle, "tasha3_launch2").string()));
  vehicle.geometry->design = {.file = "tasha.ork",
                              .flight = "Calm",
                              .mass_kg = vehicle.mass_kg,
                              .centre_of_gravity_m = vehicle.airframe->at_liftoff.centre_of_gravity_m,
                              .centre_of_pressure_m = summarize(vehicle).build_up.centre_of_pressure_m.value};
  return vehicle;
}

bool sentence_says(const Summary& summary, const std::string& part) {
  return summary.sentence.find(part) != std::string::npos;
}

TEST(DesignCheck, SaysThatVehicleAndDesignAgree) {
  const sim::Vehicle vehicle = rocket();
  ASSERT_DOUBLE_EQ(vehicle.geometry->diameter_m, calibre_m);
  const Summary summary = summarize(vehicle);
  EXPECT_EQ(summary.stability, Stability::stable);
  EXPECT_TRUE(summary.agrees_with_design.value());
  EXPECT_TRUE(sentence_says(summary, "Stable: the static margin is")) << summary.sentence;
  EXPECT_TRUE(sentence_says(summary, "the flight \"Calm\" stored in tasha.ork agree.")) << summary.sentence;
}

TEST(DesignCheck, DoubtsAMassThatDiffersByMoreThanTwoPercent) {
  for (const double factor : {0.975, 1.025}) {
    sim::Vehicle vehicle = rocket();
    *vehicle.geometry->design->mass_kg = factor * vehicle.mass_kg;
    const Summary summary = summarize(vehicle);
    EXPECT_EQ(summary.stability, Stability::doubtful) << factor;
    EXPECT_TRUE(summary.sentence.starts_with("Doubtful: tasha.ork stores a mass at lift-off of ")) << summary.sentence;
    EXPECT_TRUE(sentence_says(summary, "As it stands: Stable: ")) << summary.sentence;
    *vehicle.geometry->design->mass_kg = (1.0 + (factor - 1.0) * 0.7) * vehicle.mass_kg;
    EXPECT_EQ(summarize(vehicle).stability, Stability::stable) << factor;
  }
}

TEST(DesignCheck, DoubtsACentreThatDiffersByMoreThanAFifthOfACalibre) {
  using Place = std::optional<double> sim::Geometry::Design::*;
  for (const Place place :
       {&sim::Geometry::Design::centre_of_gravity_m, &sim::Geometry::Design::centre_of_pressure_m}) {
    for (const double calibres : {-0.21, -0.19, 0.19, 0.21}) {
      sim::Vehicle vehicle = rocket();
      *((*vehicle.geometry->design).*place) += calibres * calibre_m;
      const Summary summary = summarize(vehicle);
      const bool is_far = std::abs(calibres) > 0.2;
      EXPECT_EQ(summary.stability, is_far ? Stability::doubtful : Stability::stable) << calibres;
      EXPECT_EQ(sentence_says(summary, "0.21 calibres away"), is_far) << summary.sentence;
      EXPECT_EQ(summary.doubts.size(), is_far ? 1U : 0U);
    }
  }
}

// By the table of docs/airframe.md: the body adds 1.1 times its area from the side, times the angle, in its middle.
TEST(DesignCheck, CountsTheLiftOfTheBodyAtTheAngleOfTheStoredCentreOfPressure) {
  sim::Vehicle vehicle = rocket();
  const model::BuildUp b = summarize(vehicle).build_up;
  const double angle_rad = 0.05;
  const double body = b.body_lift_area_m2 / (0.25 * std::numbers::pi * calibre_m * calibre_m) * std::sin(angle_rad);
  const double slope = b.normal_force_slope_per_rad.value;
  auto& design = *vehicle.geometry->design;
  design.angle_of_attack_rad = angle_rad;
  *design.centre_of_pressure_m =
      b.centre_of_pressure_m.value + body / (slope + body) * (b.body_lift_position_m - b.centre_of_pressure_m.value);
  ASSERT_GT(std::abs(*design.centre_of_pressure_m - b.centre_of_pressure_m.value), 0.2 * calibre_m);
  EXPECT_EQ(summarize(vehicle).stability, Stability::stable) << summarize(vehicle).sentence;
}

TEST(DesignCheck, ComparesTheMarginWhereNoCentresAreStored) {
  sim::Vehicle vehicle = rocket();
  auto& design = *vehicle.geometry->design;
  design.margin_calibres = (*design.centre_of_pressure_m - *design.centre_of_gravity_m) / calibre_m;
  design.centre_of_gravity_m.reset();
  design.centre_of_pressure_m.reset();
  EXPECT_TRUE(summarize(vehicle).agrees_with_design.value());
  *design.margin_calibres -= 0.25;  // it grows while the motor burns
  EXPECT_EQ(summarize(vehicle).stability, Stability::doubtful);
  EXPECT_TRUE(sentence_says(summarize(vehicle), "stores a static margin of ")) << summarize(vehicle).sentence;
}

TEST(DesignCheck, SaysBehindTheVerdictThatNothingWasCompared) {
  sim::Vehicle vehicle = rocket();
  vehicle.geometry->design = sim::Geometry::Design{.file = "tasha.ork"};
  const Summary summary = summarize(vehicle);
  EXPECT_TRUE(summary.sentence.starts_with("Stable, not compared with its design: ")) << summary.sentence;
  EXPECT_TRUE(sentence_says(summary, "tasha.ork stores no up-to-date simulated flight with this motor"))
      << summary.sentence;
  EXPECT_FALSE(summary.agrees_with_design.value());
  EXPECT_EQ(answer(vehicle, summary, {}).verdict.heading, "Stable, not compared with its design");
  EXPECT_EQ(json::parse(result::json(answer(vehicle, summary, {})))["agrees_with_design"], json::Value{false});
}

TEST(DesignCheck, DoubtsWhatWasLeftOutUnlessTheStoredNumbersAgree) {
  sim::Vehicle vehicle = rocket();
  vehicle.geometry->design->left_out = {"podset \"Pods\": not read"};
  EXPECT_EQ(summarize(vehicle).stability, Stability::stable);
  vehicle.geometry->design->centre_of_pressure_m.reset();
  const Summary summary = summarize(vehicle);
  EXPECT_EQ(summary.stability, Stability::doubtful);
  EXPECT_TRUE(sentence_says(summary, "podset \"Pods\": not read")) << summary.sentence;
  EXPECT_EQ(answer(vehicle, summary, {}).verdict.answer, result::Answer::undecided);
}

TEST(DesignCheck, NeverHidesThatARocketIsUnstable) {
  sim::Vehicle vehicle = rocket();
  vehicle.airframe->at_liftoff.centre_of_gravity_m = 1.4;
  const Summary summary = summarize(vehicle);
  EXPECT_EQ(summary.stability, Stability::unstable);
  EXPECT_TRUE(summary.sentence.starts_with("Unstable, and doubtful: ")) << summary.sentence;
}

}  // namespace
}  // namespace fantail::airframe
