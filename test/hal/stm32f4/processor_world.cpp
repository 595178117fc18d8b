// SPDX-License-Identifier: MIT
#include "processor_world.hpp"

#include "hal/stm32f4/registers/processor.hpp"

namespace fantail::hal::stm32f4 {
namespace {

test::ProcessorWorld* world = nullptr;

}  // namespace

namespace test {

ProcessorWorld::ProcessorWorld() { world = this; }
ProcessorWorld::~ProcessorWorld() { world = nullptr; }

}  // namespace test

namespace registers {

void mask_interrupts() {
  if (world != nullptr) {
    world->masked = true;
  }
}

void unmask_interrupts() {
  if (world != nullptr) {
    world->masked = false;
    if (world->on_unmask) {
      world->on_unmask();
    }
  }
}

void wait_for_interrupt() {
  if (world != nullptr && world->on_wait_for_interrupt) {
    world->on_wait_for_interrupt();
  }
}

void synchronize() {}

}  // namespace registers
}  // namespace fantail::hal::stm32f4
