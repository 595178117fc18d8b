// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::link {

/// Reads a counter of the bus that begins again at 0 after `modulus` counts. It cannot see a whole round that passed
/// between two values.
template <std::int64_t modulus>
class WrappingCounter {
 public:
  explicit WrappingCounter(std::int64_t first) : total_{first} {}

  /// How far on this value is, 0 to modulus - 1.
  [[nodiscard]] std::int64_t step_to(std::int64_t value) const {
    return ((value - total_) % modulus + modulus) % modulus;
  }
  /// The value is an earlier one, if less than half a round passes between two.
  [[nodiscard]] bool is_back(std::int64_t value) const { return step_to(value) >= modulus / 2; }

  /// Takes the value as the newest, and says how far it was on.
  std::int64_t read(std::int64_t value) {
    const std::int64_t step = step_to(value);
    total_ += step;
    return step;
  }

  /// The same of a counter that never stands still: the same value is a whole round on.
  std::int64_t read_next(std::int64_t value) {
    total_ += 1;
    return read(value) + 1;
  }

  /// The first value and all steps since: it does not wrap.
  [[nodiscard]] std::int64_t total() const { return total_; }

 private:
  std::int64_t total_;
};

}  // namespace fantail::link
