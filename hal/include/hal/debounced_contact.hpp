// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::hal {

/// What a switch says whose contacts bounce: it changes when its level has been the same new one for 50 ticks in a row,
/// both ways, so contacts that chatter in the rumble of a motor do not disarm. At power-up it is unknown, which is not
/// closed and not open, until the level has been the same for as long.
class DebouncedContact {
 public:
  static constexpr std::uint32_t ticks_to_change = 50;  ///< of a millisecond each

  /// Once a tick.
  void update(bool level) {
    const bool is_old = is_known_ && level == level_;
    ticks_ = is_old ? 0 : level == last_ ? ticks_ + 1 : 1;
    last_ = level;
    if (ticks_ == ticks_to_change) {
      level_ = level;
      is_known_ = true;
      ticks_ = 0;
    }
  }

  [[nodiscard]] bool closed() const { return is_known_ && level_; }  ///< false while it is not known
  [[nodiscard]] bool open() const { return is_known_ && !level_; }   ///< likewise

 private:
  bool is_known_ = false;
  bool level_ = false;
  bool last_ = false;
  std::uint32_t ticks_ = 0;  ///< in a row with the level of the last one, which is not the old one
};

}  // namespace fantail::hal
