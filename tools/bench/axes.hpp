// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/flight_plan.hpp"
#include "link/avionics_link.hpp"
#include "link/place.hpp"
#include "result/answer.hpp"
#include "sim/rotation.hpp"

namespace fantail::bench {

// A person turns the rocket as instructed. The roll is compared with the requested turn, the two tilts with gravity: if
// gyro and accelerometer measure a tilt differently, an axis, a direction or a scale is wrong.

inline constexpr std::size_t accelerometer_count = 2;  ///< of the IMU, and the second one

struct AskedTurn {
  std::string_view name;  ///< "roll"
  std::string_view instruction;
};

/// Roll once around; lay down; stand up again; lay down across.
inline constexpr std::size_t turn_count = 4;
[[nodiscard]] const std::array<AskedTurn, turn_count>& asked_turns();

/// Means over a second in which the rocket lay still; empty: that sensor sent no valid report.
using ForcesAtRest = std::array<std::optional<sim::Vector3>, accelerometer_count>;

struct TurnSeen {
  ForcesAtRest before_m_s2{};
  ForcesAtRest after_m_s2{};
  sim::Vector3 angle_rad{};  ///< integral of the rates, less what the gyro read at rest
  sim::Quaternion turned{};  ///< by the same rates: from the body after the turn to the body before it
};
using TurnsSeen = std::array<TurnSeen, turn_count>;

/// Nobody turned the rocket for a minute, or it did not come to rest again, or its rates had a gap. what() says
/// which.
class NotTurned : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each turn lasts from rest to rest, as the avionics reports it. `tell` is called with each turn when it is due.
/// Throws NotTurned, and link::LinkError when the avionics stops reporting.
[[nodiscard]] TurnsSeen watch_turns(link::Place& place, link::AvionicsLink& link,
                                    const std::function<void(const AskedTurn&)>& tell);

/// A tilt about the axes y and z of the body, without the roll during it.
struct Tilt {
  double y_rad;
  double z_rad;
};

/// One tilt as measured by the gyro and by each accelerometer; empty: it sent no valid report.
struct TiltSeen {
  Tilt gyro{};
  std::array<std::optional<Tilt>, accelerometer_count> accelerometer{};
};

struct AxesResult {
  ForcesAtRest upright_m_s2{};
  sim::Vector3 roll_rad{};  ///< about the three axes of the gyro, while the rocket was rolled once around
  std::array<TiltSeen, 2> tilts{};
  bool right = false;
  std::vector<std::string> sentences{};  ///< errors found, or that all is correct
  std::string plan_lines{};              ///< plan lines that would correct these turns; empty: none known
};
[[nodiscard]] AxesResult judge_axes(const TurnsSeen& seen);

[[nodiscard]] std::string axes_text(const AxesResult& result);
[[nodiscard]] std::string axes_json(const AxesResult& result, const result::Made& made = {});

/// The limits of the check, in a few sentences.
[[nodiscard]] std::string_view unchecked_of_axes();

/// The mounting in the plan with which these turns would be correct: of all ways in which the sensors can be soldered,
/// the one closest to `believed`, the plan during the turns, for which judge_axes() finds no error. Empty: none,
/// because gyro and accelerometer of one package do not agree, or a scale is wrong.
[[nodiscard]] std::optional<core::SensorsPlan> mounting_of(const TurnsSeen& seen, const core::SensorsPlan& believed);

/// What differs from `believed`, as lines of a plan; empty when nothing does.
[[nodiscard]] std::string mounting_lines(const core::SensorsPlan& found, const core::SensorsPlan& believed);

}  // namespace fantail::bench
