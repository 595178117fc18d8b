// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>

#include "sim/units.hpp"
#include "trajectory/series.hpp"

namespace fantail::trajectory {
namespace {

using Values = std::vector<double>;

/// Where the axis is nearer to the horizon, its tangent says nothing of the horizontal speed; that hardly changes
/// there.
constexpr double steepest_rad = 60.0 * sim::radians_per_degree;
/// A slower rocket goes nowhere in particular.
constexpr double least_speed_m_s = 1.0;
/// Of the difference of two nearly equal speeds little but their rounding is left; over this time that averages out.
constexpr double smoothing_s = 0.1;

Values made(std::size_t count, const std::function<double(std::size_t)>& value) {
  Values values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = value(i);
  }
  return values;
}

/// The mean of all values within smoothing_s to both sides.
Values smoothed(const Values& times_s, const Values& values) {
  Values result(values.size());
  std::size_t begin = 0;
  std::size_t end = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (; end < values.size() && times_s[end] <= times_s[i] + smoothing_s; ++end) {
      sum += values[end];
    }
    for (; times_s[begin] < times_s[i] - smoothing_s; ++begin) {
      sum -= values[begin];
    }
    result[i] = sum / static_cast<double>(end - begin);
  }
  return result;
}

class Plane {
 public:
  Plane(const Series& series, double guide_tilt_rad)
      : series_{series}, count_{series.times_s.size()}, guide_tilt_rad_{guide_tilt_rad} {}

  Motion motion() {
    const Values* elevation_rad = take(Quantity::tilt);
    if (elevation_rad != nullptr) {
      motion_.tilt_rad = made(count_, [&](std::size_t i) { return 0.5 * std::numbers::pi - (*elevation_rad)[i]; });
    }
    find_speeds();
    rest();
    if (motion_.tilt_rad.empty()) {
      find_tilt();
    }
    find_air_speed();
    find_felt_force();
    return motion_;
  }

 private:
  const Values* take(Quantity quantity) {
    const Values* values = series_.find(quantity);
    if (values != nullptr) {
      motion_.read.push_back(quantity);
    }
    return values;
  }

  std::optional<Values> horizontal() {
    if (const Values* across = take(Quantity::horizontal_speed)) {
      // RASAero's has a sign.
      return made(count_, [&](std::size_t i) { return std::abs((*across)[i]); });
    }
    if (series_.find(Quantity::speed_to_the_east) == nullptr || series_.find(Quantity::speed_to_the_north) == nullptr) {
      return std::nullopt;
    }
    const Values& east = *take(Quantity::speed_to_the_east);
    const Values& north = *take(Quantity::speed_to_the_north);
    return made(count_, [&](std::size_t i) { return std::hypot(east[i], north[i]); });
  }

  void find_speeds() {
    const Values* up = take(Quantity::vertical_speed);
    const std::optional<Values> across = horizontal();
    if (up != nullptr) {
      motion_.up_m_s = *up;
      motion_.across_m_s = across ? *across : across_from(*up);
      return;
    }
    const Values& total = *take(Quantity::total_speed);
    if (!across) {
      along(total);
      return;
    }
    motion_.across_m_s = *across;
    motion_.up_m_s = made(count_, [&](std::size_t i) {
      return sense(i) * std::sqrt(std::max(total[i] * total[i] - (*across)[i] * (*across)[i], 0.0));
    });
    motion_.derived.emplace_back("the vertical speed follows from total and horizontal speed");
  }

  /// A rocket that goes where its axis points, as fast as the total speed says.
  void along(const Values& total) {
    if (motion_.tilt_rad.empty()) {
      keep_to_guide();
      const double cosine = std::cos(guide_tilt_rad_);
      const double sine = std::sin(guide_tilt_rad_);
      motion_.up_m_s = made(count_, [&](std::size_t i) { return sense(i) * total[i] * cosine; });
      motion_.across_m_s = made(count_, [&](std::size_t i) { return sense(i) * total[i] * sine; });
      return;
    }
    motion_.up_m_s = made(count_, [&](std::size_t i) { return total[i] * std::cos(motion_.tilt_rad[i]); });
    motion_.across_m_s = made(count_, [&](std::size_t i) { return total[i] * std::sin(motion_.tilt_rad[i]); });
    motion_.derived.emplace_back("vertical and horizontal speed follow from total speed and tilt");
  }

  void keep_to_guide() {
    motion_.tilt_rad.assign(count_, guide_tilt_rad_);
    motion_.derived.emplace_back("tilt and horizontal speed are those of a straight line along the scenario's guide");
  }

  Values across_from(const Values& up) {
    if (const Values* total = take(Quantity::total_speed)) {
      motion_.derived.emplace_back("the horizontal speed follows from total and vertical speed");
      return smoothed(series_.times_s, made(count_, [&](std::size_t i) {
                        return std::sqrt(std::max((*total)[i] * (*total)[i] - up[i] * up[i], 0.0));
                      }));
    }
    if (!motion_.tilt_rad.empty()) {
      motion_.derived.emplace_back("the horizontal speed follows from vertical speed and tilt");
      double held = 0.0;
      return made(count_, [&](std::size_t i) {
        held = std::abs(motion_.tilt_rad[i]) <= steepest_rad ? up[i] * std::tan(motion_.tilt_rad[i]) : held;
        return held;
      });
    }
    keep_to_guide();
    const double tangent = std::tan(guide_tilt_rad_);
    return made(count_, [&](std::size_t i) { return up[i] * tangent; });
  }

  [[nodiscard]] double sense(std::size_t i) const { return i <= series_.apogee ? 1.0 : -1.0; }

  void rest() {
    for (std::size_t i = 0; i <= series_.liftoff; ++i) {
      motion_.up_m_s[i] = 0.0;
      motion_.across_m_s[i] = 0.0;
    }
  }

  void find_tilt() {
    motion_.derived.emplace_back("the tilt is that of the path");
    std::optional<double> held;
    motion_.tilt_rad = made(count_, [&](std::size_t i) {
      const bool tells = std::hypot(motion_.up_m_s[i], motion_.across_m_s[i]) >= least_speed_m_s;
      if (tells && i <= series_.apogee) {
        held = std::atan2(motion_.across_m_s[i], motion_.up_m_s[i]);
      }
      return held.value_or(guide_tilt_rad_);
    });
    // What it leaves the pad with is what it stood with.
    const auto first = std::ranges::find_if(motion_.tilt_rad, [&](double tilt) { return tilt != guide_tilt_rad_; });
    if (first != motion_.tilt_rad.end()) {
      std::fill(motion_.tilt_rad.begin(), first, *first);
    }
  }

  void find_air_speed() {
    if (series_.find(Quantity::air_speed) != nullptr && series_.find(Quantity::angle_of_attack) != nullptr) {
      const Values& speed = *take(Quantity::air_speed);
      const Values& angle_rad = *take(Quantity::angle_of_attack);
      motion_.along_axis_m_s = made(count_, [&](std::size_t i) { return speed[i] * std::cos(angle_rad[i]); });
      return;
    }
    motion_.along_axis_m_s = made(count_, [&](std::size_t i) {
      return motion_.up_m_s[i] * std::cos(motion_.tilt_rad[i]) + motion_.across_m_s[i] * std::sin(motion_.tilt_rad[i]);
    });
    motion_.derived.emplace_back("the speed through the air is that over ground, along the axis");
  }

  void find_felt_force() {
    const Values* axial_m_s2 = take(Quantity::acceleration_along_the_axis);
    if (axial_m_s2 == nullptr) {
      motion_.derived.emplace_back("the accelerometer readings follow from the change of the speeds, less gravity");
      return;
    }
    motion_.felt_m_s2 = made(count_, [&](std::size_t i) {
      return (i <= series_.liftoff ? 0.0 : (*axial_m_s2)[i]) + sim::gravity_m_s2 * std::cos(motion_.tilt_rad[i]);
    });
    motion_.derived.emplace_back("the accelerometer readings are that acceleration less gravity");
  }

  const Series& series_;
  std::size_t count_;
  double guide_tilt_rad_;
  Motion motion_;
};

}  // namespace

Motion motion_of(const Series& series, double guide_tilt_rad) { return Plane{series, guide_tilt_rad}.motion(); }

}  // namespace fantail::trajectory
