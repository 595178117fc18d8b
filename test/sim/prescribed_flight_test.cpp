// SPDX-License-Identifier: MIT
#include "sim/prescribed_flight.hpp"

#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double degree_rad = 3.14159265358979323846 / 180.0;

/// Two seconds at rest, then 50 m/s2 along an axis that leans.
PrescribedPath leaning(double tilt_rad) {
  PrescribedPath path{.liftoff_s = 0.0, .burnout_s = 1.0, .apogee_s = 1.5};
  for (int i = -200; i <= 200; ++i) {
    const double time_s = 0.01 * i;
    const double speed_m_s = i > 0 ? 50.0 * time_s : 0.0;
    path.samples.push_back({.time_s = time_s,
                            .height_m = 0.5 * speed_m_s * time_s * std::cos(tilt_rad),
                            .up_m_s = speed_m_s * std::cos(tilt_rad),
                            .across_m_s = speed_m_s * std::sin(tilt_rad),
                            .along_axis_m_s = speed_m_s,
                            .density_kg_m3 = 1.2,
                            .tilt_rad = tilt_rad});
  }
  return path;
}

TEST(PrescribedFlight, OnThePadFeelsGravityOnly) {
  PrescribedFlight flight{leaning(30.0 * degree_rad)};
  flight.advance_to(-1.0);
  EXPECT_NEAR(flight.specific_force_m_s2().x, 9.80665 * std::cos(30.0 * degree_rad), 1e-12);
  EXPECT_NEAR(flight.specific_force_m_s2().y, 9.80665 * std::sin(30.0 * degree_rad), 1e-12);
  EXPECT_TRUE(flight.is_on_ground());
  EXPECT_FALSE(flight.events().liftoff_s);
}

// The example of the header: 50 + 9.81 cos(30 deg).
TEST(PrescribedFlight, FeelsTheChangeOfItsSpeedAndGravityAlongItsAxis) {
  PrescribedFlight flight{leaning(30.0 * degree_rad)};
  flight.advance_to(0.5);
  EXPECT_NEAR(flight.specific_force_m_s2().x, 50.0 + 9.80665 * std::cos(30.0 * degree_rad), 1e-6);
  EXPECT_NEAR(flight.specific_force_m_s2().y, 9.80665 * std::sin(30.0 * degree_rad), 1e-6);
  EXPECT_NEAR(flight.speed_m_s(), 25.0, 1e-9);
  EXPECT_NEAR(flight.across_m(), 0.5 * 25.0 * 0.5 * std::sin(30.0 * degree_rad), 1e-6);
  EXPECT_FALSE(flight.is_on_ground());
}

TEST(PrescribedFlight, SeesEachEventAtTheFirstInstantAtWhichItHasHappened) {
  PrescribedFlight flight{leaning(0.0)};
  for (int i = -1; i <= 2000; ++i) {
    flight.advance_to(1e-3 * i);
  }
  EXPECT_NEAR(flight.events().liftoff_s.value(), 0.0, 1e-9);
  EXPECT_NEAR(flight.events().burnout_s.value(), 1.0, 1e-9);
  EXPECT_NEAR(flight.events().apogee_s.value(), 1.5, 1e-9);
  EXPECT_FALSE(flight.events().landing_s);
  EXPECT_TRUE(flight.is_over());
}

// A rocket that goes round at constant speed feels speed times turning rate across its axis, and no force along it but
// gravity's part: what a gyro and an accelerometer would tell of that turn fits together.
TEST(PrescribedFlight, ATurnIsFeltByGyroAndAccelerometerAlike) {
  constexpr double speed_m_s = 100.0;
  constexpr double rate_rad_s = 0.2;
  PrescribedPath path;
  for (int i = 0; i <= 300; ++i) {
    const double time_s = 0.01 * i;
    const double tilt_rad = rate_rad_s * time_s;
    path.samples.push_back({.time_s = time_s,
                            .height_m = 100.0,
                            .up_m_s = speed_m_s * std::cos(tilt_rad),
                            .across_m_s = speed_m_s * std::sin(tilt_rad),
                            .along_axis_m_s = speed_m_s,
                            .density_kg_m3 = 1.2,
                            .tilt_rad = tilt_rad});
  }
  PrescribedFlight flight{path};
  flight.advance_to(2.0);
  const double tilt_rad = 0.4;
  EXPECT_NEAR(flight.specific_force_m_s2().x, 9.80665 * std::cos(tilt_rad), 0.01);
  // It bends towards the side that it leans to, which is -y.
  EXPECT_NEAR(flight.specific_force_m_s2().y, 9.80665 * std::sin(tilt_rad) - speed_m_s * rate_rad_s, 0.01);
  EXPECT_NEAR(flight.rate_rad_s().z, -rate_rad_s, 1e-9);
}

TEST(PrescribedFlight, AnAccelerationOfTheFileIsWhatIsFelt) {
  PrescribedPath path = leaning(0.0);
  for (PathSample& sample : path.samples) {
    sample.axial_specific_force_m_s2 = 33.0;
  }
  PrescribedFlight flight{path};
  flight.advance_to(0.5);
  EXPECT_NEAR(flight.specific_force_m_s2().x, 33.0, 1e-12);
}

}  // namespace
}  // namespace fantail::sim
