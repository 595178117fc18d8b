// SPDX-License-Identifier: MIT
// What a camera sees of the roll, and the integral of the roll rate: a closed form, and the same by rotation matrices.
#include "sim/twist.hpp"

#include "degree.hpp"
#include "flown_world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr Quaternion upright{.w = 0.5, .x = 0.5, .y = -0.5, .z = 0.5};  // x up

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
  }
  return c;
}

/// Rodrigues.
Matrix turned(const Vector3& angle) {
  const double size = std::sqrt(dot(angle, angle));
  const double sine = size > 0.0 ? std::sin(size) / size : 1.0;
  const double versine = size > 0.0 ? (1.0 - std::cos(size)) / (size * size) : 0.5;
  const std::array<double, 3> v{angle.x, angle.y, angle.z};
  const Matrix across{{{0.0, -v[2], v[1]}, {v[2], 0.0, -v[0]}, {-v[1], v[0], 0.0}}};
  const Matrix twice = product(across, across);
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      m[i][j] = (i == j ? 1.0 : 0.0) + sine * across[i][j] + versine * twice[i][j];
    }
  }
  return m;
}

/// Of a matrix from the body into a frame with x up: the twist about x, by the formula for rotation matrices.
double twist_of(const Matrix& m) { return std::atan2(m[2][1] - m[1][2], m[1][1] + m[2][2]); }

/// A body on a cone of half-angle `cone_rad` about an axis that leans by `lean_rad`, `hz` times a second, whose roll
/// rate about its own axis is zero throughout: in each step the axis goes to its next place the shortest way.
double twist_on_cone(double cone_rad, double hz, double lean_rad, double for_s) {
  const auto axis = [&](double time_s) {
    const double phase = 2.0 * std::numbers::pi * hz * time_s;
    const Vector3 a{std::sin(cone_rad) * std::cos(phase), std::sin(cone_rad) * std::sin(phase), std::cos(cone_rad)};
    return Vector3{std::cos(lean_rad) * a.x + std::sin(lean_rad) * a.z, a.y,
                   std::cos(lean_rad) * a.z - std::sin(lean_rad) * a.x};
  };
  const auto shortest = [](const Vector3& from, const Vector3& to) {
    const Vector3 c = cross(from, to);
    const double w = 1.0 + dot(from, to);
    const double size = std::sqrt(w * w + dot(c, c));
    return Quaternion{.w = w / size, .x = c.x / size, .y = c.y / size, .z = c.z / size};
  };
  Quaternion attitude = shortest({.z = 1.0}, axis(0.0)) * upright;
  Twist twist{upright, attitude};
  constexpr double step_s = 1e-4;
  for (long i = 1; i <= std::lround(for_s / step_s); ++i) {
    attitude = shortest(rotated(attitude, {.x = 1.0}), axis(step_s * static_cast<double>(i))) * attitude;
    twist.follow(attitude);
  }
  return twist.rad();
}

// 5 deg at 2 Hz: 2.74 deg/s, while the integral of the roll rate is zero.
TEST(Twist, OnAConeIsTheAreaThatTheAxisGoesAround) {
  EXPECT_NEAR(720.0 * (1.0 - std::cos(5.0 * degree)), 2.74, 0.005);
  for (const double lean_deg : {0.0, 20.0, 80.0}) {
    for (const double cone_deg : {1.0, 5.0, 15.0}) {
      const double turned_rad = twist_on_cone(cone_deg * degree, 2.0, lean_deg * degree, 10.0);
      const double closed_form_rad = 20.0 * 2.0 * std::numbers::pi * (1.0 - std::cos(cone_deg * degree));
      EXPECT_NEAR(turned_rad, closed_form_rad, 1e-4 * closed_form_rad) << lean_deg << ' ' << cone_deg;
      EXPECT_NEAR(twist_on_cone(cone_deg * degree, -2.0, lean_deg * degree, 10.0), -turned_rad, 1e-9);
    }
  }
}

TEST(Twist, OfASwingInOnePlaneIsNone) {
  Twist twist{upright, upright};
  for (int i = 0; i <= 1000; ++i) {
    twist.follow(upright * small_rotation({.y = 0.1 * std::sin(0.05 * i), .z = 0.03 * std::sin(0.05 * i)}));
    ASSERT_NEAR(twist.rad(), 0.0, 1e-12);
  }
}

TEST(Twist, OfARollIsTheRollAndIsNotWrapped) {
  Twist twist{upright, upright};
  Quaternion attitude = upright;
  for (int i = 0; i < 1000; ++i) {
    attitude = renormalized(attitude * small_rotation({.x = -0.03}));
    twist.follow(attitude);
  }
  EXPECT_NEAR(twist.rad(), -30.0, 1e-9);
}

// The body rates of a flight in turbulent wind, integrated here by rotation matrices: the rocket cones by some degrees.
TEST(Twist, OfAFlightIsThatOfTheAttitudeIntegratedFromItsBodyRates) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Scenario s = scenario("tasha3_launch2", {"flight.motion=six_dof", "wind.speed_m_s=6", "wind.turbulence=0.3",
                                             "wind.from_deg=70", "launch_guide.tip_off_deg_s=20"});
    s.seed = seed;
    World world{s};
    Matrix attitude = turned({});
    double last_rad = 0.0;
    double seen_rad = 0.0;
    Vector3 before{};
    double furthest_rad = 0.0;
    while (!world.over() && !world.events().apogee) {
      (void)world.tick();
      const Vector3 rate = world.motion().rate_rad_s;
      attitude = product(attitude, turned(0.5e-3 * (before + rate)));
      before = rate;
      const double twist_rad = twist_of(attitude);
      seen_rad += std::remainder(twist_rad - last_rad, 2.0 * std::numbers::pi);
      last_rad = twist_rad;
      const Truth truth = world.truth();
      ASSERT_NEAR(truth.geometric_roll_rad.value(), seen_rad, 0.05 * degree) << seed;
      furthest_rad = std::max(furthest_rad, std::abs(seen_rad - truth.roll_angle_rad));
      world.advance();
    }
    EXPECT_GT(furthest_rad, 0.2 * degree) << seed << ": nothing to compare";
  }
}

TEST(Twist, IsKnownInSixDegreesOfFreedomOnly) {
  EXPECT_FALSE(World{scenario("tasha3_launch2")}.truth().geometric_roll_rad);
  EXPECT_FALSE(World{scenario("tunnel_steps")}.truth().geometric_roll_rad);
  EXPECT_TRUE(World{scenario("tasha3_launch2", {"flight.motion=six_dof"})}.truth().geometric_roll_rad);
}

}  // namespace
}  // namespace fantail::sim
