// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/low_pass.hpp"
#include "core/pad_movement.hpp"
#include "core/vector3.hpp"

namespace fantail::core {

/// What three still seconds on the pad tell: the zero of the gyro and the direction of gravity in the body frame.
struct PadAverage {
  Vector3 gyro_bias_rad_s;
  Vector3 specific_force_m_s2;

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(gyro_bias_rad_s, specific_force_m_s2);
  }
};

/// Averages the sensors while the rocket stands still on the pad: over 3 s that end 0.5 s before now, so that what
/// leads up to a launch detection is never in it. Motion voids the window; the last good average stays.
/// Kept as sums of 0.1 s, so a tick costs few additions and the memory stays small.
class PadWindow {
 public:
  /// Of the plan it takes `stale_time`, `rest_tolerance_m_s2` and `quiet_rate_rad_s`.
  explicit PadWindow(const MotionPlan& plan) : plan_{plan} {}

  /// Feeds one pair of samples, each within largest_rate_rad_s and largest_specific_force_m_s2. After a gap longer than
  /// the plan's stale time, or a time that runs backwards, the window begins anew. True when the average is a new one.
  bool update(Microseconds time, const Vector3& rate_rad_s, const Vector3& specific_force_m_s2);

  /// The sensors have failed: it is not rest.
  void interrupt(Microseconds time);

  /// Empty until the rocket has once stood still for long enough.
  [[nodiscard]] const std::optional<PadAverage>& average() const { return average_; }

  /// How long the rocket has been at rest, up to now; zero while it moves.
  [[nodiscard]] Microseconds at_rest_for(Microseconds now) const;

  /// What it did since it last rested for so long that the average is of that rest alone: 3.5 to 3.6 s.
  [[nodiscard]] const PadMovement& movement() const { return movement_; }

  /// Until it has rested so, it counts as moved.
  void require_rest() { movement_.require_rest(); }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(force_squared_);
    visit.on_pad(blocks_);  // an empty block is not rest
    visit(open_, last_time_, open_since_, rest_since_, average_, movement_);
    visit.below(blocks_.size() + 1, closed_, still_);
    visit.below(blocks_.size(), next_);
    forget_window();  // follows from the blocks, which may be others now
  }

 private:
  static constexpr Microseconds block_time{100'000};
  static constexpr std::size_t window_blocks = 30;
  static constexpr std::size_t guard_blocks = 5;

  struct Block {
    Vector3 rate_sum;
    Vector3 force_sum;
    float samples = 0.0F;
    bool still = true;

    void clear() {  // an assignment would be a call to memset
      rate_sum = force_sum = Vector3{};
      samples = 0.0F;
      still = true;
    }

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(rate_sum, force_sum, samples, still);
    }
  };

  bool go_on(Microseconds time);
  bool close_block();
  void judge_movement(Microseconds length);
  void restart();
  void sum_one_more();
  void forget_window();

  std::optional<PadAverage> average_;  // first: all that is of use in flight
  MotionPlan plan_;
  LowPass force_squared_{16.0F};  ///< one sample's noise is not motion
  std::size_t closed_ = 0;        ///< blocks closed so far, up to the size of the ring
  std::size_t still_ = 0;         ///< of these, in a row, up to the last one
  std::size_t next_ = 0;
  PadMovement movement_;
  Block open_;
  Block
      window_;  ///< of the average that is made when the open block closes: its blocks are summed one a tick until then
  std::size_t summed_ = 0;
  std::optional<Microseconds> last_time_;
  std::optional<Microseconds> open_since_;
  std::optional<Microseconds> rest_since_;
  std::array<Block, window_blocks + guard_blocks> blocks_{};
};

}  // namespace fantail::core
