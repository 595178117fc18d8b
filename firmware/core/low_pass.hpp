// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/time.hpp"

namespace fantail::core {

/// How far a first-order lag moves towards a held input in a step of x time constants: 1 - exp(-x).
/// The exponential is replaced by the reciprocal of its own series: off by x^4/24 for a small x, and in [0, 1] for
/// every x, so the lag is stable however late a sample comes. Zero for a negative x or NaN: the series has a zero at
/// -1.6, and a clock that runs backwards must not find it.
[[nodiscard]] constexpr float lag_fraction(float x) {
  if (!(x > 0.0F)) {
    return 0.0F;
  }
  return 1.0F - 1.0F / (1.0F + x * (1.0F + x * (0.5F + x * (1.0F / 6.0F))));
}

/// First-order low-pass, discretised from the timestamps and primed by the first sample.
class LowPass {
 public:
  /// Half the power passes at `cutoff_hz`: the time constant is 1 / (2 pi cutoff_hz).
  constexpr explicit LowPass(float cutoff_hz) : rate_rad_s_{2.0F * 3.14159265F * cutoff_hz} {}

  /// Feeds one sample and returns the output, which a time that repeats or runs backwards does not change.
  constexpr float update(Microseconds time, float input) {
    if (!last_time_) {
      output_ = input;
    } else {
      const float elapsed_s = seconds(time - *last_time_);
      if (elapsed_s != elapsed_s_) {  // one tick is as long as the other
        elapsed_s_ = elapsed_s;
        fraction_ = lag_fraction(rate_rad_s_ * elapsed_s);
      }
      output_ += fraction_ * (input - output_);
    }
    last_time_ = time;
    return output_;
  }

  /// The next sample primes it again.
  constexpr void reset() { last_time_.reset(); }

  /// As of the last sample; empty before the first and after reset().
  [[nodiscard]] constexpr std::optional<float> output() const {
    return last_time_ ? std::optional{output_} : std::nullopt;
  }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(output_, last_time_);
  }

 private:
  float rate_rad_s_;
  float output_ = 0.0F;
  std::optional<Microseconds> last_time_;

  // No state: how far it moves in a step of this length.
  float elapsed_s_ = 0.0F;
  float fraction_ = 0.0F;
};

}  // namespace fantail::core
