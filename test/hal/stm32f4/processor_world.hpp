// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace fantail::hal::stm32f4::test {

/// What the processor of one test does when it is told to mask its interrupts and to sleep. One lives at a time.
class ProcessorWorld {
 public:
  ProcessorWorld();
  ~ProcessorWorld();
  ProcessorWorld(const ProcessorWorld&) = delete;
  ProcessorWorld& operator=(const ProcessorWorld&) = delete;

  bool masked = false;
  std::function<void()> on_unmask{};              ///< the place to serve what waits
  std::function<void()> on_wait_for_interrupt{};  ///< returns when an interrupt waits, masked or not
};

}  // namespace fantail::hal::stm32f4::test
