// SPDX-License-Identifier: MIT
#include "input/vehicle_file.hpp"

#include "input/scenario_file.hpp"
#include "scratch_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

sim::Vehicle vehicle(const std::string& scenario, const std::vector<std::string>& changes = {}) {
  return load_scenario(scenario, parse_overrides(changes)).vehicle;
}

std::string refusal(const std::string& change) {
  const Complaint refused = complaint([&] { (void)vehicle("tasha3_launch2", {change}); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
  return refused.message;
}

TEST(CanardTolerances, AreTheDefaultsWhereTheVehicleSaysNothing) {
  const sim::CanardTolerances defaults;
  for (const char* name : {"tasha3_launch2", "bench_healthy"}) {  // the second writes them out
    const sim::CanardTolerances t = vehicle(name).canard_tolerances;
    EXPECT_DOUBLE_EQ(t.reach_rad, defaults.reach_rad);
    EXPECT_DOUBLE_EQ(t.tracking_rad, defaults.tracking_rad);
    EXPECT_DOUBLE_EQ(t.centring_rad, defaults.centring_rad);
    EXPECT_DOUBLE_EQ(t.backlash_rad, defaults.backlash_rad);
    EXPECT_DOUBLE_EQ(t.slowest_slew_rad_s, defaults.slowest_slew_rad_s);
    EXPECT_DOUBLE_EQ(t.longest_step_time_s, defaults.longest_step_time_s);
    EXPECT_DOUBLE_EQ(t.noise_rad, defaults.noise_rad);
    EXPECT_DOUBLE_EQ(t.dropout_share, defaults.dropout_share);
  }
}

TEST(CanardTolerances, AreReadEachIntoItsOwnField) {
  const sim::CanardTolerances t =
      vehicle("bench_healthy", {"canard_tolerances.reach_deg=0.1", "canard_tolerances.tracking_deg=0.2",
                                "canard_tolerances.centring_deg=0.3", "canard_tolerances.backlash_deg=0.4",
                                "canard_tolerances.slowest_slew_deg_s=200", "canard_tolerances.longest_step_time_s=0.6",
                                "canard_tolerances.noise_deg=0.7", "canard_tolerances.dropout_percent=8"})
          .canard_tolerances;
  EXPECT_DOUBLE_EQ(t.reach_rad / sim::radians_per_degree, 0.1);
  EXPECT_DOUBLE_EQ(t.tracking_rad / sim::radians_per_degree, 0.2);
  EXPECT_DOUBLE_EQ(t.centring_rad / sim::radians_per_degree, 0.3);
  EXPECT_DOUBLE_EQ(t.backlash_rad / sim::radians_per_degree, 0.4);
  EXPECT_DOUBLE_EQ(t.slowest_slew_rad_s / sim::radians_per_degree, 200.0);
  EXPECT_DOUBLE_EQ(t.longest_step_time_s, 0.6);
  EXPECT_DOUBLE_EQ(t.noise_rad / sim::radians_per_degree, 0.7);
  EXPECT_DOUBLE_EQ(t.dropout_share, 0.08);
}

TEST(CanardTolerances, AreRefusedOutOfRangeAndByAWrongName) {
  EXPECT_EQ(
      refusal("canard_tolerances.reach_deg=0"),
      "--set canard_tolerances.reach_deg=0: canard_tolerances.reach_deg = 0 is out of range; allowed: 0.05 to 10");
  EXPECT_EQ(refusal("canard_tolerances.dropout_percent=51"),
            "--set canard_tolerances.dropout_percent=51: canard_tolerances.dropout_percent = 51 is out of range; "
            "allowed: 0 to 50");
  EXPECT_NE(refusal("body.roll_inertia_kg_m2=1.3")
                .find("airframe.transverse_inertia_kg_m2 = 0.6; allowed: at least "
                      "half of the roll inertia then, 1.3, as no body has less"),
            std::string::npos)
      << refusal("body.roll_inertia_kg_m2=1.3");
  EXPECT_EQ(refusal("canard_tolerances.centering_deg=1"),
            "--set canard_tolerances.centering_deg=1: unknown key canard_tolerances.centering_deg; did you mean "
            "canard_tolerances.centring_deg?");
}

TEST(ServoSpread, IsRefusedOutOfRangeAndBeyondTheStop) {
  EXPECT_EQ(refusal("servo.spread=0.31"),
            "--set servo.spread=0.31: servo.spread = 0.31 is out of range; allowed: 0 to 0.3");
  EXPECT_EQ(refusal("servo.centre_spread_deg=2.1"),
            "--set servo.centre_spread_deg=2.1: servo.centre_spread_deg = 2.1 is out of range; allowed: 0 to 2");
  const Complaint refused =
      complaint([] { (void)vehicle("tasha3_launch2", {"servo.stop_deg=1", "servo.centre_spread_deg=1.5"}); });
  EXPECT_EQ(refused.message,
            "--set servo.centre_spread_deg=1.5: servo.centre_spread_deg = 1.5; allowed: at most stop_deg = 1");
}

TEST(Barometer, IsNotFittedUnlessTheVehicleSaysSoAndHasItsNumbersEachInItsOwnField) {
  EXPECT_FALSE(vehicle("tasha3_launch2").barometer.is_fitted);
  const sim::BarometerParameters read =
      vehicle("tasha3_launch2", {"barometer.fitted=yes", "barometer.noise_pa=2", "barometer.port_error=-0.05",
                                 "barometer.vent_lag_s=0.2", "barometer.offset_pa=-300"})
          .barometer;
  EXPECT_TRUE(read.is_fitted);
  EXPECT_EQ(read.noise_pa, 2.0);
  EXPECT_EQ(read.port_error, -0.05);
  EXPECT_EQ(read.vent_lag_s, 0.2);
  EXPECT_EQ(read.offset_pa, -300.0);
}

TEST(Barometer, IsRefusedOutOfRange) {
  const auto refused_with = [](const std::string& key, const std::string& value, const std::string& allowed) {
    const std::string change = "barometer." + key + "=" + value;
    EXPECT_EQ(refusal(change),
              "--set " + change + ": barometer." + key + " = " + value + " is out of range; allowed: " + allowed);
  };
  refused_with("noise_pa", "-1", "0 to 500");
  refused_with("noise_pa", "501", "0 to 500");
  refused_with("port_error", "1.1", "-1 to 1");
  refused_with("port_error", "-1.1", "-1 to 1");
  refused_with("vent_lag_s", "-0.1", "0 to 5");
  refused_with("vent_lag_s", "5.1", "0 to 5");
  refused_with("offset_pa", "5001", "-5000 to 5000");
  refused_with("offset_pa", "-5001", "-5000 to 5000");
}

TEST(VehicleFile, ARangeOfTheReferenceAreaIsTwoAreasAroundIt) {
  EXPECT_EQ(vehicle("tasha3_launch2", {}).reference_area_range_m2, (std::vector{3.2e-5, 7.7e-5}));
  for (const char* range : {"[3.2e-5]", "[6e-5, 7.7e-5]", "[7.7e-5, 3.2e-5]", "[3.2e-5, 4e-5]"}) {
    const Complaint said = complaint(
        [&] { (void)vehicle("tasha3_launch2", {std::string{"aerodynamics.reference_area_range_m2="} + range}); });
    EXPECT_NE(said.message.find("must be two areas, one below and one above reference_area_m2 = 5.0265e-05"),
              std::string::npos)
        << said.message;
  }
}

TEST(VehicleFile, DragOverTheMachNumberIsTwoListsOfOneLengthAndTheFirstRises) {
  const sim::Vehicle read = vehicle("tasha3_launch2", {"body.drag_mach=[0.3, 0.8]", "body.drag_factor=[1, 1.4]"});
  EXPECT_EQ(read.drag_over_mach.mach, (std::vector{0.3, 0.8}));
  EXPECT_EQ(read.drag_over_mach.factor, (std::vector{1.0, 1.4}));
  const auto refused = [](const std::vector<std::string>& changes) {
    return complaint([&] { (void)vehicle("tasha3_launch2", changes); }).message;
  };
  EXPECT_EQ(refused({"body.drag_mach=[0.3, 0.8]", "body.drag_factor=[1]"}),
            "--set body.drag_factor=[1]: body.drag_factor has 1 values and drag_mach has 2; allowed: the same number");
  EXPECT_EQ(refused({"body.drag_mach=[0.3, 0.3]", "body.drag_factor=[1, 2]"}),
            "--set body.drag_mach=[0.3, 0.3]: body.drag_mach has 0.3 after 0.3; allowed: each larger than the one "
            "before");
  EXPECT_NE(refused({"body.drag_mach=[0.3]"}).find("body.drag_factor has 0 values and drag_mach has 1"),
            std::string::npos);
}

TEST(VehicleFile, TheCanardsAreNotMoreThanAllOfTheRollDamping) {
  EXPECT_EQ(vehicle("tasha3_launch2", {"aerodynamics.canard_arm_m=2"}).canard_air.arm_m, 2.0);
  const Complaint said = complaint([] {
    (void)vehicle("tasha3_launch2",
                  {"aerodynamics.damping_m2=8", "aerodynamics.torque_m=10", "aerodynamics.canard_arm_m=0.9"});
  });
  EXPECT_EQ(said.message,
            "--set aerodynamics.canard_arm_m=0.9: aerodynamics.canard_arm_m = 0.9; allowed: at most damping_m2 / "
            "torque_m = 0.8, where the canards would make all of the roll damping");
}

TEST(VehicleFile, WhatACanardDoesToTheSideNeedsItsPlaceAndItsPlaceNeedsThat) {
  const sim::Vehicle read =
      vehicle("tasha3_launch2", {"aerodynamics.canard_side_area_m2=0.002", "aerodynamics.canard_position_m=0.3"});
  EXPECT_EQ(read.canard_air.side_area_m2, 0.002);
  EXPECT_EQ(read.canard_air.position_m, 0.3);
  const auto refused = [](const std::string& change) {
    return complaint([&] { (void)vehicle("tasha3_launch2", {change}); }).message;
  };
  EXPECT_EQ(refused("aerodynamics.canard_side_area_m2=0.002"),
            "--set aerodynamics.canard_side_area_m2=0.002: aerodynamics.canard_side_area_m2 needs canard_position_m");
  EXPECT_EQ(refused("aerodynamics.canard_position_m=0.3"),
            "--set aerodynamics.canard_position_m=0.3: aerodynamics.canard_position_m needs canard_side_area_m2");
}

// 3.99 kg with 0.226 kg of propellant; 1.51 m long, centres of gravity 0.90 and 0.875 m.
TEST(VehicleFile, APropellantOutsideOfTheRocketIsRefused) {
  const auto refused = [](const std::string& change) {
    return complaint([&] { (void)vehicle("tasha3_launch2", {"flight.motion=six_dof", change}); }).message;
  };
  const double propellant_kg = vehicle("tasha3_launch2", {}).motor.propellant_kg();
  const double least_m = (3.99 * 0.90 - propellant_kg * 1.51) / (3.99 - propellant_kg);
  const double most_m = 3.99 * 0.90 / (3.99 - propellant_kg);
  const auto after = [](double place_m) {
    return "airframe.centre_of_gravity_after_burnout_m=" + std::to_string(place_m);
  };
  EXPECT_NO_THROW((void)vehicle("tasha3_launch2", {"flight.motion=six_dof", after(least_m)}));
  EXPECT_NO_THROW((void)vehicle("tasha3_launch2", {"flight.motion=six_dof", after(most_m)}));
  EXPECT_NE(refused(after(least_m - 0.002)).find("airframe.centre_of_gravity_after_burnout_m = 0.86"),
            std::string::npos)
      << refused(after(least_m - 0.002));
  EXPECT_NE(refused(after(most_m + 0.002)).find("lies between nose and tail"), std::string::npos);
}

// Another mass or motor alone does not fit the centres of gravity; along a straight line they decide nothing.
TEST(VehicleFile, AHeavierRocketMayBeAskedForAlongAStraightLine) {
  EXPECT_NO_THROW((void)vehicle("tasha3_launch2", {"body.mass_kg=20"}));
  EXPECT_NE(complaint([] {
              (void)vehicle("tasha3_launch2", {"body.mass_kg=20", "flight.motion=six_dof"});
            }).message.find("airframe.centre_of_gravity_after_burnout_m = 0.875; allowed: 0.893"),
            std::string::npos);
}

TEST(VehicleFile, ATransverseInertiaThatNoBodyHasIsRefused) {
  const std::string across = "airframe.transverse_inertia_kg_m2=";
  const auto refused = [](const std::string& change) {
    return complaint([&] { (void)vehicle("tasha3_launch2", {"flight.motion=six_dof", change}); }).message;
  };
  const double propellant_kg = vehicle("tasha3_launch2", {}).motor.propellant_kg();
  // At most all of it at nose and tail: m x (L - x), beside half of the roll inertia.
  const double most_kg_m2 = 0.5 * 0.00393 + 3.99 * 0.90 * 0.61;
  const double most_after_kg_m2 = 0.5 * 0.00393 + (3.99 - propellant_kg) * 0.875 * 0.635;
  EXPECT_NO_THROW(
      (void)vehicle("tasha3_launch2", {"flight.motion=six_dof", across + std::to_string(most_kg_m2 - 1e-4)}));
  EXPECT_NE(refused(across + std::to_string(most_kg_m2 + 1e-4)).find("allowed: at most 2.19"), std::string::npos);
  EXPECT_NE(refused("airframe.transverse_inertia_after_burnout_kg_m2=" + std::to_string(most_after_kg_m2 + 1e-4))
                .find("at nose and tail"),
            std::string::npos);
  // At least two lumps, 25 mm (less one) from their common centre as the propellant leaves: m0 m1 / mp 0.024^2.
  const double least_kg_m2 = 0.5 * 0.00393 + 3.99 * (3.99 - propellant_kg) / propellant_kg * 0.024 * 0.024;
  EXPECT_NO_THROW(
      (void)vehicle("tasha3_launch2", {"flight.motion=six_dof", across + std::to_string(least_kg_m2 + 1e-4)}));
  EXPECT_NE(refused(across + std::to_string(least_kg_m2 - 1e-4)).find("moves by 25 mm"), std::string::npos);
}

TEST(VehicleFile, PartsAreSpreadOverNoMoreThanTheRocket) {
  EXPECT_NE(complaint([] {
              (void)vehicle("tasha3_launch2", {"airframe.parts_spread_m=1.6"});
            }).message.find("airframe.parts_spread_m = 1.6; allowed: at most length_m = 1.51"),
            std::string::npos);
}

TEST(VehicleFile, ASensorSitsInItsRocket) {
  const std::vector<std::string> airframe{"airframe.diameter_m=0.1",
                                          "airframe.length_m=1.7",
                                          "airframe.normal_force_slope_per_rad=10",
                                          "airframe.centre_of_pressure_m=1.2",
                                          "airframe.parts_spread_m=0.3",
                                          "airframe.centre_of_gravity_m=1",
                                          "airframe.centre_of_gravity_after_burnout_m=0.97",
                                          "airframe.transverse_inertia_kg_m2=0.6",
                                          "airframe.transverse_inertia_after_burnout_kg_m2=0.5"};
  const auto refused = [&](const std::string& change) {
    std::vector<std::string> changes = airframe;
    changes.push_back(change);
    return complaint([&] { (void)vehicle("tasha3_launch2", changes); }).message;
  };
  for (const std::string sensor : {"imu", "accelerometer"}) {
    EXPECT_EQ(refused(sensor + ".position_m=1.8"),
              "--set " + sensor + ".position_m=1.8: " + sensor +
                  ".position_m = 1.8 is behind the tail; allowed: at most airframe.length_m = 1.7");
    EXPECT_EQ(
        refused(sensor + ".across_m=-0.06"),
        "--set " + sensor + ".across_m=-0.06: " + sensor +
            ".across_m = -0.06 is outside the body; allowed: within half of airframe.diameter_m, 0.05 either way");
  }
}

// A unit that leaves out what it is per is a wrong figure by a factor of ten, or of sixty.
TEST(VehicleFile, AGyroHasItsUnitsInFull) {
  for (const auto& [key, unit] :
       {std::pair{"rate_per_g_deg_s", "deg/s per g"}, std::pair{"rate_drift_deg_s_per_min", "deg/s per min"}}) {
    const auto found = std::ranges::find(vehicle_fields(), std::string_view{key}, &Field<sim::Vehicle>::key);
    ASSERT_NE(found, vehicle_fields().end());
    EXPECT_EQ(found->allowed.unit.name, unit);
  }
  const sim::FeltMotionParameters feels =
      vehicle("tasha3_launch2", {"imu.rate_per_g_deg_s=0.05", "imu.rate_drift_deg_s_per_min=3"}).imu_feels;
  EXPECT_NEAR(feels.rate_per_specific_force_s_m * 9.80665, 0.05 * sim::radians_per_degree, 1e-9);
  EXPECT_NEAR(feels.rate_drift_rad_s2 * 60.0, 3.0 * sim::radians_per_degree, 1e-12);
}

TEST(BenchVehicle, IsTheAirframeOfTheSecondLaunch) {
  const sim::Vehicle bench = vehicle("bench_healthy");
  const sim::Vehicle launched = vehicle("tasha3_launch2");
  EXPECT_EQ(bench.mass_kg, launched.mass_kg);
  EXPECT_EQ(bench.drag_area_m2, launched.drag_area_m2);
  EXPECT_EQ(bench.roll_plant.inertia_kg_m2, launched.roll_plant.inertia_kg_m2);
  EXPECT_EQ(bench.roll_plant.reference_area_m2, launched.roll_plant.reference_area_m2);
  EXPECT_EQ(bench.roll_plant.damping_m2, launched.roll_plant.damping_m2);
  EXPECT_EQ(bench.roll_plant.torque_m, launched.roll_plant.torque_m);
  EXPECT_EQ(bench.motor.impulse_n_s(), launched.motor.impulse_n_s());
  EXPECT_EQ(launched.servo_spread.share, 0.0);
  EXPECT_EQ(launched.servo_spread.centre_rad, 0.0);
  EXPECT_EQ(bench.servo_spread.share, 0.1);
  EXPECT_NEAR(bench.servo_spread.centre_rad, 0.15 * sim::radians_per_degree, 1e-12);
}

TEST(Trim, IsRefusedBeyondTheStop) {
  const Complaint refused = complaint(
      [] { (void)vehicle("tasha3_launch2", {"canard_mounting.trim_deg=[0, -4.5, 0, 0]", "servo.stop_deg=4"}); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_configuration);
  EXPECT_EQ(refused.message,
            "--set canard_mounting.trim_deg=[0, -4.5, 0, 0]: canard_mounting.trim_deg = -4.5 is out of range; allowed: "
            "within servo.stop_deg, 4 either way");
}

TEST(Motor, IsChosenByItsNameInAFileOfSeveral) {
  const ScratchFile file{"A 54 400 0 0.2 0.5 x\n0.5 300\n3 0\nB 54 400 0 0.3 0.5 x\n0.5 300\n3 2\n", "several.eng"};
  const sim::Vehicle chosen = vehicle("tasha3_launch2", {"motor.file=" + file.path().string() + "#B"});
  EXPECT_DOUBLE_EQ(chosen.motor.propellant_kg(), 0.3);
  ASSERT_EQ(chosen.warnings.size(), 1U);
  EXPECT_NE(chosen.warnings[0].find("several.eng:6: the last thrust is 2 N"), std::string::npos) << chosen.warnings[0];
  const Complaint refused = complaint([&] { (void)vehicle("tasha3_launch2", {"motor.file=" + file.path().string()}); });
  EXPECT_EQ(refused.fault, text::ErrorKind::bad_data);
  EXPECT_NE(refused.message.find("choose one of A, B"), std::string::npos) << refused.message;
}

}  // namespace
}  // namespace fantail::input
