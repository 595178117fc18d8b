// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hal/can_bus.hpp"
#include "hal/linux/can_error.hpp"
#include "hal/linux/can_socket.hpp"

namespace fantail::hal::on_linux {

/// A CAN interface of this PC, over SocketCAN. Not for several threads.
///
/// State and counters are those of the last send() or receive(). When the interface goes down or vanishes, what waits
/// to be sent is thrown away, because it would be old when the bus is back; the object looks for the interface's name
/// again, at most every 100 ms and only in these calls, and goes on when it is up. The same happens to what waits when
/// the controller leaves the bus (BUS-OFF).
class CanBus final : public hal::CanBus {
 public:
  static constexpr std::size_t queue_size = 64;  ///< frames that wait for the kernel

  /// Receives the frames that pass one of the filters; without any, all with 11-bit identifiers. Throws CanError when
  /// the interface is not there, is not up, is not CAN, or may not be used.
  explicit CanBus(std::string interface, std::span<const CanFilter> filters = {});

  /// True: sent, or in the queue. Other programs on this PC receive the frame too; this object does not.
  bool send(const CanFrame& frame) override;
  std::optional<CanFrame> receive() override;
  [[nodiscard]] CanState state() const override { return state_; }
  [[nodiscard]] CanCounters counters() const override { return counters_; }

  /// Sleeps until something has arrived, at most for `longest`, and sends what waits in the meantime. True when
  /// receive() is worth a call (it may still find only an error frame); false after `longest`, or early when the
  /// process has caught a signal.
  bool wait(std::chrono::microseconds longest);

  /// Becomes readable when something has arrived. The number stays the same for the life of the object; what stands
  /// behind it is replaced when the interface vanishes and comes back, so epoll must be told again then.
  [[nodiscard]] int descriptor() const { return socket_.descriptor(); }

  [[nodiscard]] const std::string& interface() const { return socket_.interface(); }

 private:
  void flush();
  void note(const ErrorFrame& error);
  void go_down(bool vanished);
  void empty_queue();
  [[nodiscard]] bool reachable();

  CanSocket socket_;
  CanState state_ = CanState::error_active;
  CanCounters counters_{};
  bool vanished_ = false;  ///< the interface behind the socket is gone for good, even if the name comes back
  std::optional<std::chrono::steady_clock::time_point> looked_{};
  std::array<CanFrame, queue_size> queue_{};
  std::size_t first_ = 0;
  std::size_t waiting_ = 0;
};

}  // namespace fantail::hal::on_linux
