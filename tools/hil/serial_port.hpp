// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hil/wire.hpp"

namespace fantail::hil {

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
