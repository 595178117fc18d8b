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

// A person turns the rocket as told. The roll is held against the turn that was asked for, the two tilts against
// gravity: a gyro and an accelerometer that see the same tilt otherwise have an axis, a sense or a scale that is wrong.

inline constexpr std::size_t accelerometer_count = 2;  ///< of the IMU, and the second one

struct AskedTurn {
  std::string_view name;  ///< "roll"
  std::string_view instruction;
};

/// Roll once around; lay down; stand up again; lay down across.
inline constexpr std::size_t turn_count = 4;
[[nodiscard]] const std::array<AskedTurn, turn_count>& asked_turns();

/// Means over a second in which the rocket lay still; empty: of that sensor came no valid report.
using ForcesAtRest = std::array<std::optional<sim::Vector3>, accelerometer_count>;

struct TurnSeen {
  ForcesAtRest before_m_s2{};
  ForcesAtRest after_m_s2{};
  sim::Vector3 angle_rad{};  ///< integral of the rates, less what the gyro read at rest
  sim::Quaternion turned{};  ///< by the same rates: from the body after the turn to the body before it
};
using TurnsSeen = std::array<TurnSeen, turn_count>;

/// Nobody turned the rocket for a minute, or it did not come to rest again, or its rates were not all heard. what()
/// says it.
class NotTurned : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each turn lasts from rest to rest, as the avionics reports it. `tell` is given each of the turns as it is due.
/// Throws NotTurned, link::LinkError when the avionics falls silent.
[[nodiscard]] TurnsSeen watch_turns(link::Place& place, link::AvionicsLink& link,
                                    const std::function<void(const AskedTurn&)>& tell);

/// A tilt about the axes y and z of the body, without what the rocket rolled beside it.
struct Tilt {
  double y_rad;
  double z_rad;
};

/// One tilt as the gyro and as each accelerometer sees it; empty: it gave nothing valid.
struct TiltSeen {
  Tilt gyro{};
  std::array<std::optional<Tilt>, accelerometer_count> accelerometer{};
};

struct AxesResult {
  ForcesAtRest upright_m_s2{};
  sim::Vector3 roll_rad{};  ///< about the three axes of the gyro, while the rocket was rolled once around
  std::array<TiltSeen, 2> tilts{};
  bool right = false;
  std::vector<std::string> sentences{};  ///< what is wrong; or that all is right
  std::string plan_lines{};  ///< with these in the plan the same turns would be right; empty: nothing is known to help
};
[[nodiscard]] AxesResult judge_axes(const TurnsSeen& seen);

[[nodiscard]] std::string axes_text(const AxesResult& result);
[[nodiscard]] std::string axes_json(const AxesResult& result, const result::Made& made = {});

/// What stays unchecked, a sentence.
[[nodiscard]] std::string_view unchecked_of_axes();

/// How the sensors would have to stand in the plan for these turns to be right: of all ways in which they can be
/// soldered in, the one next to `believed`, the plan with which the turns were seen, under which judge_axes() finds
/// nothing wrong. Empty: none, because gyro and accelerometer of one package do not agree, or a scale is wrong.
[[nodiscard]] std::optional<core::SensorsPlan> mounting_of(const TurnsSeen& seen, const core::SensorsPlan& believed);

/// What differs from `believed`, as lines of a plan; empty when nothing does.
[[nodiscard]] std::string mounting_lines(const core::SensorsPlan& found, const core::SensorsPlan& believed);

}  // namespace fantail::bench
