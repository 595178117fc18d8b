// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

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

  /// False when there is nobody to read them, where the process ignores SIGPIPE as every verb does; else it ends.
  [[nodiscard]] bool write(std::span<const std::byte> bytes) const;
  /// 0: nothing came in time. Empty: nothing ever will.
  [[nodiscard]] std::optional<std::size_t> read(std::span<std::byte> out, std::chrono::milliseconds at_most) const;

 private:
  int number_;
};

/// Its two ends: reading, writing. Neither ever waits by itself, and programs that are started do not inherit them.
/// Throws std::system_error.
[[nodiscard]] std::pair<Descriptor, Descriptor> make_pipe();

/// A serial port: 921600 baud, 8 bits, no parity, no flow control.
class SerialPort final : public Wire {
 public:
  /// Throws TargetError when the device is missing, in use, or no serial port.
  explicit SerialPort(std::string device);

  void write(std::span<const std::byte> bytes) override;
  [[nodiscard]] std::size_t read(std::span<std::byte> out, std::chrono::milliseconds at_most) override;

 private:
  [[noreturn]] void refuse(const std::string& why) const;

  std::string device_;
  Descriptor port_;
};

}  // namespace fantail::hil
