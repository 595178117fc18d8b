// SPDX-License-Identifier: MIT
#include "sim/rigid_flight.hpp"

#include "sim/ascent.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;
constexpr double tick_s = 1e-3;

// Of the second launch of Tasha III: assumed inertia, slope and margin, on the cross-section of its body.
Airframe airframe() {
  return {.diameter_m = 0.08,
          .length_m = 1.51,
          .normal_force_slope_per_rad = 10.0,
          .centre_of_pressure_m = 1.02,
          .parts_spread_m = 0.6,
          .at_liftoff = {.centre_of_gravity_m = 0.90, .transverse_inertia_kg_m2 = 0.6},
          .after_burnout = {.centre_of_gravity_m = 0.88, .transverse_inertia_kg_m2 = 0.55},
          .nozzle_position_m = 1.5};
}

RigidFlightParameters rocket() {
  return {.mass_kg = 3.99,
          .drag_area_m2 = 0.005,
          .roll_inertia_kg_m2 = 0.004,
          .airframe = airframe(),
          .guide = {},
          .guide_length_m = 4.0,
          .atmosphere = {},
          .motor = ThrustCurve{{{0.0, 0.0}, {0.05, 160.0}, {2.5, 130.0}, {3.2, 0.0}}, 0.226}};
}

RigidFlightParameters in_vacuum(RigidFlightParameters parameters) {
  parameters.atmosphere = {.model = DensityModel::constant, .constant_kg_m3 = 0.0};
  return parameters;
}

template <typename Observe>
void fly(RigidFlight& flight, double from_s, double to_s, const Vector3& wind_m_s, double roll_rate_rad_s,
         Observe observe) {
  for (auto i = std::lround(from_s / tick_s) + 1; i <= std::lround(to_s / tick_s); ++i) {
    flight.advance_to(tick_s * static_cast<double>(i), roll_rate_rad_s, wind_m_s);
    observe();
  }
}

RigidFlight flown(const RigidFlightParameters& parameters, double to_s, const Vector3& wind_m_s = {}) {
  RigidFlight flight{parameters};
  fly(flight, 0.0, to_s, wind_m_s, 0.0, [] {});
  return flight;
}

void expect_as_straight(const RigidFlightParameters& parameters, double to_within) {
  Ascent straight{{.mass_kg = parameters.mass_kg,
                   .drag_area_m2 = parameters.drag_area_m2,
                   .guide_tilt_rad = 0.0,
                   .atmosphere = parameters.atmosphere,
                   .motor = parameters.motor,
                   .drag_over_mach = parameters.drag_over_mach}};
  RigidFlight flight{parameters};
  for (int i = 1; i <= 10'300; ++i) {
    const double time_s = tick_s * i;
    straight.advance_to(time_s);
    flight.advance_to(time_s, 0.5, {});
    ASSERT_NEAR(flight.height_m(), straight.height_m(), to_within) << time_s;
    ASSERT_NEAR(flight.air_speed_m_s().x, straight.speed_m_s(), to_within) << time_s;
    ASSERT_NEAR(flight.specific_force_m_s2().x, straight.axial_specific_force_m_s2(), to_within) << time_s;
  }
  EXPECT_EQ(flight.events().liftoff_s, straight.events().liftoff_s);
  EXPECT_EQ(flight.events().burnout_s, straight.events().burnout_s);
  EXPECT_EQ(flight.events().apogee_s, straight.events().apogee_s);
  EXPECT_LT(flight.tilt_rad(), 1e-12);
}

TEST(RigidFlight, WithoutWindOnAVerticalGuideMovesAsTheStraightAscentDoes) { expect_as_straight(rocket(), 1e-6); }

TEST(RigidFlight, MovesAsTheStraightAscentAlsoWithDragOverTheMachNumber) {
  RigidFlightParameters parameters = rocket();
  parameters.drag_over_mach = {.mach = {0.05, 0.15, 0.25}, .factor = {1.4, 0.8, 1.9}};
  parameters.compressibility = Compressibility::prandtl_glauert;
  // Each takes the speed of sound of its own place in the step.
  expect_as_straight(parameters, 1e-4);
}

// Of two that leave the same long guide at Mach 0.6 into the same wind, one has the factor: 1 / sqrt(1 - M^2).
TEST(RigidFlight, TheNormalForceHasThePrandtlGlauertFactorOfItsMachNumber) {
  RigidFlightParameters parameters = rocket();
  parameters.motor = ThrustCurve{{{0.0, 2000.0}, {1.0, 2000.0}, {1.001, 0.0}}, 0.2};
  parameters.guide_length_m = 50.0;
  const Vector3 wind_m_s{.x = 5.0, .y = 2.0, .z = 0.0};
  RigidFlight constant{parameters};
  parameters.compressibility = Compressibility::prandtl_glauert;
  RigidFlight growing{parameters};
  for (int i = 1; !constant.is_clear_of_guide(); ++i) {
    constant.advance_to(tick_s * i, 0.0, wind_m_s);
    growing.advance_to(tick_s * i, 0.0, wind_m_s);
  }
  ASSERT_TRUE(growing.is_clear_of_guide());
  const Vector3 v = growing.air_speed_m_s();
  const double mach = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z) /
                      std::sqrt(1.4 * 287.05287 * (288.15 - 0.0065 * growing.height_m()));
  ASSERT_GT(mach, 0.5);
  const double factor = 1.0 / std::sqrt(1.0 - mach * mach);
  EXPECT_NEAR(growing.specific_force_m_s2().y / constant.specific_force_m_s2().y, factor, 1e-9);
  EXPECT_NEAR(growing.specific_force_m_s2().z / constant.specific_force_m_s2().z, factor, 1e-9);
  EXPECT_EQ(growing.specific_force_m_s2().x, constant.specific_force_m_s2().x);
}

// Thrust acts along the axis and nothing turns it, so the rocket keeps its attitude and flies a parabola after
// burn-out.
TEST(RigidFlight, InAVacuumFliesAParabolaAfterBurnOut) {
  RigidFlightParameters parameters = in_vacuum(rocket());
  parameters.guide.tilt_rad = 10.0 * degrees;
  RigidFlight flight = flown(parameters, 3.3);
  const Vector3 position_m = flight.state().position_m;
  const Vector3 velocity_m_s = flight.state().velocity_m_s;
  const double to_apogee_s = velocity_m_s.z / gravity_m_s2;
  fly(flight, 3.3, 3.3 + to_apogee_s, {}, 0.0, [] {});
  EXPECT_NEAR(flight.height_m(), position_m.z + 0.5 * velocity_m_s.z * to_apogee_s, 1e-3);
  EXPECT_NEAR(flight.state().position_m.x, position_m.x + velocity_m_s.x * to_apogee_s, 0.05);
  EXPECT_NEAR(flight.tilt_rad(), 10.0 * degrees, 1e-12);
}

TEST(RigidFlight, LeansToTheAzimuthOfItsGuideWhichCarriesItAcross) {
  for (const double azimuth_deg : {0.0, 90.0, 200.0}) {
    RigidFlightParameters parameters = rocket();
    parameters.guide = {.tilt_rad = 5.0 * degrees, .azimuth_rad = azimuth_deg * degrees};
    const RigidFlight flight{parameters};
    const Vector3 axis = rotated(flight.state().attitude, {.x = 1.0});
    EXPECT_NEAR(axis.x, std::sin(5.0 * degrees) * std::cos(azimuth_deg * degrees), 1e-12);
    EXPECT_NEAR(axis.y, -std::sin(5.0 * degrees) * std::sin(azimuth_deg * degrees), 1e-12);
    EXPECT_NEAR(axis.z, std::cos(5.0 * degrees), 1e-12);
    EXPECT_NEAR(flight.specific_force_m_s2().x, gravity_m_s2 * std::cos(5.0 * degrees), 1e-12);
    EXPECT_NEAR(flight.specific_force_m_s2().y, gravity_m_s2 * std::sin(5.0 * degrees), 1e-12);
    EXPECT_NEAR(flight.specific_force_m_s2().z, 0.0, 1e-12);
  }
}

TEST(RigidFlight, FrictionOfTheGuideTakesItsShareOfTheWeightAcross) {
  RigidFlightParameters parameters = in_vacuum(rocket());
  parameters.guide.tilt_rad = 10.0 * degrees;
  const RigidFlight smooth = flown(parameters, 0.3);
  parameters.guide.friction = 0.2;
  const RigidFlight rough = flown(parameters, 0.3);
  EXPECT_NEAR(smooth.specific_force_m_s2().x - rough.specific_force_m_s2().x,
              0.2 * gravity_m_s2 * std::sin(10.0 * degrees), 1e-9);
  EXPECT_LT(rough.distance_m(), smooth.distance_m());
}

TEST(RigidFlight, LeavesTheGuideWithTheTipOffRateTowardsTheSideThatItLeansTo) {
  RigidFlightParameters parameters = in_vacuum(rocket());
  parameters.guide = {.tilt_rad = 2.0 * degrees, .tip_off_rad_s = 10.0 * degrees};
  RigidFlight flight = flown(parameters, 0.4);
  ASSERT_FALSE(flight.is_clear_of_guide());
  double clear_s = 0.0;
  for (double time_s = 0.401; !flight.is_clear_of_guide(); time_s += tick_s) {
    flight.advance_to(time_s, 0.0, {});
    clear_s = time_s;
  }
  EXPECT_GT(flight.tilt_rad(), 1.9 * degrees);
  const double before_rad = flight.tilt_rad();
  flight.advance_to(clear_s + tick_s, 0.0, {});
  EXPECT_NEAR((flight.tilt_rad() - before_rad) / tick_s, 10.0 * degrees, 0.05 * degrees);
}

// A stable rocket turns its nose into the wind, and is carried into it while the motor burns.
TEST(RigidFlight, TurnsIntoTheWind) {
  const RigidFlight flight = flown(rocket(), 3.0, {.x = 5.0});  // it blows to the north
  const Vector3 axis = rotated(flight.state().attitude, {.x = 1.0});
  EXPECT_LT(axis.x, -std::sin(2.0 * degrees));
  EXPECT_NEAR(axis.y, 0.0, 1e-9);
  EXPECT_LT(flight.state().position_m.x, -1.0);
}

TEST(RigidFlight, AnUnstableRocketTurnsOver) {
  RigidFlightParameters parameters = rocket();
  parameters.airframe.centre_of_pressure_m = 0.80;
  RigidFlight flight{parameters};
  double largest_rad = 0.0;
  fly(flight, 0.0, 5.0, {.x = 1.0}, 0.0, [&] { largest_rad = std::max(largest_rad, flight.tilt_rad()); });
  EXPECT_GT(largest_rad, 60.0 * degrees);
}

// A rocket that leans falls over slowly along its way: it flies lower than along a straight line.
TEST(RigidFlight, AGuideThatLeansCostsHeight) {
  RigidFlightParameters parameters = rocket();
  const double upright_m = flown(parameters, 10.3).height_m();
  parameters.guide.tilt_rad = 15.0 * degrees;
  RigidFlight leaning{parameters};
  double apogee_m = 0.0;
  fly(leaning, 0.0, 10.3, {}, 0.0, [&] { apogee_m = std::max(apogee_m, leaning.height_m()); });
  EXPECT_LT(apogee_m, 0.93 * upright_m);
  EXPECT_GT(apogee_m, 0.80 * upright_m);
}

// At rest against the flow the push and the normal force make no moment: a = A (x_cg - x_push) / (S slope (x_cp -
// x_cg)). Its way turns to the side of the push: +y of the frame, which is south.
TEST(RigidFlight, APushInFrontOfTheCentreOfGravityTurnsItToTheAngleOfAttackThatBalancesIt) {
  RigidFlight flight{rocket()};
  fly(flight, 0.0, 4.0, {}, 0.0, [] {});
  const double push_m2 = 2e-3 * 0.2;
  const double push_position_m = 0.3;
  flight.push_aside({.y = push_m2}, push_position_m);
  double sum_rad = 0.0;
  int ticks = 0;
  fly(flight, 4.0, 7.0, {}, 0.0, [&] {
    sum_rad += std::atan2(-flight.air_speed_m_s().y, flight.air_speed_m_s().x);
    ++ticks;
  });
  const Airframe frame = airframe();
  const double balance_rad = push_m2 * (0.88 - push_position_m) /
                             (frame.cross_section_m2() * frame.normal_force_slope_per_rad * (1.02 - 0.88));
  EXPECT_NEAR(sum_rad / ticks, balance_rad, 0.1 * balance_rad);
  EXPECT_LT(flight.state().velocity_m_s.x, -1.0);
  EXPECT_NEAR(flight.state().velocity_m_s.y, 0.0, 1e-6);
}

TEST(RigidFlight, APushIsAForceOfTheDynamicPressureTimesItsArea) {
  RigidFlight flight{rocket()};
  fly(flight, 0.0, 2.0, {}, 0.0, [] {});
  const Vector3 before = flight.specific_force_m_s2();
  flight.push_aside({.z = 1e-3}, flight.centre_of_gravity_m());
  fly(flight, 2.0, 2.001, {}, 0.0, [] {});
  const double speed_m_s = flight.air_speed_m_s().x;
  const double force_n = 0.5 * flight.density_kg_m3() * speed_m_s * speed_m_s * 1e-3;
  EXPECT_NEAR(flight.specific_force_m_s2().z - before.z, force_n / flight.mass_kg(), 1e-3 * force_n);
}

TEST(RigidFlight, UnderItsParachuteSinksAtTheSpeedAtWhichDragCarriesItsWeight) {
  RigidFlightParameters parameters = rocket();
  parameters.recovery = Recovery{.delay_s = 1.0, .opening_time_s = 0.5, .drag_area_m2 = 0.8, .position_m = 0.2};
  parameters.drag_area_m2 = 0.0;
  parameters.airframe.normal_force_slope_per_rad = 1e-4;
  parameters.atmosphere = {.model = DensityModel::constant, .constant_kg_m3 = 1.2};
  RigidFlight flight{parameters};
  double apogee_s = 0.0;
  fly(flight, 0.0, 30.0, {}, 0.0, [&] { apogee_s = flight.events().apogee_s.value_or(0.0); });
  EXPECT_NEAR(flight.parachute_s().value(), apogee_s + 1.0, 2.0 * tick_s);
  const double weight_n = (3.99 - 0.226) * gravity_m_s2;
  EXPECT_NEAR(flight.state().velocity_m_s.z, -std::sqrt(weight_n / (0.5 * 1.2 * 0.8)), 0.02);
  EXPECT_NEAR(length(flight.specific_force_m_s2()), gravity_m_s2, 0.1);
  fly(flight, 30.0, 200.0, {}, 0.0, [] {});
  EXPECT_TRUE(flight.events().landing_s.has_value());
  EXPECT_EQ(flight.height_m(), 0.0);
  EXPECT_TRUE(flight.is_on_ground());
}

// Its recovery sees that the rocket sinks, and knows nothing of what the motor still has.
TEST(RigidFlight, AMotorThatPausesOpensTheParachuteAndLiftsTheRocketToItsApogee) {
  RigidFlightParameters parameters = rocket();
  parameters.motor = ThrustCurve{
      {{0.0, 160.0}, {0.5, 160.0}, {0.51, 0.0}, {3.0, 0.0}, {3.01, 300.0}, {5.0, 300.0}, {5.01, 0.0}}, 0.226};
  parameters.recovery = Recovery{.delay_s = 0.2, .opening_time_s = 0.5, .drag_area_m2 = 0.01, .position_m = 0.2};
  RigidFlight flight{parameters};
  double time_s = 0.0;
  double first_sank_s = 0.0;
  fly(flight, 0.0, 20.0, {}, 0.0, [&] {
    time_s += tick_s;
    first_sank_s = first_sank_s == 0.0 && flight.state().velocity_m_s.z < 0.0 ? time_s : first_sank_s;
  });
  ASSERT_LT(first_sank_s, 3.0);
  EXPECT_NEAR(flight.parachute_s().value(), first_sank_s + 0.2, 2.0 * tick_s);
  EXPECT_GT(flight.events().apogee_s.value(), 5.0);
}

TEST(RigidFlight, ACentreOfGravityMovesWithThePropellant) {
  RigidFlight flight{rocket()};
  EXPECT_DOUBLE_EQ(flight.centre_of_gravity_m(), 0.90);
  fly(flight, 0.0, 4.0, {}, 0.0, [] {});
  EXPECT_NEAR(flight.centre_of_gravity_m(), 0.88, 1e-12);
  EXPECT_NEAR(flight.mass_kg(), 3.99 - 0.226, 1e-12);
}

TEST(RigidFlight, StandsOnThePadUntilTheMotorLiftsIt) {
  RigidFlight flight{rocket()};
  flight.advance_to(-1.0, 0.0, {});
  EXPECT_TRUE(flight.is_on_ground());
  EXPECT_DOUBLE_EQ(flight.specific_force_m_s2().x, gravity_m_s2);
  EXPECT_EQ(flight.events().liftoff_s, std::nullopt);
}

}  // namespace
}  // namespace fantail::sim
