// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/stm32f4/edge_timer.hpp"

namespace fantail::hal::stm32f4 {

/// Do the edges of a data-ready line belong to the samples that are found in the device?
///
/// Each sample of a device that measures at 1 kHz has an edge of its own, whole periods behind the edge of the sample
/// taken before; a period may be off by 5 % (DS-000347 table 3: 1.5 % at 25 degrees C, and 2 % over the temperatures).
/// Of edges at random one in ten fits; of a line with very many the latest was always just now, which looks like the
/// period of the ticks, so where several came there must be room for them. An edge that fits counts one, up to twenty,
/// one that does not takes five away, and with ten the line is believed.
class SampleEdges {
 public:
  /// The latest edge when a new sample was found, and whether there were others since the one before. True when the
  /// latest is that of this sample.
  bool take(EdgeTimer::Edge edge, bool others);
  /// Most edges have fitted lately.
  [[nodiscard]] bool trusted() const { return fitting_ >= to_trust; }
  /// No wire, or something else that drives it: for the last hundred samples.
  [[nodiscard]] bool lost() const { return without_ >= most_without; }

 private:
  static constexpr std::uint8_t to_trust = 10;
  static constexpr std::uint8_t most_without = 100;

  EdgeTimer::Edge last_ = 0;
  std::uint8_t fitting_ = 0;
  std::uint8_t without_ = 0;  ///< samples, one after the other, before a line was trusted
};

}  // namespace fantail::hal::stm32f4
