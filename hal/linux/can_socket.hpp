// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hal/can_bus.hpp"

namespace fantail::hal::on_linux {

/// Lets a frame pass when it agrees with `id` in every bit that is set in `mask`.
struct CanFilter {
  std::uint32_t id = 0;
  std::uint32_t mask = 0;
  bool extended = false;  ///< 29-bit frames; else 11-bit frames
};

/// The content of an error frame from a controller or its driver.
struct ErrorFrame {
  std::optional<CanState> state{};  ///< empty when the frame says nothing about it
  bool controller_overrun = false;  ///< frames were lost before the kernel saw them
};

enum class ArrivalKind : std::uint8_t {
  nothing,
  frame,
  error,
  down,      ///< the interface was taken down
  vanished,  ///< the interface was removed
};

struct Arrival {
  ArrivalKind kind = ArrivalKind::nothing;
  CanFrame frame{};
  ErrorFrame error{};
  std::uint32_t lost = 0;  ///< frames that found the socket's buffer full, since the last read
};

enum class WriteResult : std::uint8_t {
  done,
  full,      ///< the kernel's queue has no room now
  refused,   ///< this frame will never be taken
  down,      ///< as in ArrivalKind
  vanished,  ///< as in ArrivalKind
};

enum class Wake : std::uint8_t { arrived, time_out, signal };

/// Can this frame exist on a bus?
[[nodiscard]] bool fits_can(const CanFrame& frame);

/// Sleeps without listening.
[[nodiscard]] Wake sleep_deaf(std::chrono::microseconds longest);

/// One raw CAN socket, bound to one interface; receives no CAN FD frames and not its own.
class CanSocket {
 public:
  /// Throws CanError.
  CanSocket(std::string interface, std::span<const CanFilter> filters);
  ~CanSocket();
  CanSocket(const CanSocket&) = delete;
  CanSocket& operator=(const CanSocket&) = delete;

  [[nodiscard]] WriteResult write(const CanFrame& frame) const;
  [[nodiscard]] Arrival read();
  /// A time-out of zero only looks.
  [[nodiscard]] Wake sleep(std::chrono::microseconds longest) const;
  /// Binds anew to the interface that has the name now. The descriptor keeps its number. False when that fails.
  bool reopen();

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] int interface_index() const { return index_; }
  [[nodiscard]] const std::string& interface() const { return interface_; }

 private:
  [[nodiscard]] int opened();

  std::string interface_;
  std::vector<CanFilter> filters_;
  int index_ = 0;
  std::uint32_t lost_ = 0;  ///< as the kernel counts it
  int descriptor_ = -1;
};

}  // namespace fantail::hal::on_linux
