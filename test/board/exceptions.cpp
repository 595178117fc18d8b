// SPDX-License-Identifier: MIT
// How the processor enters and leaves an exception.
#include <array>

#include <fmt/format.h>
#include <unicorn/unicorn.h>

#include "processor.hpp"

namespace fantail::board {
namespace {

// Which registers an exception puts on the stack, from the lowest address on; then pc and xPSR. Armv7-M B1.5.6.
constexpr std::array stacked{UC_ARM_REG_R0, UC_ARM_REG_R1, UC_ARM_REG_R2, UC_ARM_REG_R3, UC_ARM_REG_R12, UC_ARM_REG_LR};
constexpr std::size_t basic_words = 8;
constexpr std::size_t float_words = 26;
constexpr std::uint32_t if_then_bits = 0x0600'FC00;
constexpr std::uint32_t exception_bits = 0x1FF;
constexpr std::uint32_t aligned_bit = 1U << 9U;
constexpr std::uint32_t float_context = 4;  // of CONTROL
constexpr std::uint64_t entry_cycles = 12;

}  // namespace

void Processor::fault(std::uint32_t configurable, std::uint32_t address, const std::string& what) {
  const std::uint32_t caller = get(UC_ARM_REG_LR);
  complaints.push_back({timeline_.now_s(), fmt::format("{} by 0x{:08x}, {}, with LR in {}", what, pc_,
                                                       image_.where(pc_), image_.where(caller))});
  if (system_.active() == SystemBlock::nmi || system_.active() == SystemBlock::hard_fault) {
    locked_ = true;
    return;
  }
  system_.set_fault(configurable, address);
  take(SystemBlock::hard_fault);
}

// Armv7-M B1.5.6.
void Processor::take(std::uint32_t exception) {
  const std::uint32_t control = get(UC_ARM_REG_CONTROL);
  const bool with_floats = (control & float_context) != 0;
  const std::uint32_t status = get(UC_ARM_REG_XPSR);
  const std::uint32_t before = get(UC_ARM_REG_SP);
  const std::size_t words = with_floats ? float_words : basic_words;
  const std::uint32_t sp = (before - static_cast<std::uint32_t>(4 * words)) & ~7U;
  std::array<std::uint32_t, float_words> frame{};
  for (std::size_t i = 0; i < stacked.size(); ++i) {
    frame[i] = get(stacked[i]);
  }
  frame[6] = pc_ & ~1U;
  frame[7] = (status & ~0x3FFU) | system_.active() | ((before & 4U) != 0 ? aligned_bit : 0U);
  if (with_floats) {
    for (int i = 0; i < 16; ++i) {
      frame[basic_words + static_cast<std::size_t>(i)] = get(UC_ARM_REG_S0 + i);
    }
    frame[24] = get(UC_ARM_REG_FPSCR);
  }
  set(UC_ARM_REG_SP, sp);
  if (uc_mem_write(engine_, sp, frame.data(), 4 * words) != UC_ERR_OK) {
    // A stack that ran over: the handler runs all the same, on a stack that is none. (B1.5.15)
    complaints.push_back({timeline_.now_s(), fmt::format("no stack at 0x{:08x} for exception {}", sp, exception)});
    exception = SystemBlock::hard_fault;
  }
  const bool from_program = system_.active() == 0;
  system_.begin(exception);
  set(UC_ARM_REG_LR, (with_floats ? 0xFFFF'FFE0U : 0xFFFF'FFF0U) | (from_program ? 9U : 1U));
  set(UC_ARM_REG_CONTROL, control & ~float_context);
  // The handler begins outside of any block that the interrupted code was in.
  set(UC_ARM_REG_XPSR, (status & ~(if_then_bits | 0xFFFFU)) | exception);
  set(UC_ARM_REG_IPSR, exception);
  timeline_.spend(entry_cycles * Timeline::counts_per_cycle);
  std::uint32_t handler = 0;
  read_memory(Image::flash_begin + 4 * exception, std::as_writable_bytes(std::span{&handler, 1}));
  pc_ = handler & ~1U;
}

void Processor::come_back(std::uint32_t exception_return) {
  const bool with_floats = (exception_return & 0x10U) == 0;
  const std::size_t words = with_floats ? float_words : basic_words;
  const std::uint32_t sp = get(UC_ARM_REG_SP);
  std::array<std::uint32_t, float_words> frame{};
  read_memory(sp, std::as_writable_bytes(std::span{frame}.first(words)));
  for (std::size_t i = 0; i < stacked.size(); ++i) {
    set(stacked[i], frame[i]);
  }
  if (with_floats) {
    for (int i = 0; i < 16; ++i) {
      set(UC_ARM_REG_S0 + i, frame[basic_words + static_cast<std::size_t>(i)]);
    }
    set(UC_ARM_REG_FPSCR, frame[24]);
  }
  const std::uint32_t status = frame[7];
  system_.return_to(status & exception_bits);
  set(UC_ARM_REG_XPSR, status & ~aligned_bit);
  set(UC_ARM_REG_IPSR, status & exception_bits);
  const std::uint32_t control = get(UC_ARM_REG_CONTROL);
  set(UC_ARM_REG_CONTROL, with_floats ? control | float_context : control & ~float_context);
  set(UC_ARM_REG_SP, sp + static_cast<std::uint32_t>(4 * words) + ((status & aligned_bit) != 0 ? 4U : 0U));
  pc_ = frame[6] & ~1U;
}

}  // namespace fantail::board
