// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::hal::stm32f4::registers {

// The two ways to a device. On the board they are one load and one store (register_access.cpp); the tests of the
// drivers link a file of their own in its place, and behind each address a device that behaves like the real one.
[[nodiscard]] std::uint32_t load(const volatile std::uint32_t& place);
void store(volatile std::uint32_t& place, std::uint32_t value);

/// One 32-bit register of a device.
class Register {
 public:
  [[nodiscard]] std::uint32_t read() const { return load(bits_); }
  void write(std::uint32_t value) { store(bits_, value); }

  [[nodiscard]] bool any(std::uint32_t mask) const { return (read() & mask) != 0; }
  [[nodiscard]] bool all(std::uint32_t mask) const { return (read() & mask) == mask; }
  void set(std::uint32_t mask) { write(read() | mask); }
  void clear(std::uint32_t mask) { write(read() & ~mask); }
  /// The bits of `mask` become those of `value`.
  void change(std::uint32_t mask, std::uint32_t value) { write((read() & ~mask) | (value & mask)); }

 private:
  volatile std::uint32_t bits_;
};
static_assert(sizeof(Register) == 4);

/// Looks until all bits of `mask` are `wanted`; false when they are not after so many looks. A count of looks needs no
/// clock that runs, and is the same in the emulator; it is at least the time of that many bus accesses.
[[nodiscard]] inline bool wait_for(const Register& place, std::uint32_t mask, std::uint32_t wanted,
                                   std::uint32_t most_looks) {
  for (std::uint32_t look = 0; look < most_looks; ++look) {
    if ((place.read() & mask) == wanted) {
      return true;
    }
  }
  return false;
}

}  // namespace fantail::hal::stm32f4::registers
