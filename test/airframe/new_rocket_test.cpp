// SPDX-License-Identifier: MIT
#include "airframe/new_rocket.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "airframe/model/build_up.hpp"
#include "fly/fly_scenario.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"

namespace fantail::airframe {
namespace {

class NewRocketFiles : public testing::Test {
 protected:
  NewRocketFiles() : folder_{std::filesystem::temp_directory_path() / ("fantail_new_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(folder_);
  }
  ~NewRocketFiles() override { std::filesystem::remove_all(folder_); }

  sim::Scenario made_from(const sim::Vehicle& vehicle) {
    for (const auto& [name, content] : files_of({.name = "a \"new\" one\\",
                                                 .vehicle = vehicle,
                                                 .motor_file = "i150_canonical",
                                                 .source = "a test",
                                                 .assumed = {}})) {
      std::ofstream{folder_ / name} << content;
    }
    return input::load_scenario((folder_ / "scenario.toml").string(), {});
  }

 private:
  std::filesystem::path folder_;
};

sim::Vehicle shipped() {
  return input::read_vehicle(
      input::Document::load(input::find_input(input::Shipped::vehicle, "tasha3_launch2").string()));
}

TEST_F(NewRocketFiles, HaveTheShapeThatTheyWereMadeFromAndItsNumbers) {
  sim::Vehicle source = shipped();
  source.geometry->transition = {.position_m = 1.1, .length_m = 0.1, .aft_diameter_m = 0.07};
  source.geometry->fins->cant_rad = 0.02;
  source.geometry->nose_shape = sim::Geometry::NoseShape::haack;
  const sim::Vehicle made = made_from(source).vehicle;
  EXPECT_EQ(made.name, "a \"new\" one\\");
  EXPECT_TRUE(made.warnings.empty()) << made.warnings.front();
  const model::BuildUp before = model::build_up(source);
  const model::BuildUp after = model::build_up(made);
  EXPECT_NEAR(after.centre_of_pressure_m.value, before.centre_of_pressure_m.value, 1e-12);
  EXPECT_NEAR(after.roll_torque_m3->value, before.roll_torque_m3->value, 1e-15);
  EXPECT_NEAR(after.at_liftoff->transverse_inertia_kg_m2, before.at_liftoff->transverse_inertia_kg_m2, 1e-12);
  EXPECT_NEAR(made.geometry->fins->cant_rad, 0.02, 1e-12);
  EXPECT_EQ(made.mass_kg, source.mass_kg);
  const double area_m2 = made.roll_plant.reference_area_m2;
  EXPECT_NEAR(made.roll_plant.damping_m2 * area_m2 / before.roll_damping_m4.value, 1.0, 1e-5);
  EXPECT_NEAR(made.roll_plant.torque_m * area_m2 / before.roll_torque_m3->value, 1.0, 1e-5);
  EXPECT_NEAR(*made.canard_air.arm_m / *before.canard_arm_m, 1.0, 1e-5);
  EXPECT_NEAR(*made.canard_air.stall_rad, 13.0 * sim::radians_per_degree, 1e-12);
  EXPECT_EQ(made.compressibility, sim::Compressibility::prandtl_glauert);
  EXPECT_NEAR(made.airframe->centre_of_pressure_m / before.centre_of_pressure_m.value, 1.0, 1e-5);
  EXPECT_NEAR(made.airframe->at_liftoff.centre_of_gravity_m / before.at_liftoff->centre_of_gravity_m, 1.0, 1e-5);
}

TEST_F(NewRocketFiles, FlyInSixDegreesOfFreedomAndReachApogee) {
  const flight::Flight flight = fly::fly_scenario(made_from(shipped()));
  EXPECT_GT(flight.events.apogee_s.value(), 5.0);
}

TEST_F(NewRocketFiles, FlyStraightWhereNobodyWeighedTheParts) {
  sim::Vehicle source = shipped();
  source.geometry->masses.clear();
  source.geometry->propellant.reset();
  const sim::Scenario scenario = made_from(source);
  EXPECT_FALSE(scenario.vehicle.airframe);
  EXPECT_EQ(scenario.vehicle.roll_plant.inertia_kg_m2, source.roll_plant.inertia_kg_m2);
  EXPECT_GT(fly::fly_scenario(scenario).events.apogee_s.value(), 5.0);
}

}  // namespace
}  // namespace fantail::airframe
