// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace fantail::telemetry {

// Inside the codec only: how what may be unknown looks on the wire.

inline constexpr int unknown_number = -1;

[[nodiscard]] inline double to_wire(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

[[nodiscard]] inline std::optional<double> from_wire(double value) {
  return value == value ? std::optional{value} : std::nullopt;  // NaN alone differs from itself
}

[[nodiscard]] inline std::int64_t to_wire(const std::optional<std::int64_t>& count) {
  return count.value_or(unknown_number);
}

template <typename Enum>
[[nodiscard]] std::int8_t word(Enum value) {
  return static_cast<std::int8_t>(value);
}

/// Reads words and remembers whether all of them were known.
class WordReader {
 public:
  /// `last`: the enumerator with the highest number.
  template <typename Enum>
  [[nodiscard]] Enum read(std::int8_t wire, Enum last) {
    if (wire < 0 || wire > word(last)) {
      all_known_ = false;
      return Enum{};
    }
    return static_cast<Enum>(wire);
  }
  /// -1 is no word, and allowed.
  template <typename Enum>
  [[nodiscard]] std::optional<Enum> read_if_known(std::int8_t wire, Enum last) {
    return wire == unknown_number ? std::nullopt : std::optional{read(wire, last)};
  }
  [[nodiscard]] bool boolean(std::int8_t wire) {
    all_known_ = all_known_ && (wire == 0 || wire == 1);
    return wire == 1;
  }
  void refuse() { all_known_ = false; }
  [[nodiscard]] bool all_known() const { return all_known_; }

 private:
  bool all_known_ = true;
};

}  // namespace fantail::telemetry
