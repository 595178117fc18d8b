// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace fantail::hil {

/// An open file of the system, closed with this object.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_{number} {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  [[nodiscard]] int number() const { return number_; }
  void close();

  /// False when there is nobody to read them.
  [[nodiscard]] bool write(std::span<const std::byte> bytes) const;
  /// 0: nothing came in time. Empty: nothing ever will.
  [[nodiscard]] std::optional<std::size_t> read(std::span<std::byte> out, std::chrono::milliseconds at_most) const;

 private:
  int number_;
};

/// Its two ends: reading, writing. Neither ever waits by itself, and programs that are started do not inherit them.
/// Throws std::system_error.
[[nodiscard]] std::pair<Descriptor, Descriptor> make_pipe();

}  // namespace fantail::hil
