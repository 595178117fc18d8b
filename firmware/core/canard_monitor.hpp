// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/canard_mixer.hpp"
#include "core/flight_plan.hpp"
#include "core/inputs.hpp"

namespace fantail::core {

/// What the monitor says of one canard.
enum class CanardVerdict : std::uint8_t {
  healthy,      ///< nothing has lasted against it; also while it is not driven and its encoder can be read
  dead,         ///< its encoder has been silent for the plan's timeout
  stalled,      ///< far from where the command should have brought it, and not moving
  slipping,     ///< far from where the command should have brought it, though it moves
  disagreeing,  ///< near enough by itself, but off its command when the other canards are not
};
/// How many values CanardVerdict has: one that is read must be below.
inline constexpr std::size_t canard_verdicts = 5;

/// By index 0 to 3, as canards 1 to 4 are everywhere.
using CanardVerdicts = std::array<CanardVerdict, canard_count>;

/// At once, as the word that the four are: in a loop it would be six instructions a canard.
[[nodiscard]] constexpr bool all_healthy(const CanardVerdicts& verdicts) {
  static_assert(static_cast<std::uint8_t>(CanardVerdict::healthy) == 0);
  return std::bit_cast<std::uint32_t>(verdicts) == 0;
}

/// Compares each canard's command with its encoder. The command first passes a model of the servo (a first-order lag),
/// so that fast excitation is not mistaken for a fault. A difference must last for the plan's hold, and twice the time
/// it was gone in between counts against it: a canard stuck in the middle of an excitation is right twice a wave, and a
/// sound servo that is faster than its model is wrong twice a wave. A verdict stays until the difference has been gone
/// for half the hold.
class CanardMonitor {
 public:
  /// Of `canards` it takes the directions only.
  CanardMonitor(const MonitorPlan& monitor, const CanardsPlan& canards);

  /// Once a tick, with the commands of this tick and the encoders as they were read before it. At most 5 ms of the time
  /// since the last call count, and none of a clock that ran backwards. What is returned changes with the next call.
  const CanardVerdicts& update(Microseconds time, const CanardCommands& commands, const EncoderAngles& encoders);

  /// Of the last update().
  [[nodiscard]] const CanardVerdicts& verdicts() const { return verdicts_; }

  /// Nobody called update() for a while, and the servos may have had no pulses: each canard is expected where its
  /// encoder is next seen, and no encoder has been silent. Verdicts stay as they are judged.
  void bridge();

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(channels_, last_time_);
    for (CanardVerdict& verdict : verdicts_) {
      visit.below(canard_verdicts, verdict);
    }
  }

 private:
  struct Persistence {
    Microseconds charge{};  ///< grows to the hold while the difference lasts, falls back while it is gone
    bool lasting = false;

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(charge, lasting);
    }
  };
  struct Channel {
    float sense = 1.0F;  ///< -1 for a reversed canard
    std::optional<Angle> expected;
    std::optional<Microseconds> silent_since;
    Persistence off;
    Persistence apart;
    Angle lowest;  ///< encoder angles since `off` began to charge
    Angle highest;

    // No state: made anew in every tick.
    bool comparable = false;  ///< driven, and its encoder can be read
    Angle departure;  ///< if comparable: how far the encoder is from `expected`, positive with positive roll moment

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(expected, silent_since, off, apart, lowest, highest);
    }
  };

  /// What all canards share in one tick.
  struct Tick {
    Microseconds time{};
    Microseconds elapsed{};
    bool all_agree = false;
    // Unless all agree: the departures of those that can be compared, lowest first.
    std::array<Angle, canard_count> sorted{};
    std::size_t compared = 0;
  };

  /// `moved_share`: of the way to its command that a servo goes in this tick.
  static void follow(Channel& channel, float moved_share, const CanardCommand& command,
                     const std::optional<Angle>& encoder);
  [[nodiscard]] bool is_in_order(const Channel& channel) const;
  void judge_all(Tick& tick, const EncoderAngles& encoders);
  CanardVerdict judge(const Tick& tick, std::size_t canard, const std::optional<Angle>& encoder);
  CanardVerdict judge_departure(const Tick& tick, Channel& channel, Angle encoder) const;
  void sort_departures(Tick& tick) const;
  [[nodiscard]] bool stands_apart(const Tick& tick, Angle departure) const;
  bool lasts(Persistence& persistence, bool condition, Microseconds elapsed) const;

  MonitorPlan plan_;
  float servo_lag_s_;
  std::array<Channel, canard_count> channels_{};
  CanardVerdicts verdicts_{};
  std::optional<Microseconds> last_time_;

  // No state: how far a servo goes in a tick of this length.
  Microseconds share_of_{};
  float moved_share_ = 0.0F;
};

}  // namespace fantail::core
