// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/angle.hpp"
#include "core/canard_monitor.hpp"
#include "core/inputs.hpp"
#include "core/pd_controller.hpp"

namespace fantail::core {

/// What each canard adds to the roll: its angle from trim in the sense of positive roll; empty: unknown.
using CanardContributions = std::array<std::optional<Angle>, canard_count>;

/// Gives the work of canards that do not follow their commands to the others.
///
/// The roll moment goes with the sum of the four contributions. A canard that does not follow still makes its own, with
/// the angle a that its encoder shows. So that the sum is that of four canards at the roll command u, each is asked for
///
///   c = (4 u - sum of w a) / (4 - sum of w)
///
/// w is 1 for a canard that the monitor has judged and 0 for the others. It takes a tenth of a second from one to the
/// other, so that neither a verdict nor its end is a step, and one that comes and goes is only a ripple.
///
/// The judged one is asked for c, too. So it stands as far from its command in the end as without this class, and no
/// verdict is withdrawn because of what followed from it; and a canard that comes to life again, or was judged wrongly,
/// adds c in its turn, with which c = u solves the equation.
///
/// A silent encoder does not tell whether its canard follows: it is taken to go on as it did before. With more than two
/// canards judged the cause is a common one (supply, a servo model that is wrong), and nothing is shared.
class CanardSharing {
 public:
  /// `plan_limit` is controller.canard_limit: from its negative to itself goes reach() until something is shared.
  explicit CanardSharing(Angle plan_limit) : plan_limit_{plan_limit}, reach_{-plan_limit, plan_limit} {}

  /// Before the command of a tick under control, as long as a canard is judged or is_active(). A tick that came late
  /// counts as one.
  void update(const CanardVerdicts& verdicts, const CanardContributions& contributions);

  /// Something is shared; all four at once, as the word that they are.
  [[nodiscard]] bool is_active() const { return std::bit_cast<std::uint32_t>(shared_for_) != 0; }

  /// The roll commands that the canards can make together, each that follows within the plan limit. One that is stuck
  /// beyond that takes the others' reach with it: an end may lie beyond the plan limit, or on the other side of zero.
  [[nodiscard]] AngleRange reach() const { return reach_; }

  /// To what the canards can make: the law must know when it is at its limit, and not believe so before.
  void limit(RollCommand& roll) const {
    if (roll.finite) {
      roll.command = clamp(roll.unclamped, reach_);
      roll.saturated = roll.command != roll.unclamped;
    }
  }

  /// c of this roll command. The mixer clamps it.
  [[nodiscard]] Angle asked_of_each(Angle roll_command) const {
    return (static_cast<float>(canard_count) * roll_command - judged_) / following_;
  }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    for (std::uint8_t& ticks : shared_for_) {
      visit.below(handover_ticks + 1, ticks);
    }
    visit(angles_);
  }

 private:
  static constexpr std::uint8_t handover_ticks = 100;
  static constexpr std::size_t most_judged = 2;

  Angle plan_limit_;
  std::array<std::uint8_t, canard_count> shared_for_{};  ///< ticks of the hand-over: w = 1 when it is complete
  std::array<Angle, canard_count> angles_{};             ///< contribution of a canard that is shared

  // No state: made anew in every update().
  AngleRange reach_;
  Angle judged_;                                        ///< sum of w a
  float following_ = static_cast<float>(canard_count);  ///< 4 - sum of w
};

}  // namespace fantail::core
