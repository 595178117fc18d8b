// SPDX-License-Identifier: MIT
// What a particle or a wild pointer does to the processor.
#include <utility>

#include <unicorn/unicorn.h>

#include "processor.hpp"

namespace fantail::board {
namespace {

int float_register_id(unsigned number) {
  return number == Processor::float_status ? UC_ARM_REG_FPSCR : UC_ARM_REG_S0 + static_cast<int>(number);
}

}  // namespace

void Processor::upset(std::function<void()> what) {
  upset_ = std::move(what);
  leave();
}

void Processor::jump(std::uint32_t address, bool masked) {
  upset([=, this] {
    pc_ = address & ~1U;
    set(UC_ARM_REG_PRIMASK, masked ? 1 : get(UC_ARM_REG_PRIMASK));
  });
}

void Processor::flip_register(unsigned number, unsigned bit) {
  upset([=, this] {
    if (number == 15) {
      pc_ ^= 1U << bit & ~1U;
      return;
    }
    const int which = number < 13    ? UC_ARM_REG_R0 + static_cast<int>(number)
                      : number == 13 ? UC_ARM_REG_SP
                                     : UC_ARM_REG_LR;
    set(which, get(which) ^ 1U << bit);
  });
}

void Processor::flip_float_register(unsigned number, unsigned bit) {
  upset([=, this] { set(float_register_id(number), float_register(number) ^ 1U << bit); });
}

std::uint32_t Processor::float_register(unsigned number) const { return get(float_register_id(number)); }

void Processor::move_stack(std::uint32_t address) {
  upset([=, this] { set(UC_ARM_REG_SP, address); });
}

}  // namespace fantail::board
