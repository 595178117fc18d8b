// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "airframe/summary.hpp"
#include "figures.hpp"
#include "input/document.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "json/value.hpp"
#include "text/number.hpp"

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
  EXPECT_TRUE(summary.doubts.empty());
  EXPECT_TRUE(sentence_says(summary, "\"Calm\"") && sentence_says(summary, "tasha.ork")) << summary.sentence;
}

TEST(DesignCheck, DoubtsAMassThatDiffersByMoreThanTwoPercent) {
  sim::Vehicle without_design = rocket();
  without_design.geometry->design.reset();
  for (const double factor : {0.975, 1.025}) {
    sim::Vehicle vehicle = rocket();
    *vehicle.geometry->design->mass_kg = factor * vehicle.mass_kg;
    const Summary summary = summarize(vehicle);
    EXPECT_EQ(summary.stability, Stability::doubtful) << factor;
    ASSERT_EQ(summary.doubts.size(), 1U);
    EXPECT_EQ(figures(summary.doubts[0]),
              (std::vector{text::fixed(factor * vehicle.mass_kg, 3), std::string{"3.990"}}));
    EXPECT_TRUE(sentence_says(summary, "tasha.ork") && sentence_says(summary, summary.doubts[0])) << summary.sentence;
    EXPECT_TRUE(sentence_says(summary, summarize(without_design).sentence)) << "as it stands; " << summary.sentence;
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
      ASSERT_EQ(summary.doubts.size(), is_far ? 1U : 0U);
      if (is_far) {
        EXPECT_EQ(figures(summary.doubts[0]).back(), "0.21") << summary.doubts[0];
        EXPECT_TRUE(sentence_says(summary, summary.doubts[0])) << summary.sentence;
      }
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
  EXPECT_EQ(figures(summarize(vehicle).doubts.at(0)).at(0), text::fixed(*design.margin_calibres, 2));
}

TEST(DesignCheck, SaysBehindTheVerdictThatNothingWasCompared) {
  sim::Vehicle vehicle = rocket();
  vehicle.geometry->design = sim::Geometry::Design{.file = "tasha.ork"};
  const Summary summary = summarize(vehicle);
  EXPECT_EQ(summary.stability, Stability::stable);
  EXPECT_TRUE(sentence_says(summary, "not compared") && sentence_says(summary, "tasha.ork")) << summary.sentence;
  EXPECT_FALSE(summary.agrees_with_design.value());
  EXPECT_EQ(answer(vehicle, summary, {}).verdict.answer, result::Answer::undecided);
  EXPECT_NE(answer(vehicle, summary, {}).verdict.heading.find("not compared"), std::string::npos);
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
  EXPECT_FALSE(summary.doubts.empty());
  EXPECT_EQ(answer(vehicle, summary, {}).verdict.answer, result::Answer::no);
  EXPECT_TRUE(sentence_says(summary, "doubtful") && sentence_says(summary, summary.doubts.at(0))) << summary.sentence;
}

}  // namespace
}  // namespace fantail::airframe
