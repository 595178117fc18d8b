// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/flight_plan.hpp"
#include "listen/heard.hpp"

namespace fantail::listen {

struct Question {
  std::string plan_name{};
  core::FlightPlan plan{};
  std::optional<double> longest_bridge_s{};  ///< empty: as longest_bridge_s() says
  double pad_s = 0.0;  ///< the rocket stood for so long before the log, reading what it reads up to lift-off
};

/// How far the flight through the log is, in seconds of the log; called about every second of it.
using Watch = std::function<void(double done_s)>;

/// Flies a log through the flight law of the avionics (core::Autopilot), armed in its first tick, one step a
/// millisecond. Between two samples values run straight; across a longer gap the law receives only the old sample,
/// which goes stale. One that stands at the end of its range is given as saturated. Where the plan asks for two
/// accelerometers (gyros) and the log has one, its samples are given as both. The encoders report that every canard
/// stands where it was commanded to be.
///
/// Ends at the end of the log, or three seconds after the later of both apogees (the log's own, the law's). A law of
/// the plan that begins in the tunnel is refused: text::Error (bad_configuration).
[[nodiscard]] Heard fly_log(ImuLog log, const Question& question, const Watch& watch = {});

}  // namespace fantail::listen
