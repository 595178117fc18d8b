// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace fantail::hal {

/// One classic CAN frame.
struct CanFrame {
  std::uint32_t id = 0;                ///< 11 bits, or 29 in an extended frame
  bool extended = false;               ///< `id` has 29 bits
  bool remote = false;                 ///< asks for data and carries none
  std::uint8_t length = 0;             ///< bytes of data, 0 to 8
  std::array<std::uint8_t, 8> data{};  ///< the first `length` are sent, unless `remote`; == compares all
  friend bool operator==(const CanFrame&, const CanFrame&) = default;
};

/// The controller's state of the bus, in the terms of ISO 11898.
enum class CanState : std::uint8_t {
  error_active,   ///< all is well
  error_warning,  ///< an error counter has reached 96
  error_passive,  ///< 128: this node may no longer disturb the others
  bus_off,        ///< 256: this node has left the bus
  down,           ///< there is no bus: the interface is down or gone
};

/// Since power-up; they wrap around.
struct CanCounters {
  std::uint32_t sent = 0;      ///< handed to the controller
  std::uint32_t received = 0;  ///< handed to the caller
  std::uint32_t unsent = 0;    ///< refused because the queue was full or the bus was not there
  std::uint32_t overrun = 0;   ///< arrived, and lost before anybody read them
  std::uint32_t errors = 0;    ///< error frames: the bus was disturbed
};

/// A CAN controller at 1 Mbit/s. Neither call ever waits.
class CanBus {
 public:
  virtual ~CanBus() = default;
  /// False when the bounded queue is full or there is no bus; the frame is dropped and counted.
  virtual bool send(const CanFrame& frame) = 0;
  /// The oldest frame that has arrived from another node; empty when there is none.
  virtual std::optional<CanFrame> receive() = 0;
  /// As of now.
  [[nodiscard]] virtual CanState state() const = 0;
  /// As of now.
  [[nodiscard]] virtual CanCounters counters() const = 0;
};

}  // namespace fantail::hal
