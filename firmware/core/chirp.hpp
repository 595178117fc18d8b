// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/flight_plan.hpp"

namespace fantail::core {

/// Excitation added to the roll command, so that a flight log tells damping and torque constant apart. On for
/// begin <= t < end after control start, exactly zero elsewhere.
///
/// product  (A0 + dA(t)) sin(2 pi (slope t + offset + df(t)) t), as published (Eq 45-46). Mind that its instantaneous
///          frequency is the derivative of the phase, |2 slope t + offset|, not the factor in front of t: with the
///          published 2 t - 10 it falls from 8.4 Hz to zero at 2.5 s and rises to 18 Hz at 7 s.
/// sweep    the same amplitude at a frequency that runs evenly from first to last, phase continuous from zero.
///
/// dA and df are seeded, piecewise linear between values drawn every 0.1 s, and off by default.
class Chirp {
 public:
  /// `plan` has passed validate(): frequencies far beyond its ranges would overflow integers.
  [[gnu::cold]] explicit Chirp(const ExcitationPlan& plan);

  /// Excitation at a time after control start. Times must not go backwards.
  [[nodiscard]] Angle update(Microseconds since_control_start);

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(span_, drawn_);
  }

 private:
  /// Of the span of 0.1 s that holds the present time; drawn anew when the time enters the next one.
  struct Span {
    std::uint32_t index = 0;
    float amplitude_at_start = 0.0F;
    float amplitude_at_end = 0.0F;
    float frequency_at_start = 0.0F;
    float frequency_at_end = 0.0F;
    float variation_turns_at_start = 0.0F;  ///< integral of df up to the start of the span

    template <typename Visitor>
    void visit_state(Visitor& visit) {
      visit(index, amplitude_at_start, amplitude_at_end, frequency_at_start, frequency_at_end,
            variation_turns_at_start);
    }
  };

  [[gnu::cold]] void draw(std::uint32_t index);
  [[nodiscard]] float product_turns(Microseconds since_control_start, float varied_hz) const;
  [[nodiscard]] float sweep_turns(Microseconds since_begin) const;

  ExcitationPlan plan_;
  bool varies_;
  // The plan's frequencies as whole numbers.
  std::int64_t product_offset_uhz_;
  std::int64_t product_slope_uhz_s_;
  std::int64_t sweep_first_uhz_;
  std::int64_t sweep_half_slope_nhz_s_;  ///< half, because the phase is the integral of the frequency
  Span span_;
  bool drawn_ = false;
};

}  // namespace fantail::core
