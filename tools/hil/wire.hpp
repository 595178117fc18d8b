// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace fantail::hil {

/// There is no flight computer at the other end, or not any more. A complete sentence for the person.
class TargetError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes to and from a flight computer.
class Wire {
 public:
  virtual ~Wire() = default;
  /// All of them. Throws TargetError.
  virtual void write(std::span<const std::byte> bytes) = 0;
  /// What there is, after waiting for it; 0 when nothing came in time. Throws TargetError when nothing ever will.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> out, std::chrono::milliseconds at_most) = 0;
};

}  // namespace fantail::hil
