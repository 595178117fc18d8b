// SPDX-License-Identifier: MIT
#include "airframe/new_rocket.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <unistd.h>

#include "airframe/model/build_up.hpp"
#include "core/flight_plan_fields.hpp"
#include "figures.hpp"
#include "fly/fly_scenario.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "sim/units.hpp"
#include "stability/roll_loop.hpp"
#include "text/number.hpp"

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
                                                 .assumed = {}})
                                           .files) {
      std::ofstream{folder_ / name} << content;
    }
    return input::load_scenario((folder_ / "scenario.toml").string(), {});
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

sim::Vehicle shipped() {
  return input::read_vehicle(
      input::Document::load(input::find_input(input::Shipped::vehicle, "tasha3_launch2").string()));
}

TEST_F(NewRocketFiles, HaveTheShapeThatTheyWereMadeFromAndItsNumbers) {
  sim::Vehicle source = shipped();
  source.geometry->transitions = {{.position_m = 1.1, .length_m = 0.1, .aft_diameter_m = 0.07}};
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

TEST_F(NewRocketFiles, KeepWhatADesignFileHasStoredAndWhatWasLeftOut) {
  sim::Vehicle source = shipped();
  source.geometry->design = {.file = "a \"b\".ork",
                             .flight = "Calm",
                             .mass_kg = 5.0,
                             .centre_of_gravity_m = 0.7,
                             .centre_of_pressure_m = 1.1,
                             .angle_of_attack_rad = 0.02,
                             .margin_calibres = 2.5,
                             .left_out = {"fins \"Wing\": their forces"}};
  const sim::Vehicle vehicle = made_from(source).vehicle;
  const auto& made = vehicle.geometry->design;
  ASSERT_TRUE(made);
  EXPECT_EQ(made->file, "a \"b\".ork");
  EXPECT_EQ(made->flight, "Calm");
  EXPECT_DOUBLE_EQ(*made->mass_kg, 5.0);
  EXPECT_DOUBLE_EQ(*made->centre_of_gravity_m, 0.7);
  EXPECT_DOUBLE_EQ(*made->centre_of_pressure_m, 1.1);
  EXPECT_NEAR(made->angle_of_attack_rad, 0.02, 1e-6);
  EXPECT_DOUBLE_EQ(*made->margin_calibres, 2.5);
  EXPECT_EQ(made->left_out, source.geometry->design->left_out);
  EXPECT_TRUE(std::ranges::any_of(vehicle.assumed, [&](const std::string& sentence) {
    return sentence.find(made->file) != std::string::npos && sentence.find(made->left_out[0]) != std::string::npos;
  }));
}

// The step after the first flight is a campaign, and a scenario without a spread is refused there.
TEST_F(NewRocketFiles, HaveASpreadForEveryRangeThatTheShapeHas) {
  const auto scenario_of = [](const sim::Vehicle& vehicle) {
    const NewFiles made = files_of(
        {.name = "one", .vehicle = vehicle, .motor_file = "i150_canonical", .source = "a test", .assumed = {}});
    return std::ranges::find(made.files, "scenario.toml", &text::NamedFile::name)->content;
  };
  const auto has = [](const std::string& scenario, const std::string& field) {
    return scenario.find("\n[[spread]]\nfield = \"" + field + "\"\n") != std::string::npos;
  };
  const std::string whole = scenario_of(shipped());
  for (const char* field : {"aerodynamics.damping_m2", "aerodynamics.torque_m", "disturbance.angles_deg",
                            "body.mass_kg", "airframe.centre_of_pressure_m", "wind.speed_m_s"}) {
    EXPECT_TRUE(has(whole, field)) << field;
  }
  sim::Vehicle bare = shipped();
  bare.geometry->canards.reset();
  bare.geometry->masses.clear();
  bare.geometry->propellant.reset();
  const std::string straight = scenario_of(bare);
  for (const char* field : {"aerodynamics.torque_m", "airframe.centre_of_pressure_m", "wind.speed_m_s"}) {
    EXPECT_FALSE(has(straight, field)) << field;
  }
}

// A degree of cant is as cant_as_canards says; at the end of a roll the torque of the canards is that of the damping.
TEST_F(NewRocketFiles, SayFirstWhatDecidesTheProject) {
  const model::BuildUp b = model::build_up(shipped());
  FirstGains first{};
  first.begin_speed_m_s = 20.0;
  first.highest_speed_m_s = 80.0;
  const double limit_rad = 9.0 * sim::radians_per_degree;
  const std::vector<std::string> said = what_decides(b, first, limit_rad);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_NE(said[0].find("takes " + text::fixed(b.cant_as_canards->value, 2) + " deg"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("undo a cant of " + text::fixed(9.0 / b.cant_as_canards->value, 1) + " deg"),
            std::string::npos)
      << said[0];
  EXPECT_NE(said[0].find("none at all"), std::string::npos) << "canards ahead of fins may lose all of their torque";
  const double area_m2 = 0.25 * std::numbers::pi * 0.08 * 0.08;
  const double alpha_m2 = b.roll_damping_m4.value / area_m2;
  const double beta_m = b.roll_torque_m3->value / area_m2;
  const auto rate_deg_s = [&](double speed_m_s) {
    return text::fixed(9.0 * speed_m_s * beta_m / alpha_m2, 0) + " deg/s";
  };
  EXPECT_NE(said[1].find("up to " + rate_deg_s(20.0) + " at 20 m/s"), std::string::npos) << said[1];
  EXPECT_NE(said[1].find("At 80 m/s, its top speed, it is " + rate_deg_s(80.0)), std::string::npos) << said[1];
  EXPECT_TRUE(what_decides(b, std::nullopt, limit_rad).size() == 1);
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

sim::Vehicle with_large_canards(double factor) {
  sim::Vehicle vehicle = shipped();
  vehicle.geometry->canards->span_m *= factor;
  vehicle.geometry->canards->root_chord_m *= factor;
  vehicle.geometry->canards->tip_chord_m *= factor;
  return vehicle;
}

// The loop of the plan that was made, wherever damping and torque lie in their ranges.
double least_phase_margin_deg(sim::Scenario scenario, double from_m_s, double to_m_s) {
  const sim::RollPlant made = scenario.vehicle.roll_plant;
  double least_deg = 180.0;
  for (double speed_m_s = from_m_s; speed_m_s <= to_m_s; speed_m_s += 0.5) {
    for (const double damping : {0.5, 1.0, 2.0}) {
      for (const double torque : {0.5, 1.0, 2.0}) {
        scenario.vehicle.roll_plant.damping_m2 = damping * made.damping_m2;
        scenario.vehicle.roll_plant.torque_m = torque * made.torque_m;
        const auto found = stability::phase_margin_rad(stability::loop_at_speed(scenario, speed_m_s));
        least_deg = std::min(least_deg, found ? *found / sim::radians_per_degree : 180.0);
      }
    }
  }
  return least_deg;
}

TEST_F(NewRocketFiles, HaveGainsThatSuitTheirCanards) {
  const sim::Scenario small = made_from(shipped()), large = made_from(with_large_canards(2.0));
  EXPECT_LT(large.plan.controller.derivative_gain_s, small.plan.controller.derivative_gain_s);
  for (const sim::Scenario& made : {small, large}) {
    EXPECT_GE(least_phase_margin_deg(made, 20.5, 82.0), 29.9);
  }
  // With the usual ones the second would swing by itself.
  sim::Scenario usual = large;
  usual.plan.controller = core::default_plan().controller;
  EXPECT_LT(least_phase_margin_deg(usual, 20.5, 82.0), 0.0);
}

/// How far a flight is from its reference under control, from so many seconds after its begin on, by the truth alone.
double farthest_deg(const flight::Flight& flight, double after_s) {
  double zero_rad = 0.0;
  double farthest_rad = 0.0;
  for (const flight::Row& row : flight.rows) {
    if (row.phase < core::Phase::controlling) {
      zero_rad = row.phase == core::Phase::launched ? zero_rad : row.truth->roll_angle_rad;
    } else if (row.phase == core::Phase::controlling && row.time_s >= *flight.events.control_start_s + after_s) {
      farthest_rad = std::max(farthest_rad, std::abs(row.truth->roll_angle_rad - zero_rad));
    }
  }
  return farthest_rad / sim::radians_per_degree;
}

// With 3 deg of offset all would rest more than 20 deg from their reference without an observer.
TEST_F(NewRocketFiles, HoldTheRollAgainstTheFinOffsetThatTheyState) {
  sim::Vehicle light = shipped();
  light.mass_kg = 2.77;
  for (sim::Geometry::Mass& part : light.geometry->masses) {
    part.mass_kg *= (2.77 - light.motor.propellant_kg()) / (3.99 - light.motor.propellant_kg());
  }
  for (const sim::Vehicle& source : {shipped(), with_large_canards(1.5), light}) {
    const sim::Scenario made = made_from(source);
    EXPECT_NEAR(made.disturbance.front().angle_rad, 3.0 * sim::radians_per_degree, 1e-9);
    EXPECT_EQ(made.plan.offset.rejection, core::OffsetRejection::observer);
    const flight::Flight flight = fly::fly_scenario(made);
    EXPECT_GT(*flight.events.control_end_s - *flight.events.control_start_s, 5.0);
    EXPECT_LT(farthest_deg(flight, 1.0), 10.0) << made.plan.controller.proportional_gain;
    EXPECT_LT(farthest_deg(flight, 5.0), 2.0);
    EXPECT_GE(least_phase_margin_deg(made, 25.5, 82.0), 29.9);
  }
}

// `plan check` warns of a phase margin below 45 deg, and of a tilt limit above 30 deg from the guide.
TEST_F(NewRocketFiles, HaveAPlanOfWhichPlanCheckDoesNotWarn) {
  for (const sim::Vehicle& source : {shipped(), with_large_canards(2.0), with_large_canards(0.7)}) {
    const sim::Scenario made = made_from(source);
    EXPECT_NEAR(made.plan.run.tilt_limit.degrees(), 30.0, 1e-5);
    EXPECT_EQ(made.plan.run.tilt_from, core::TiltOrigin::guide);
    for (double speed_m_s = 19.5; speed_m_s <= 82.5; speed_m_s += 0.5) {
      const auto margin_rad = stability::phase_margin_rad(stability::loop_at_speed(made, speed_m_s));
      EXPECT_GE(margin_rad.value_or(3.0), 45.0 * sim::radians_per_degree) << speed_m_s;
    }
  }
}

TEST_F(NewRocketFiles, HaveTheOffsetOfCantedFins) {
  sim::Vehicle source = shipped();
  source.geometry->fins->cant_rad = 0.01;
  const double computed_rad = 0.01 * model::build_up(source).cant_as_canards->value;
  EXPECT_NEAR(made_from(source).disturbance.front().angle_rad / computed_rad, 1.0, 1e-5);
  source.geometry->fins->cant_rad = -0.15;
  const sim::Scenario most = made_from(source);
  EXPECT_NEAR(most.disturbance.front().angle_rad, -45.0 * sim::radians_per_degree, 1e-9);
  EXPECT_NEAR(std::stod(figures(most.assumed.front()).at(0)), -15.0 * computed_rad / sim::radians_per_degree, 0.5)
      << most.assumed.front();
}

// Who has a package has no folder docs.
TEST_F(NewRocketFiles, SayOfTheDetectionThatItIsThatOfAShippedPlanWhichItIs) {
  const core::FlightPlan made = made_from(shipped()).plan;
  const core::FlightPlan named = input::load_scenario("tasha3_launch2", {}).plan;
  EXPECT_EQ(made.launch_detection.low_pass_hz, named.launch_detection.low_pass_hz);
  EXPECT_EQ(made.launch_detection.disagreement_m_s2, named.launch_detection.disagreement_m_s2);
  for (const auto& file :
       files_of({.name = "x", .vehicle = shipped(), .motor_file = "m", .source = "s", .assumed = {}}).files) {
    EXPECT_EQ(file.content.find("docs/"), std::string::npos) << file.content;
  }
}

}  // namespace
}  // namespace fantail::airframe
