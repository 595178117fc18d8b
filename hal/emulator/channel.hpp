// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace fantail::hal::emulator {

/// Bytes to and from the simulator of the world.
class Channel {
 public:
  virtual ~Channel() = default;
  /// Waits for at least one byte and takes what there is, as far as there is room. Never returns when nobody is at the
  /// other end any more and nobody will be.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> out) = 0;
  /// All of them.
  virtual void write(std::span<const std::byte> bytes) = 0;
};

}  // namespace fantail::hal::emulator
