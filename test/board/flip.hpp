// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "board.hpp"

namespace fantail::board {

/// Where a bit may flip.
enum class Region : std::uint8_t {
  statics,    ///< objects of static storage: nearly all that the firmware knows
  stack,      ///< what of it was ever in use
  rest,       ///< all other RAM, where nobody looks
  registers,  ///< r0 to r15 of the core
  floats,     ///< s0 to s31 and the status of its floating-point unit
};
inline constexpr std::size_t regions = 5;
[[nodiscard]] constexpr bool is_memory(Region region) { return region < Region::registers; }
[[nodiscard]] const char* name(Region region);

/// Which addresses are which, as the linker left them and as the firmware has used its stack up to now.
struct MemoryMap {
  std::uint32_t ram_begin = 0x2000'0000;
  std::uint32_t stack_used = 0;  ///< the lowest word that is not zero, as all of the RAM is at power-up
  std::uint32_t stack_top = 0;
  std::uint32_t statics_begin = 0;
  std::uint32_t statics_end = 0;
  std::uint32_t ram_end = 0x2002'0000;

  /// Throws text::Error when the image does not say.
  MemoryMap(const Image& image, const Board& board);
  [[nodiscard]] std::uint32_t bytes(Region region) const;  ///< of what is no memory: none
  /// The address of this byte of a region.
  [[nodiscard]] std::uint32_t address(Region region, std::uint32_t byte) const;
};

/// When, where and which: all of it follows from a seed and a number, whatever other flips there are.
class Flip {
 public:
  Flip(std::uint64_t seed, int number);

  [[nodiscard]] int number() const { return number_; }
  /// A moment, by weights of any sum.
  template <std::size_t n>
  [[nodiscard]] std::size_t moment(const std::array<int, n>& weights) const;
  [[nodiscard]] double delay_s() const { return delay_s_; }
  [[nodiscard]] Region region() const { return region_; }
  /// Turns it over now. What it was: "r3 bit 7", "0x20004711 bit 3".
  std::string happen(Board& board, const MemoryMap& map) const;

 private:
  int number_;
  std::uint64_t moment_;
  double delay_s_;
  Region region_;
  std::uint64_t place_;
  unsigned bit_;
};

template <std::size_t n>
std::size_t Flip::moment(const std::array<int, n>& weights) const {
  std::uint64_t sum = 0;
  for (const int weight : weights) {
    sum += static_cast<std::uint64_t>(weight);
  }
  std::uint64_t left = moment_ % sum;
  std::size_t i = 0;
  while (left >= static_cast<std::uint64_t>(weights[i])) {
    left -= static_cast<std::uint64_t>(weights[i++]);
  }
  return i;
}

}  // namespace fantail::board
