// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include <fmt/format.h>

#include "bench/axes.hpp"
#include "core/flight_plan_table.hpp"
#include "sim/sensor_mounting.hpp"

namespace fantail::bench {
namespace {

using core::SensorMounting;

/// The same arrow of the sensor, in the rocket's axes of another plan.
class Remounting {
 public:
  Remounting(const SensorMounting& believed, const SensorMounting& tried)
      : believed_{sim::axes_seen(believed)}, tried_{sim::axes_seen(tried)} {}

  [[nodiscard]] sim::Vector3 of(const sim::Vector3& seen) const {
    const std::array<double, 3> rocket{seen.x, seen.y, seen.z};
    std::array<double, 3> sensor{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < 3; ++i) {
        sensor[i] += believed_[axis][i] * rocket[axis];
      }
    }
    const auto along = [&](std::size_t axis) {
      const auto& e = tried_[axis];
      return e[0] * sensor[0] + e[1] * sensor[1] + e[2] * sensor[2];
    };
    return {along(0), along(1), along(2)};
  }

 private:
  sim::AxesSeen believed_;
  sim::AxesSeen tried_;
};

TurnsSeen remounted(TurnsSeen seen, const core::SensorsPlan& believed, const core::SensorsPlan& tried) {
  const Remounting imu{believed.imu, tried.imu};
  const std::array<Remounting, accelerometer_count> forces{imu, {believed.accelerometer, tried.accelerometer}};
  for (TurnSeen& turn : seen) {
    for (std::size_t i = 0; i < accelerometer_count; ++i) {
      for (auto* force_m_s2 : {&turn.before_m_s2[i], &turn.after_m_s2[i]}) {
        if (*force_m_s2) {
          *force_m_s2 = forces[i].of(**force_m_s2);
        }
      }
    }
    turn.angle_rad = imu.of(turn.angle_rad);
    const sim::Vector3 axis = imu.of({turn.turned.x, turn.turned.y, turn.turned.z});
    turn.turned = {.w = turn.turned.w, .x = axis.x, .y = axis.y, .z = axis.z};
  }
  return seen;
}

/// Every way to solder a sensor in, the believed one first, then those that leave one of its two lines as it is.
std::vector<SensorMounting> ways(const SensorMounting& believed) {
  std::array<std::vector<SensorMounting>, 3> by_changes;
  for (std::uint8_t x = 0; x < 6; ++x) {
    for (std::uint8_t y = 0; y < 6; ++y) {
      const SensorMounting way{static_cast<core::SensorAxis>(x), static_cast<core::SensorAxis>(y)};
      if (sim::is_rotation(way)) {
        by_changes[(way.to_nose != believed.to_nose ? 1U : 0U) + (way.along_y != believed.along_y ? 1U : 0U)].push_back(
            way);
      }
    }
  }
  std::vector<SensorMounting> all;
  for (const auto& some : by_changes) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::string lines_of(std::string_view sensor, const SensorMounting& found, const SensorMounting& believed) {
  const auto line = [&](std::string_view key, core::SensorAxis axis, core::SensorAxis before) {
    return axis == before ? std::string{}
                          : fmt::format("{}_{} = \"{}\"\n", sensor, key,
                                        core::plan_table::sensor_axis_names[static_cast<std::size_t>(axis)]);
  };
  return line("to_nose", found.to_nose, believed.to_nose) + line("along_y", found.along_y, believed.along_y);
}

}  // namespace

std::optional<core::SensorsPlan> mounting_of(const TurnsSeen& seen, const core::SensorsPlan& believed) {
  for (const SensorMounting& imu : ways(believed.imu)) {
    for (const SensorMounting& accelerometer : ways(believed.accelerometer)) {
      core::SensorsPlan tried = believed;
      tried.imu = imu;
      tried.accelerometer = accelerometer;
      if (judge_axes(remounted(seen, believed, tried)).right) {
        return tried;
      }
    }
  }
  return std::nullopt;
}

std::string mounting_lines(const core::SensorsPlan& found, const core::SensorsPlan& believed) {
  const std::string lines =
      lines_of("imu", found.imu, believed.imu) + lines_of("accelerometer", found.accelerometer, believed.accelerometer);
  return lines.empty() ? "" : "[sensors]\n" + lines;
}

}  // namespace fantail::bench
