// SPDX-License-Identifier: MIT
#include "sim/ascent.hpp"

#include <filesystem>

#include "degree.hpp"
#include "input/rasp_file.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

AscentParameters tasha(double mass_kg) {
  return {.mass_kg = mass_kg,
          .drag_area_m2 = 0.0050,
          .motor = input::load_rasp(std::filesystem::path{FANTAIL_TEST_MOTORS} / "i150_canonical.eng").curve};
}

// Full thrust from ignition to `burn_s`, next to no propellant, no air: the closed forms of school.
AscentParameters vacuum(double mass_kg, double thrust_n, double burn_s) {
  return {.mass_kg = mass_kg,
          .drag_area_m2 = 0.0,
          .motor = ThrustCurve{{{0.0, thrust_n}, {burn_s, thrust_n}, {burn_s + 1e-9, 0.0}}, 1e-12}};
}

struct Flight {
  double apogee_m = 0.0;
  double max_speed_m_s = 0.0;
  AscentEvents events;
};

Flight fly(const AscentParameters& parameters) {
  Ascent ascent{parameters};
  Flight flight;
  for (int tick = -500; tick < 60000 && !ascent.events().apogee_s; ++tick) {
    ascent.advance_to(tick * 0.001);
    flight.apogee_m = std::max(flight.apogee_m, ascent.height_m());
    flight.max_speed_m_s = std::max(flight.max_speed_m_s, ascent.speed_m_s());
  }
  flight.events = ascent.events();
  return flight;
}

TEST(Ascent, Launch1ReachesItsHeightSpeedAndTime) {
  const Flight flight = fly(tasha(3.47));
  EXPECT_NEAR(flight.apogee_m, 515.3, 515.3 * 0.005);
  EXPECT_NEAR(flight.apogee_m, 522.0, 522.0 * 0.02);
  EXPECT_NEAR(flight.max_speed_m_s, 96.5, 96.5 * 0.005);
  EXPECT_NEAR(*flight.events.apogee_s - *flight.events.liftoff_s, 11.06, 0.1);
}

TEST(Ascent, Launch2ReachesItsHeightSpeedAndTime) {
  const Flight flight = fly(tasha(3.99));
  EXPECT_NEAR(flight.apogee_m, 421.5, 421.5 * 0.005);
  EXPECT_NEAR(flight.apogee_m, 422.0, 422.0 * 0.02);
  EXPECT_NEAR(flight.max_speed_m_s, 82.2, 82.2 * 0.005);
  EXPECT_NEAR(*flight.events.apogee_s - *flight.events.liftoff_s, 10.36, 0.1);
}

TEST(Ascent, LiftsOffWhenThrustExceedsTheWeightAlongTheGuide) {
  // The canonical curve rises at 3200 N/s; the mass lost by then is a thousandth of the weight.
  for (const double tilt_rad : {0.0, 15.0 * degree}) {
    AscentParameters parameters = tasha(3.47);
    parameters.guide_tilt_rad = tilt_rad;
    const double expected_s = 3.47 * gravity_m_s2 * std::cos(tilt_rad) / 3200.0;
    const AscentEvents events = fly(parameters).events;
    EXPECT_GE(*events.liftoff_s, expected_s - 1e-4);
    EXPECT_LE(*events.liftoff_s, expected_s + 1e-3);
    EXPECT_NEAR(*events.burnout_s, 3.2, 1e-3 + 1e-9);
  }
}

TEST(Ascent, DragHasTheFactorOfItsMachNumber) {
  AscentParameters parameters = tasha(3.47);
  parameters.drag_over_mach = {.mach = {0.1, 0.2, 0.3}, .factor = {1.5, 0.9, 1.1}};
  const auto factor = [](double mach) {
    return mach < 0.1 ? 1.5 : mach < 0.2 ? 1.5 - 6.0 * (mach - 0.1) : mach < 0.3 ? 0.9 + 2.0 * (mach - 0.2) : 1.1;
  };
  Ascent ascent{parameters};
  for (int tick = 0; !ascent.events().apogee_s; ++tick) {
    ascent.advance_to(tick * 0.001);
    if (ascent.events().burnout_s) {
      const double speed_m_s = ascent.speed_m_s();
      const double mach = speed_m_s / std::sqrt(1.4 * 287.05287 * (288.15 - 0.0065 * ascent.height_m()));
      const double drag_n =
          0.5 * 1.225 * std::exp(-ascent.height_m() / 8500.0) * 0.005 * factor(mach) * speed_m_s * std::abs(speed_m_s);
      ASSERT_NEAR(ascent.axial_specific_force_m_s2(), -drag_n / ascent.mass_kg(), 1e-5) << tick;
    }
  }
}

TEST(Ascent, AFactorOfTwoEverywhereIsTwiceTheDragArea) {
  AscentParameters doubled = tasha(3.99);
  doubled.drag_over_mach = {.mach = {0.5}, .factor = {2.0}};
  AscentParameters twice = tasha(3.99);
  twice.drag_area_m2 *= 2.0;
  EXPECT_EQ(fly(doubled).apogee_m, fly(twice).apogee_m);
}

TEST(Ascent, StaysOnThePadWhenTheMotorIsTooWeak) {
  Ascent ascent{vacuum(2.0, 15.0, 1.0)};
  for (int tick = -10; tick < 3000; ++tick) {
    ascent.advance_to(tick * 0.001);
    ASSERT_EQ(ascent.height_m(), 0.0);
    ASSERT_EQ(ascent.axial_specific_force_m_s2(), gravity_m_s2);
  }
  EXPECT_FALSE(ascent.events().liftoff_s);
  EXPECT_FALSE(ascent.events().apogee_s);
  EXPECT_TRUE(ascent.events().burnout_s);
}

TEST(Ascent, VacuumFlightIsThatOfTheSchoolBook) {
  const double mass_kg = 2.0;
  const double thrust_n = 60.0;
  const double acceleration = thrust_n / mass_kg - gravity_m_s2;
  const Flight flight = fly(vacuum(mass_kg, thrust_n, 2.0));
  EXPECT_EQ(*flight.events.liftoff_s, 0.0);
  const double burnout_speed = acceleration * 2.0;
  EXPECT_NEAR(flight.max_speed_m_s, burnout_speed, 1e-6);
  EXPECT_NEAR(flight.apogee_m, 0.5 * acceleration * 4.0 + 0.5 * burnout_speed * burnout_speed / gravity_m_s2, 1e-4);
  EXPECT_NEAR(*flight.events.apogee_s, 2.0 + burnout_speed / gravity_m_s2, 1e-3);
}

TEST(Ascent, MassFallsInProportionToImpulseAsInTsiolkovskysFormula) {
  // Without weight along the line (a guide that lies almost flat) the speed is that of the rocket equation.
  const AscentParameters parameters{.mass_kg = 3.0,
                                    .drag_area_m2 = 0.0,
                                    .guide_tilt_rad = 0.5 * std::numbers::pi - 1e-12,
                                    .motor = ThrustCurve{{{0.0, 100.0}, {1.0, 200.0}, {2.0, 0.0}}, 1.0}};
  Ascent ascent{parameters};
  for (int tick = 0; tick <= 2500; ++tick) {
    ascent.advance_to(tick * 0.001);
    if (tick == 1000) {
      EXPECT_DOUBLE_EQ(ascent.mass_kg(), 3.0 - 150.0 / 250.0);
    }
  }
  EXPECT_DOUBLE_EQ(ascent.mass_kg(), 2.0);
  EXPECT_NEAR(ascent.speed_m_s(), 250.0 * std::log(3.0 / 2.0), 1e-4);
}

TEST(Ascent, CoastWithoutAirKeepsItsEnergy) {
  Ascent ascent{vacuum(2.0, 80.0, 1.5)};
  double at_start = 0.0;
  for (int tick = 0; tick <= 9000; ++tick) {
    ascent.advance_to(tick * 0.001);
    const double energy = 0.5 * ascent.speed_m_s() * ascent.speed_m_s() + gravity_m_s2 * ascent.height_m();
    if (tick == 1510) {
      at_start = energy;
    } else if (tick > 1510) {
      ASSERT_NEAR(energy, at_start, 1e-10 * at_start) << tick;
      ASSERT_NEAR(ascent.axial_specific_force_m_s2(), 0.0, 1e-12);
    }
  }
  EXPECT_LT(ascent.speed_m_s(), 0.0);
}

TEST(Ascent, CoastInConstantAirIsTheClosedForm) {
  AscentParameters parameters = vacuum(2.0, 300.0, 0.5);
  parameters.drag_area_m2 = 0.02;
  parameters.atmosphere = {.model = DensityModel::constant, .constant_kg_m3 = 1.2};
  Ascent ascent{parameters};
  // dv/dt = -g - k v^2: v = vt tan(atan(v0/vt) - g t/vt), and v0^2 falls to zero over ln(1 + v0^2/vt^2) / (2k).
  const double k = 0.5 * 1.2 * 0.02 / 2.0;
  const double terminal = std::sqrt(gravity_m_s2 / k);
  double start_speed = 0.0;
  double start_height = 0.0;
  double highest = 0.0;
  for (int tick = 0; !ascent.events().apogee_s; ++tick) {
    ascent.advance_to(tick * 0.001);
    highest = std::max(highest, ascent.height_m());
    if (tick == 501) {
      start_speed = ascent.speed_m_s();
      start_height = ascent.height_m();
    } else if (tick == 1501) {
      EXPECT_NEAR(ascent.speed_m_s(), terminal * std::tan(std::atan(start_speed / terminal) - gravity_m_s2 / terminal),
                  1e-5);
    }
  }
  EXPECT_NEAR(highest - start_height, std::log1p(std::pow(start_speed / terminal, 2)) / (2.0 * k), 1e-4);
  EXPECT_NEAR(*ascent.events().apogee_s - 0.501, terminal / gravity_m_s2 * std::atan(start_speed / terminal), 1e-3);
}

TEST(Ascent, HalvingTheStepChangesNothingThatAnyoneCouldMeasure) {
  const auto height_after_8s = [](int ticks_per_s) {
    Ascent ascent{tasha(3.47)};
    for (int tick = 0; tick <= 8 * ticks_per_s; ++tick) {
      ascent.advance_to(static_cast<double>(tick) / ticks_per_s);
    }
    return ascent.height_m();
  };
  // Lift-off is seen up to a step late, at an acceleration of a few m/s2: that bounds the difference.
  EXPECT_NEAR(height_after_8s(1000), height_after_8s(16000), 0.02);
}

TEST(Ascent, TiltedGuideFliesAlongItsLine) {
  const double tilt_rad = 10.0 * degree;
  AscentParameters parameters = vacuum(2.0, 60.0, 2.0);
  parameters.guide_tilt_rad = tilt_rad;
  Ascent ascent{parameters};
  for (int tick = 0; tick <= 1000; ++tick) {
    ascent.advance_to(tick * 0.001);
    ASSERT_DOUBLE_EQ(ascent.height_m(), ascent.distance_m() * std::cos(tilt_rad));
  }
  EXPECT_NEAR(ascent.distance_m(), 0.5 * (30.0 - gravity_m_s2 * std::cos(tilt_rad)), 1e-9);
}

// What an inertial estimator does: turn specific force to the earth, take gravity off, integrate twice.
TEST(Ascent, SpecificForceAndGravityTogetherTellTheWayOfATiltedFlight) {
  const double tilt_rad = 12.0 * degree;
  AscentParameters parameters = tasha(3.99);
  parameters.guide_tilt_rad = tilt_rad;
  Ascent ascent{parameters};
  ascent.advance_to(-1.0);
  EXPECT_NEAR(std::hypot(ascent.axial_specific_force_m_s2(), ascent.lateral_specific_force_m_s2()), gravity_m_s2,
              1e-12);
  double up = 0.0, up_speed = 0.0, aside = 0.0, aside_speed = 0.0;
  double last_up = 0.0, last_aside = 0.0;
  for (int tick = 0; tick <= 6000; ++tick) {
    ascent.advance_to(tick * 0.001);
    const double axial = ascent.axial_specific_force_m_s2();
    const double lateral = ascent.lateral_specific_force_m_s2();  // away from the ground, so back over the pad
    const double a_up = axial * std::cos(tilt_rad) + lateral * std::sin(tilt_rad) - gravity_m_s2;
    const double a_aside = axial * std::sin(tilt_rad) - lateral * std::cos(tilt_rad);
    up += 0.001 * (up_speed + 0.00025 * (a_up + last_up));
    up_speed += 0.0005 * (a_up + last_up);
    aside += 0.001 * (aside_speed + 0.00025 * (a_aside + last_aside));
    aside_speed += 0.0005 * (a_aside + last_aside);
    last_up = a_up;
    last_aside = a_aside;
  }
  EXPECT_NEAR(up, ascent.height_m(), 0.02);
  EXPECT_NEAR(aside, ascent.distance_m() * std::sin(tilt_rad), 0.02);
}

TEST(Ascent, FallsBackAndStaysWhereItStarted) {
  Ascent ascent{tasha(3.99)};
  for (int tick = 0; tick < 60000; ++tick) {
    ascent.advance_to(tick * 0.001);
    ASSERT_GE(ascent.height_m(), 0.0);
  }
  ASSERT_TRUE(ascent.events().landing_s);
  EXPECT_GT(*ascent.events().landing_s, *ascent.events().apogee_s);
  EXPECT_EQ(ascent.height_m(), 0.0);
  EXPECT_EQ(ascent.speed_m_s(), 0.0);
  EXPECT_EQ(ascent.axial_specific_force_m_s2(), gravity_m_s2);
}

TEST(Ascent, AHopOfOneStepHasAnApogeeToo) {
  // Half a millisecond of a thrust just above the weight.
  Ascent ascent{vacuum(1.0, 10.0, 0.0005)};
  for (int tick = 0; tick < 100; ++tick) {
    ascent.advance_to(tick * 0.001);
  }
  EXPECT_TRUE(ascent.events().apogee_s);
  EXPECT_TRUE(ascent.events().landing_s);
}

TEST(Ascent, AMotorThatStuttersHopsAndFliesLater) {
  AscentParameters parameters = vacuum(1.0, 1.0, 1.0);
  parameters.motor =
      ThrustCurve{{{0.0, 0.0}, {0.01, 20.0}, {0.02, 0.0}, {1.0, 0.0}, {1.01, 40.0}, {2.0, 40.0}, {2.01, 0.0}}, 1e-9};
  Ascent ascent{parameters};
  for (int tick = 0; tick < 2500; ++tick) {
    ascent.advance_to(tick * 0.001);
  }
  EXPECT_LT(*ascent.events().liftoff_s, 0.01);
  EXPECT_FALSE(ascent.events().apogee_s);
  EXPECT_GT(ascent.height_m(), 10.0);
}

}  // namespace
}  // namespace fantail::sim
