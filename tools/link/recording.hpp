// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/inputs.hpp"

namespace fantail::link {

template <typename T>
using Each = std::array<T, core::canard_count>;

/// What the avionics reported of one millisecond.
struct Tick {
  std::int64_t number = 0;                    ///< milliseconds by the frames' own counter
  Each<std::optional<double>> command_rad{};  ///< empty: not driven
  Each<std::optional<double>> encoder_rad{};  ///< empty: no valid reading
  Each<bool> limited{};                       ///< as last reported
  std::size_t stretch = 0;                    ///< of the exercise, when it was received; may be some milliseconds off
};

/// The ticks of one exercise, in order. Bounded: it holds no more than `longest` and spans no more than that many
/// milliseconds, whatever numbers come in.
class Recording {
 public:
  static constexpr std::size_t two_minutes = 120'000;
  /// Takes its memory here: to move what is recorded takes longer, on a slow PC, than the avionics waits for a
  /// heartbeat.
  explicit Recording(std::size_t longest = two_minutes) : longest_{longest} {
    ticks_.reserve(std::min(longest, two_minutes));
  }

  /// False, and nothing kept: not after the last one, or beyond the longest span.
  bool add(const Tick& tick);

  [[nodiscard]] std::span<const Tick> ticks() const { return ticks_; }
  /// Numbers between the first and the last tick that never came.
  [[nodiscard]] std::size_t lost_ticks() const;
  /// Ticks that came out of order, twice, or too late to be kept.
  [[nodiscard]] std::size_t refused_ticks() const { return refused_; }

 private:
  std::size_t longest_;
  std::size_t refused_ = 0;
  std::vector<Tick> ticks_;
};

}  // namespace fantail::link
