// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "hal/linux/can_bus.hpp"

namespace fantail::test {

/// Runs a shell command and throws when it fails.
void must(const std::string& command);

/// Somebody listens to everything on this interface, as candump does; a CanBus has filters and does not count.
[[nodiscard]] bool is_heard(const std::string& interface);

/// A command in the background whose output is read at its end. Ends after ten seconds at the latest.
class Background {
 public:
  explicit Background(const std::string& command);
  /// Waits until the command listens to the interface.
  Background(const std::string& command, const std::string& interface);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Waits for the end.
  [[nodiscard]] std::string output();

 private:
  std::FILE* pipe_;
};

/// candump, already listening; its output as in a log, without the times.
[[nodiscard]] Background candump(const std::string& interface, int frames);

/// Asks until the answer is yes; false after a minute, which is far longer than anything takes on a busy machine too.
[[nodiscard]] bool eventually(const std::function<bool()>& question,
                              std::chrono::milliseconds longest = std::chrono::minutes{1});

/// The next frame; waits for it.
[[nodiscard]] std::optional<hal::CanFrame> next_frame(hal::on_linux::CanBus& bus);

/// What a test fixture with both virtual buses starts from, whatever the test before it did to them.
void restore_virtual_buses();

}  // namespace fantail::test
