// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "bench/axes.hpp"
#include "sim/units.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;

constexpr double whole_turn_rad = 2.0 * std::numbers::pi;
constexpr double roll_scale_tolerance = 0.03;  // of a whole turn: 11 degrees, more than a hand misses its mark by
constexpr double tilt_scale_tolerance = 0.05;  // an accelerometer's offset of 0.025 g is 1.6 % of a quarter turn
constexpr double force_tolerance = 0.1;        // of 1 g, as the self-test
constexpr double seen_share = 0.1;             // of a turn, about an axis across: 6 degrees askew
constexpr double swapped_share = 0.5;
constexpr double least_tilt_rad = std::numbers::pi / 4.0;
constexpr double least_sine_across = 0.7;  // of the angle between the two tilts

constexpr std::array<std::string_view, accelerometer_count> accelerometer_names{"accelerometer of the IMU",
                                                                                "second accelerometer"};
constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

std::array<double, 3> components(const sim::Vector3& v) { return {v.x, v.y, v.z}; }

std::size_t largest(const std::array<double, 3>& of) {
  const auto found = std::ranges::max_element(of, {}, [](double value) { return std::abs(value); });
  return static_cast<std::size_t>(found - of.begin());
}

// ---- one after the other: upright, rolled, tilted ----

/// Of an accelerometer whose rocket stands upright; empty: it reads 1 g along x.
std::string upright(std::string_view name, const sim::Vector3& force_m_s2) {
  const double g = sim::length(force_m_s2) / sim::gravity_m_s2;
  if (std::abs(g - 1.0) > force_tolerance) {
    return fmt::format("The {} reads {} g at rest: its scale or its offset is wrong.", name, fixed(g, 2));
  }
  const auto shares = components((1.0 / sim::length(force_m_s2)) * force_m_s2);
  const std::size_t axis = largest(shares);
  if (axis != 0) {
    return fmt::format("With the rocket upright, the {} reads gravity along {}: its axes are swapped.", name,
                       axis_names[axis]);
  }
  if (shares[0] < 0.0) {
    return fmt::format("The {} reads -1 g along x: x is reversed, or the rocket stood on its nose.", name);
  }
  // An angle from the vertical of 8 degrees: a rocket stands better than that on its fins.
  const double askew_rad = sim::angle_off(shares[0], std::hypot(shares[1], shares[2]));
  return askew_rad > 0.14 ? fmt::format("The {} is mounted {} degrees askew, or the rocket did not stand upright.",
                                        name, fixed(degrees(askew_rad), 0))
                          : "";
}

std::vector<std::string> rolled(const sim::Vector3& angle_rad) {
  const auto seen = components(angle_rad);
  const double share = seen[0] / whole_turn_rad;
  if (const std::size_t axis = largest(seen); axis != 0 && std::abs(seen[axis]) > swapped_share * whole_turn_rad) {
    return {fmt::format("The gyro measures the roll about {}: its axes are swapped.", axis_names[axis])};
  }
  if (std::abs(share) < seen_share) {
    return {fmt::format("The gyro did not measure the roll of 360 degrees (it read {} degrees).",
                        fixed(degrees(seen[0]), 1))};
  }
  if (share < 0.0) {
    return {
        fmt::format("The roll is reversed: 360 degrees clockwise were measured as {}.", fixed(degrees(seen[0]), 1))};
  }
  std::vector<std::string> wrong;
  if (std::abs(share - 1.0) > roll_scale_tolerance) {
    wrong.push_back(fmt::format("The gyro's scale about x is wrong: 360 degrees of roll were measured as {}.",
                                fixed(degrees(seen[0]), 1)));
  }
  const double across_rad = std::hypot(seen[1], seen[2]);
  if (across_rad > seen_share * whole_turn_rad) {
    wrong.push_back(
        fmt::format("The gyro is mounted about {} degrees askew: it measures part of the roll about y and z.",
                    fixed(degrees(std::atan2(across_rad, seen[0])), 0)));
  }
  return wrong;
}

/// The rotation vector of a quaternion whose twist about x has been taken off.
Tilt tilt_of(const sim::Quaternion& swing) {
  const double sine = std::hypot(swing.y, swing.z);
  const double angle_rad = 2.0 * std::atan2(sine, swing.w);
  return sine > 0.0 ? Tilt{angle_rad / sine * swing.y, angle_rad / sine * swing.z} : Tilt{};
}

TiltSeen tilted(const TurnSeen& turn) {
  const sim::Quaternion& q = turn.turned;
  const double norm = std::hypot(q.w, q.x);
  // Of half a turn and no twist, any twist will do.
  const sim::Quaternion twist = norm > 1e-6 ? sim::Quaternion{.w = q.w / norm, .x = q.x / norm} : sim::Quaternion{};
  sim::Quaternion swing = q * sim::Quaternion{.w = twist.w, .x = -twist.x};
  if (swing.w < 0.0) {
    swing = {.w = -swing.w, .x = -swing.x, .y = -swing.y, .z = -swing.z};
  }
  TiltSeen seen{.gyro = tilt_of(swing)};
  for (std::size_t i = 0; i < accelerometer_count; ++i) {
    if (turn.before_m_s2[i] && turn.after_m_s2[i]) {
      const sim::Vector3 after = sim::rotated(twist, *turn.after_m_s2[i]);
      const sim::Vector3 axis = sim::cross(after, *turn.before_m_s2[i]);
      const double sine = sim::length(axis);
      const double angle_rad = sim::angle_off(sim::dot(after, *turn.before_m_s2[i]), sine);
      seen.accelerometer[i] = sine > 0.0 ? Tilt{angle_rad / sine * axis.y, angle_rad / sine * axis.z} : Tilt{};
    }
  }
  return seen;
}

double size_rad(const Tilt& tilt) { return std::hypot(tilt.y_rad, tilt.z_rad); }
double product(const Tilt& a, const Tilt& b) { return a.y_rad * b.z_rad - a.z_rad * b.y_rad; }

/// What the gyro makes of a tilt of one about each axis, if the accelerometer is right; empty: all is right.
std::vector<std::string> compared(std::string_view name, const std::array<TiltSeen, 2>& tilts, const Tilt& first,
                                  const Tilt& second) {
  const double area = product(first, second);
  if (std::min(size_rad(first), size_rad(second)) < least_tilt_rad) {
    return {fmt::format("According to the {}, the rocket was tilted by {} and {} degrees: too little to judge y and z.",
                        name, fixed(degrees(size_rad(first)), 0), fixed(degrees(size_rad(second)), 0))};
  }
  if (std::abs(area) < least_sine_across * size_rad(first) * size_rad(second)) {
    return {fmt::format(
        "According to the {}, the rocket was tilted twice to nearly the same side: y and z cannot be judged.", name)};
  }
  const Tilt& g = tilts[0].gyro;
  const Tilt& h = tilts[1].gyro;
  // The matrix that makes the gyro's tilts of the accelerometer's, row by row.
  const double yy = (g.y_rad * second.z_rad - h.y_rad * first.z_rad) / area;
  const double yz = (h.y_rad * first.y_rad - g.y_rad * second.y_rad) / area;
  const double zy = (g.z_rad * second.z_rad - h.z_rad * first.z_rad) / area;
  const double zz = (h.z_rad * first.y_rad - g.z_rad * second.y_rad) / area;
  if (std::max(std::abs(yz), std::abs(zy)) > swapped_share) {
    return {fmt::format("Gyro and {} disagree about which axis is y and which is z, or about their directions.", name)};
  }
  std::vector<std::string> wrong;
  const auto judge = [&](std::string_view axis, double along, double across) {
    if (along < seen_share) {
      wrong.push_back(
          along < -swapped_share
              ? fmt::format("Gyro and {} measure opposite turns about {}: one of them is reversed.", name, axis)
              : fmt::format("The gyro does not measure the turn about {} that the {} measures.", axis, name));
      return;
    }
    if (std::abs(along - 1.0) > tilt_scale_tolerance) {
      wrong.push_back(fmt::format("In a turn about {}, the gyro measures {} % of the angle that the {} measures.", axis,
                                  fixed(100.0 * along, 0), name));
    }
    if (std::abs(across) > seen_share) {
      wrong.push_back(fmt::format("Gyro and {} are rotated against each other about x, by about {} degrees.", name,
                                  fixed(degrees(std::atan2(std::abs(across), along)), 0)));
    }
  };
  judge("y", yy, yz);
  judge("z", zz, zy);
  return wrong;
}

}  // namespace

AxesResult judge_axes(const TurnsSeen& seen) {
  AxesResult result{
      .upright_m_s2 = seen[0].before_m_s2, .roll_rad = seen[0].angle_rad, .tilts = {tilted(seen[1]), tilted(seen[3])}};
  const auto add = [&result](std::string sentence) {
    if (!sentence.empty()) {
      result.sentences.push_back(std::move(sentence));
    }
  };
  std::ranges::for_each(rolled(result.roll_rad), add);
  std::size_t judged = 0;
  for (std::size_t i = 0; i < accelerometer_count; ++i) {
    const std::string_view name = accelerometer_names[i];
    const auto& first = result.tilts[0].accelerometer[i];
    const auto& second = result.tilts[1].accelerometer[i];
    if (!result.upright_m_s2[i] || !first || !second) {
      add(fmt::format("The {} gave no valid report.", name));
      continue;
    }
    judged += 1;
    const std::size_t before = result.sentences.size();
    add(upright(name, *result.upright_m_s2[i]));
    // Axes that lie wrong along the rocket make nonsense of what is seen across it.
    if (result.sentences.size() == before && std::abs(result.roll_rad.x) > swapped_share * whole_turn_rad) {
      std::ranges::for_each(compared(name, result.tilts, *first, *second), add);
    }
  }
  result.right = result.sentences.empty() && judged == accelerometer_count;
  if (result.right) {
    result.sentences.emplace_back(
        "Correct: axes, directions and scales of the gyro, and axes and directions of both accelerometers.");
  }
  return result;
}

std::string_view unchecked_of_axes() {
  return "Not checked: where y and z point on the rocket, which roll control does not need. Also not checked: whether "
         "the roll was clockwise, and a second IMU, which the bus does not report.";
}

}  // namespace fantail::bench
