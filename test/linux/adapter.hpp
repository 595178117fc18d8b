// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace fantail::test {

/// A CAN adapter on a serial line that speaks the Lawicel protocol, and the kernel's slcan driver attached to it. The
/// line is a pseudo-terminal: what the driver sees is what it sees of a real adapter. Needs root.
class Adapter {
 public:
  /// Throws std::runtime_error.
  Adapter();
  ~Adapter();
  Adapter(const Adapter&) = delete;
  Adapter& operator=(const Adapter&) = delete;

  /// The interface that the kernel made of it; up.
  [[nodiscard]] const std::string& interface() const { return interface_; }

  /// The adapter says these lines to the PC, such as "t1232AABB" (a frame) or "sp130200" (error-passive, counters).
  void say(const std::vector<std::string>& lines);

  /// From now on it takes nothing from the line, or takes it again.
  void stop_reading() { reads_ = false; }
  void go_on_reading() { reads_ = true; }

  /// Frames that the PC has sent so far, as "t1232AABB".
  [[nodiscard]] std::vector<std::string> taken();

 private:
  void work();

  int line_ = -1;      ///< the adapter's end
  int terminal_ = -1;  ///< the driver's end
  std::string interface_;
  std::atomic<bool> reads_ = true;
  std::atomic<bool> ends_ = false;
  std::mutex mutex_;
  std::vector<std::string> taken_;
  std::thread thread_;
};

}  // namespace fantail::test
