// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hal/stm32f4/registers/exti.hpp"
#include "hal/stm32f4/registers/pwr.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// A supply, the voltage detector on it (RM0090 section 5.2.3, levels of DS8626 table 19) and the line that keeps its
/// edges (section 12.2). As the real one, it has hysteresis, its output rises when it is switched on below its level or
/// settles, and an edge is kept only where its line is not masked.
class FakeSupply {
 public:
  registers::Pwr power{};
  registers::Exti lines{};
  bool has_edge_when_switched_on = false;

  explicit FakeSupply(RegisterWorld& world) {
    world.on_read(power.cr, [this] { return cr_; });
    world.on_write(power.cr, [this](std::uint32_t value) {
      const bool begins = (value & ~cr_ & 0x10U) != 0;
      cr_ = value;
      look();
      if (begins && has_edge_when_switched_on) {
        late_edge_ = true;
      }
    });
    world.on_read(power.csr, [this] { return output_ ? 4U : 0U; });
    world.on_read(lines.pr, [this] {
      if (late_edge_) {
        rise();
        late_edge_ = false;
      }
      return pending_;
    });
    world.on_write(lines.pr, [this](std::uint32_t value) { pending_ &= ~value; });
  }

  void set_volts(double volts) {
    volts_ = volts;
    look();
  }
  /// For less than a tick.
  void dip_to(double volts) {
    const double before = volts_;
    set_volts(volts);
    set_volts(before);
  }

 private:
  void look() {
    // Typical levels, for falling supply and then for rising.
    constexpr std::array falling{2.04, 2.19, 2.35, 2.51, 2.66, 2.84, 2.93, 3.03};
    constexpr std::array rising{2.14, 2.30, 2.45, 2.60, 2.76, 2.93, 3.03, 3.14};
    const std::uint32_t level = cr_ >> 5U & 7U;
    const bool on = (cr_ & 0x10U) != 0;
    const bool output = on && volts_ < (output_ ? rising[level] : falling[level]);
    if (output && !output_) {
      rise();
    }
    output_ = output;
  }
  void rise() {
    constexpr std::uint32_t line = 1U << 16U;
    if ((RegisterWorld::peek(lines.rtsr) & RegisterWorld::peek(lines.imr) & line) != 0) {
      pending_ |= line;
    }
  }

  std::uint32_t cr_ = 0x4000;  // reset value
  double volts_ = 3.3;
  bool output_ = false;
  bool late_edge_ = false;
  std::uint32_t pending_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
