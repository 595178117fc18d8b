// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/time.hpp"

float nondet_float();

namespace fantail::core {

/// In the place of the low-pass: its output may be any number at all, those of the real one included, of any cut-off
/// and after any samples. What is proved with it holds with the low-pass and without.
class LowPass {
 public:
  constexpr explicit LowPass(float) {}

  float update(Microseconds time, float) {
    last_time_ = time;
    output_ = nondet_float();
    return output_;
  }

  [[nodiscard]] std::optional<float> output() const {
    return last_time_ ? std::optional<float>{output_} : std::optional<float>{};
  }

  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(output_, last_time_);
  }

  float output_ = 0.0F;
  std::optional<Microseconds> last_time_;
};

}  // namespace fantail::core
