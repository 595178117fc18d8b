// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

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

/// Whether the 4-bit counters of one kind of report can be those of one sender, whatever is lost: between two that
/// follow on (7, 8) comes a third number (7, 3, 8), again and again. It tells a second rocket that counts the frames
/// from about elsewhere sooner than its heartbeats do.
class FrameOrder {
 public:
  void take(std::uint8_t counter) {
    const auto follows_on = [](std::uint8_t one, std::uint8_t next) { return next == ((one + 1U) & 0x0FU); };
    const auto& [before, last] = newest_;
    const bool between = before && last && follows_on(*before, counter) && *last != *before && *last != counter;
    evidence_ = between ? evidence_ + gain : evidence_ > 0 ? evidence_ - 1 : 0;
    two_senders_ = two_senders_ || evidence_ >= proof;
    newest_ = {last, counter};
  }

  /// It stays.
  [[nodiscard]] bool two_senders() const { return two_senders_; }

 private:
  // A PC that stalls before every frame reads any number next, and one in sixteen looks like it: that must count for
  // less than fifteen that do not. The sum then comes to the proof in about one of 10^9 tries (e^(-0.13 x 160)). Two
  // senders that are equally fast come to it in twenty frames, one that is a fifth as fast in some three hundred.
  static constexpr int gain = 8;  ///< one such frame counts for as many that follow
  static constexpr int proof = 160;

  std::array<std::optional<std::uint8_t>, 2> newest_{};  ///< the last one is the second
  int evidence_ = 0;
  bool two_senders_ = false;
};

}  // namespace fantail::link
