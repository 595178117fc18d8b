// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::core {

/// A float sum that carries its rounding error along (Kahan): twenty seconds of 1 kHz increments lose nothing that
/// could be seen. Needs strict floating point; the flags of this project never allow anything else.
class CompensatedSum {
 public:
  /// After an infinity or a NaN only reset() makes a number of it again.
  constexpr void add(float increment) {
    const float corrected = increment - lost_;
    const float next = sum_ + corrected;
    lost_ = (next - sum_) - corrected;
    sum_ = next;
  }
  /// To zero, with nothing carried along.
  constexpr void reset() { *this = {}; }
  /// The sum rounded to a float; the error that is carried along is not in it.
  [[nodiscard]] constexpr float value() const { return sum_; }

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(sum_, lost_);
  }

 private:
  float sum_ = 0.0F;
  float lost_ = 0.0F;
};

}  // namespace fantail::core
