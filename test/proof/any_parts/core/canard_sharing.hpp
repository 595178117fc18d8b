// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "core/canard_monitor.hpp"
#include "core/pd_controller.hpp"

namespace fantail::core {

using CanardContributions = std::array<std::optional<Angle>, canard_count>;

/// In the place of the sharing between canards: any command of the law, and anything asked of each canard, as long as
/// it is active; nothing while it is not.
class CanardSharing {
 public:
  explicit CanardSharing(Angle) {}
  void update(const CanardVerdicts&, const CanardContributions&) { active_ = nondet_bool(); }
  [[nodiscard]] bool is_active() const { return active_; }
  [[nodiscard]] AngleRange reach() const { return {proof::any_angle(), proof::any_angle()}; }
  void limit(RollCommand& roll) const {
    if (roll.finite) {
      roll.command = proof::any_angle();
      proof::assume(is_finite(roll.command.radians()));
      roll.saturated = nondet_bool();
    }
  }
  [[nodiscard]] Angle asked_of_each(Angle) const { return proof::any_angle(); }

  bool active_ = nondet_bool();
};

}  // namespace fantail::core
