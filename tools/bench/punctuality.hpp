// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "link/avionics_link.hpp"

namespace fantail::bench {

/// Whether this PC hears the rocket soon enough, and whole, for what it records to say something of the canards. All
/// times are the rocket's, by the number of its ticks. Every call throws TooSlow when that is over.
class Punctuality {
 public:
  /// From now on, with every tick reported.
  explicit Punctuality(const link::AvionicsLink& link)
      : link_{link}, overrun_before_{link.overrun()}, uncounted_before_ms_{link.uncounted_ms()} {}

  void note(const link::Tick& tick);
  /// Everything that had come has been noted.
  void end_look();
  /// The exercise is over.
  void end() const;

 private:
  const link::AvionicsLink& link_;
  int long_looks_ = 0;
  std::uint32_t overrun_before_;
  std::optional<std::int64_t> uncounted_before_ms_;
  std::optional<std::int64_t> first_;
  std::optional<std::int64_t> last_;
  std::optional<std::int64_t> last_at_look_;
  std::int64_t received_ = 0;
};

}  // namespace fantail::bench
