// SPDX-License-Identifier: MIT
#pragma once

#include "hal/clock.hpp"

namespace fantail::hal::stm32f4::test {

class FakeClock final : public hal::Clock {
 public:
  [[nodiscard]] Microseconds now() const override { return time; }
  Microseconds time{};
};

}  // namespace fantail::hal::stm32f4::test
