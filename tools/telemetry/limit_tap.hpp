// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hal/can_bus.hpp"
#include "telemetry/tick_reporter.hpp"

namespace fantail::telemetry {

/// Stands between the avionics and its bus and reads what it says of its canards' limits: which plan is in force, its
/// own or one from the flash, only the avionics knows.
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
