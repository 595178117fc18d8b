// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "telemetry/changes.hpp"

namespace fantail::telemetry {

using Limits = Each<std::optional<double>>;
/// What a plan allows each canard, in radians.
[[nodiscard]] Limits limits_of(const core::FlightPlan& plan);

/// What only the program around the avionics knows.
struct Surroundings {
  Limits limits_rad{};                       ///< of the plan in force
  std::optional<double> tick_s{};            ///< how long this tick took
  std::optional<std::int64_t> late_ticks{};  ///< since the start
  std::optional<Health::Bus> bus{};
};

[[nodiscard]] State state_of(const core::TickRecord& record);
[[nodiscard]] Canards canards_of(const core::TickRecord& record, const Limits& limits_rad);

/// Turns ticks into messages: events at once, state and canards every tenth tick, health every hundredth.
class TickReporter {
 public:
  static constexpr std::int64_t state_period = 10;    ///< ticks, 100 Hz
  static constexpr std::int64_t health_period = 100;  ///< 10 Hz

  explicit TickReporter(Sink& sink) : sender_{sink} {}

  /// Once a tick, in order.
  void report(const core::TickRecord& record, const Surroundings& surroundings = {});

 private:
  Sender sender_;
  Changes changes_;
  std::int64_t ticks_ = 0;
  std::optional<double> longest_tick_s_;
};

}  // namespace fantail::telemetry
