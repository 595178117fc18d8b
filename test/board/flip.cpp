// SPDX-License-Identifier: MIT
#include "flip.hpp"

#include <algorithm>
#include <random>
#include <span>

#include <fmt/format.h>

#include "text/error.hpp"

namespace fantail::board {
namespace {

/// Of a hundred flips.
constexpr std::array<unsigned, regions> shares{45, 15, 5, 20, 15};
/// All instants of a tick, of a frame of the servos, and of the time between two seals of the flight law.
constexpr double longest_delay_s = 12e-3;

std::uint32_t address_of(const Image& image, const char* symbol) {
  const auto address = image.address_of(symbol);
  if (!address) {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: no symbol {}", image.file().string(), symbol)};
  }
  return *address;
}

}  // namespace

const char* name(Region region) {
  switch (region) {
    case Region::statics: return "static memory";
    case Region::stack: return "stack in use";
    case Region::rest: return "rest of the RAM";
    case Region::registers: return "registers";
    case Region::floats: return "of the FPU";
  }
  return "?";
}

MemoryMap::MemoryMap(const Image& image, const Board& board)
    : stack_used{address_of(image, "stack_bottom")},
      stack_top{address_of(image, "stack_top")},
      statics_begin{address_of(image, "data_begin")},
      statics_end{address_of(image, "bss_end")} {
  std::uint32_t word = 0;
  for (; stack_used < stack_top; stack_used += 4) {
    board.processor.read_memory(stack_used, std::as_writable_bytes(std::span{&word, 1}));
    if (word != 0) {
      return;
    }
  }
}

std::uint32_t MemoryMap::bytes(Region region) const {
  const std::uint32_t statics = statics_end - statics_begin;
  const std::uint32_t stack = stack_top - stack_used;
  switch (region) {
    case Region::statics: return statics;
    case Region::stack: return stack;
    case Region::rest: return ram_end - ram_begin - statics - stack;
    case Region::registers:
    case Region::floats: break;
  }
  return 0;
}

std::uint32_t MemoryMap::address(Region region, std::uint32_t byte) const {
  switch (region) {
    case Region::statics: return statics_begin + byte;
    case Region::stack: return stack_used + byte;
    default: break;
  }
  const std::uint32_t below = stack_used - ram_begin;
  const std::uint32_t between = statics_begin - stack_top;
  return byte < below             ? ram_begin + byte
         : byte < below + between ? stack_top + (byte - below)
                                  : statics_end + (byte - below - between);
}

Flip::Flip(std::uint64_t seed, int number) : number_{number} {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                         static_cast<std::uint32_t>(number)};
  std::mt19937_64 random{sequence};
  moment_ = random() >> 8U;
  delay_s_ = longest_delay_s * static_cast<double>(random() >> 11U) * 0x1p-53;
  auto hundredth = static_cast<unsigned>(random() % 100);
  std::size_t region = 0;
  while (hundredth >= shares[region]) {
    hundredth -= shares[region++];
  }
  region_ = static_cast<Region>(region);
  place_ = random() >> 8U;
  bit_ = static_cast<unsigned>(random() >> 8U);
}

std::string Flip::happen(Board& board, const MemoryMap& map) const {
  if (region_ == Region::registers) {
    // The lowest bit of a program counter is none.
    const auto which = static_cast<unsigned>(place_ % 16);
    const unsigned bit = which == 15 ? 1 + bit_ % 31 : bit_ % 32;
    board.processor.flip_register(which, bit);
    return fmt::format("r{} bit {}", which, bit);
  }
  if (region_ == Region::floats) {
    const auto which = static_cast<unsigned>(place_ % Processor::float_registers);
    board.processor.flip_float_register(which, bit_ % 32);
    return which < Processor::float_status ? fmt::format("s{} bit {}", which, bit_ % 32)
                                           : fmt::format("fpscr bit {}", bit_ % 32);
  }
  const std::uint32_t address = map.address(region_, static_cast<std::uint32_t>(place_ % map.bytes(region_)));
  std::byte value{};
  board.processor.read_memory(address, std::span{&value, 1});
  value ^= std::byte{1} << bit_ % 8;
  board.processor.write_memory(address, std::span{&value, 1});
  return fmt::format("0x{:08x} bit {}", address, bit_ % 8);
}

}  // namespace fantail::board
