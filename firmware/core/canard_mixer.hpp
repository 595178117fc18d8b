// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"

namespace fantail::core {

/// The command to one servo. Not driven: its output stays off, because the canard's angle is not known yet.
struct CanardCommand {
  Angle angle;            ///< of the shaft, positive as the encoder counts
  float pulse_us = 0.0F;  ///< of the servo at `angle`; 0 while it is not driven
  bool driven = false;    ///< false: no pulses, and `angle` is no request
  bool limited = false;   ///< clamped, or held back by the first-motion rate
};

/// By index 0 to 3, as canards 1 to 4 are everywhere.
using CanardCommands = std::array<CanardCommand, canard_count>;

/// One roll command -> four canard commands; four encoders -> one canard angle. The only way to a servo: in flight, in
/// the self-test and on the bench.
///
/// shaft angle = direction * roll command + trim, clamped once more to the plan limit, the hard limit and the canard's
/// own mechanical stop, whichever is smallest. After power-up each canard first moves at a limited rate from where its
/// encoder says it is; a canard whose encoder stays silent for half a second is driven without that courtesy.
class CanardMixer {
 public:
  /// Copies what it needs. `plan_limit` is controller.canard_limit of the same plan, which has passed validate().
  CanardMixer(const CanardsPlan& plan, Angle plan_limit);

  /// `requested` shaft angles replace the mixed ones (self-test, bench). A request that is not finite means trim. All
  /// of `commands` is written, in its place: a copy in every tick would cost as much as one canard.
  void mix(Microseconds time, Angle roll_command, const std::optional<std::array<Angle, canard_count>>& requested,
           const EncoderAngles& encoders, CanardCommands& commands);

  /// Mean of direction * (encoder - trim) over the encoders that can be read (Eq 33); empty when none can.
  [[nodiscard]] std::optional<Angle> canard_angle(const EncoderAngles& encoders) const;

  /// What this canard adds to the roll: direction * (encoder - trim). Empty when the encoder cannot be read, or shows
  /// an angle beyond the mechanical stop, where no shaft can stand.
  [[nodiscard]] std::optional<Angle> contribution(std::size_t canard, const std::optional<Angle>& encoder) const;

  /// Limit, sense, trim and pulse of this canard are still those of the plan that this was made of.
  [[nodiscard]] bool moves_as_planned(std::size_t canard, const CanardsPlan& plan, Angle plan_limit) const;

  /// Largest shaft angle that can ever be commanded to this canard.
  [[nodiscard]] Angle limit(std::size_t canard) const { return canards_[canard].limit; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(canards_, power_up_, last_time_);
  }

 private:
  struct Canard {
    float sense;  ///< -1 for a reversed one
    Angle trim;
    Angle limit;
    Angle stop;
    float pulse_centre_us;
    float pulse_per_radian_us;
    std::optional<Angle> position;  ///< in the first motion
    bool first_motion_done;

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(position, first_motion_done);
    }
  };

  static Canard made_of(const CanardPlan& plan, Angle plan_limit);
  void drive(Microseconds time, Microseconds elapsed, Canard& canard, Angle wanted, const std::optional<Angle>& encoder,
             CanardCommand& command) const;
  void start_from_encoder(Microseconds time, Canard& canard, const std::optional<Angle>& encoder, Angle target) const;
  [[nodiscard]] Angle approach(Microseconds elapsed, Canard& canard, Angle target) const;

  float first_motion_rate_rad_s_;
  std::array<Canard, canard_count> canards_;
  std::optional<Microseconds> power_up_;
  Microseconds last_time_{};
};

}  // namespace fantail::core
