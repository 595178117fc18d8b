// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "link/avionics_link.hpp"

namespace fantail::bench {

/// Whether this PC receives the rocket's reports completely and early enough to judge the canards. Times are the
/// rocket's, by the number of its ticks, unless stated to be this PC's. Every call throws Unmeasured when this no
/// longer holds: TooSlow only if this PC read late or lost frames.
class Punctuality {
 public:
  /// From now on, by this PC's clock, with every tick reported.
  Punctuality(const link::AvionicsLink& link, hal::Microseconds now)
      : link_{link},
        last_look_{now},
        last_heard_{now},
        overrun_before_{link.overrun()},
        uncounted_before_ms_{link.uncounted_ms()} {}

  /// At the bus, by this PC's clock.
  void begin_look(hal::Microseconds now);
  void note(const link::Tick& tick);
  /// All received ticks have been noted.
  void end_look();
  /// The exercise is over.
  void end() const;

 private:
  [[noreturn]] void give_up(const std::string& why) const;
  [[noreturn]] void give_up_too_slow(const std::string& why) const;

  const link::AvionicsLink& link_;
  hal::Microseconds last_look_;
  hal::Microseconds last_heard_;
  hal::Microseconds longest_pause_{};    ///< of this PC, between two looks
  hal::Microseconds longest_silence_{};  ///< of the rocket, while this PC looked
  int long_looks_ = 0;
  std::uint32_t overrun_before_;
  std::optional<std::int64_t> uncounted_before_ms_;
  std::optional<std::int64_t> first_;
  std::optional<std::int64_t> last_;
  std::optional<std::int64_t> last_at_look_;
  std::int64_t received_ = 0;
};

}  // namespace fantail::bench
