// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/flight_plan.hpp"
#include "hal/can_bus.hpp"
#include "telemetry/sender.hpp"

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

/// Turns ticks into messages: events at once, state and canards every tenth tick or as often as asked, health every
/// hundredth.
class TickReporter {
 public:
  static constexpr std::int64_t state_period = 10;    ///< ticks, 100 Hz
  static constexpr std::int64_t health_period = 100;  ///< 10 Hz

  explicit TickReporter(Sink& sink, std::int64_t ticks_between_states = state_period)
      : sender_{sink}, ticks_between_states_{ticks_between_states} {}

  /// Once a tick, in order.
  void report(const core::TickRecord& record, const Surroundings& surroundings = {});

 private:
  Sender sender_;
  Changes changes_;
  std::int64_t ticks_between_states_;
  std::int64_t ticks_ = 0;
  std::optional<double> longest_tick_s_;
};

/// Stands between the avionics and its bus and reads the reported canard limits, because only the avionics knows which
/// plan is in force, the built-in one or one from the flash.
class LimitTap final : public hal::CanBus {
 public:
  explicit LimitTap(hal::CanBus& bus) : bus_{bus} {}
  bool send(const hal::CanFrame& frame) override;
  std::optional<hal::CanFrame> receive() override { return bus_.receive(); }
  [[nodiscard]] hal::CanState state() const override { return bus_.state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return bus_.counters(); }

  /// Empty ones until the avionics has said it; it does so once a second.
  [[nodiscard]] const Limits& limits_rad() const { return limits_rad_; }

 private:
  hal::CanBus& bus_;
  Limits limits_rad_{};
};

}  // namespace fantail::telemetry
