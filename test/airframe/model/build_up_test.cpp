// SPDX-License-Identifier: MIT
#include "airframe/model/build_up.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace fantail::airframe::model {
namespace {

using sim::Geometry;

sim::Vehicle vehicle() {
  sim::Vehicle v;
  v.geometry = Geometry{
      .nose_shape = Geometry::NoseShape::ogive,
      .nose_length_m = 0.3,
      .diameter_m = 0.08,
      .length_m = 1.5,
      .fins =
          Geometry::FinSet{
              .position_m = 1.35, .root_chord_m = 0.15, .tip_chord_m = 0.08, .span_m = 0.06, .sweep_m = 0.06},
      .canards = Geometry::FinSet{.position_m = 0.35, .root_chord_m = 0.03, .tip_chord_m = 0.03, .span_m = 0.05},
      .canard_hinge_m = 0.0075};
  return v;
}

struct PeerAirframe {
  Geometry shape;
  std::map<std::string, double> figures;
};

std::vector<PeerAirframe> peer_airframes() {
  const std::map<std::string, Geometry::NoseShape> noses{{"cone", Geometry::NoseShape::cone},
                                                         {"ogive", Geometry::NoseShape::ogive},
                                                         {"ellipsoid", Geometry::NoseShape::ellipsoid},
                                                         {"haack", Geometry::NoseShape::haack}};
  std::ifstream in{std::string{FANTAIL_TEST_SOURCE} + "/test/validation/peer_airframes.csv"};
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names;
  std::istringstream header{line};
  for (std::string name; std::getline(header, name, ',');) {
    names.push_back(name);
  }
  std::vector<PeerAirframe> all;
  while (std::getline(in, line)) {
    std::istringstream row{line};
    PeerAirframe peer;
    std::string cell;
    std::getline(row, cell, ',');
    peer.shape.nose_shape = noses.at(cell);
    for (std::size_t i = 1; i < names.size(); ++i) {
      std::getline(row, cell, ',');
      peer.figures[names[i]] = std::stod(cell);
    }
    auto& f = peer.figures;
    peer.shape.diameter_m = f["diameter_m"];
    peer.shape.nose_length_m = f["nose_length_m"];
    peer.shape.length_m = f["position_m"] + f["root_chord_m"];
    peer.shape.fins = Geometry::FinSet{.count = static_cast<int>(f["count"]),
                                       .position_m = f["position_m"],
                                       .root_chord_m = f["root_chord_m"],
                                       .tip_chord_m = f["tip_chord_m"],
                                       .span_m = f["span_m"],
                                       .sweep_m = f["sweep_m"]};
    all.push_back(peer);
  }
  return all;
}

TEST(BuildUp, GivesTheNormalForceCentreOfPressureAndRollThatRocketPyGives) {
  const std::vector<PeerAirframe> peers = peer_airframes();
  ASSERT_GE(peers.size(), 40U);
  for (const PeerAirframe& peer : peers) {
    sim::Vehicle rocket;
    rocket.geometry = peer.shape;
    const BuildUp result = build_up(rocket);
    const auto& f = peer.figures;
    EXPECT_NEAR(result.normal_force_slope_per_rad.value / f.at("slope_per_rad"), 1.0, 1e-6);
    EXPECT_NEAR(result.centre_of_pressure_m.value / f.at("centre_of_pressure_m"), 1.0, 1e-4);
    EXPECT_NEAR(result.roll_damping_m4.value / f.at("roll_damping_m4"), 1.0, 1e-6);
    // Fins as canards: the same set turned.
    const FinForces fins = fin_forces(*peer.shape.fins, 0.5 * peer.shape.diameter_m);
    EXPECT_NEAR(fins.roll_torque_m3 / f.at("roll_torque_m3"), 1.0, 1e-6);
  }
}

TEST(BuildUp, PutsTheCentreOfPressureBetweenItsPartsByTheirSlopes) {
  const BuildUp result = build_up(vehicle());
  ASSERT_EQ(result.parts.size(), 3U);
  double slope = 0.0;
  double moment = 0.0;
  for (const Part& part : result.parts) {
    slope += part.slope_per_rad;
    moment += part.slope_per_rad * part.position_m;
  }
  EXPECT_NEAR(result.normal_force_slope_per_rad.value, slope, 1e-12);
  EXPECT_NEAR(result.centre_of_pressure_m.value, moment / slope, 1e-12);
}

TEST(BuildUp, PromisesNothingOfCanardsWhoseWashMeetsFins) {
  sim::Vehicle rocket = vehicle();
  EXPECT_EQ(build_up(rocket).roll_torque_m3->low, 0.0);
  rocket.geometry->fins.reset();
  const BuildUp alone = build_up(rocket);
  EXPECT_GT(alone.roll_torque_m3->low, 0.0);
  EXPECT_FALSE(alone.cant_as_canards);
}

TEST(BuildUp, HasNoHingeMomentWhereTheShaftIsAtTheQuarterChordAndDoubtsItsSign) {
  const BuildUp result = build_up(vehicle());
  EXPECT_NEAR(result.hinge_moment_m3->value, 0.0, 1e-15);
  EXPECT_LT(result.hinge_moment_m3->low, 0.0);
  EXPECT_GT(result.hinge_moment_m3->high, 0.0);
}

TEST(BuildUp, WeighsPartsAndPropellant) {
  sim::Vehicle rocket = vehicle();
  EXPECT_FALSE(build_up(rocket).after_burnout);
  rocket.geometry->masses = {{.name = "rod", .mass_kg = 3.0, .position_m = 0.75, .length_m = 1.5},
                             {.name = "ring", .mass_kg = 1.0, .position_m = 0.25, .radius_of_gyration_m = 0.04}};
  const BuildUp without = build_up(rocket);
  ASSERT_TRUE(without.after_burnout);
  EXPECT_FALSE(without.at_liftoff);
  EXPECT_NEAR(without.after_burnout->mass_kg, 4.0, 1e-12);
  EXPECT_NEAR(without.after_burnout->centre_of_gravity_m, 0.625, 1e-12);
  EXPECT_NEAR(without.after_burnout->roll_inertia_kg_m2, 0.0016, 1e-12);
  EXPECT_NEAR(without.after_burnout->transverse_inertia_kg_m2,
              3.0 * 1.5 * 1.5 / 12.0 + 3.0 * 0.125 * 0.125 + 0.5 * 0.0016 + 0.375 * 0.375, 1e-12);
  rocket.geometry->propellant = Geometry::Mass{.name = "propellant", .position_m = 1.4};
  rocket.motor = sim::ThrustCurve{
      {{.time_s = 0.0, .thrust_n = 0.0}, {.time_s = 1.0, .thrust_n = 100.0}, {.time_s = 2.0, .thrust_n = 0.0}}, 0.5};
  EXPECT_NEAR(build_up(rocket).at_liftoff->centre_of_gravity_m, (4.0 * 0.625 + 0.5 * 1.4) / 4.5, 1e-12);
}

}  // namespace
}  // namespace fantail::airframe::model
