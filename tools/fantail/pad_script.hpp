// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fantail/standard_streams.hpp"
#include "hal/linux/can_bus.hpp"

namespace fantail::tool {

/// Hears what the avionics says of itself on its way to the bus.
class PadEar final : public hal::CanBus {
 public:
  explicit PadEar(hal::CanBus& bus) : bus_{bus} {}
  bool send(const hal::CanFrame& frame) override;
  std::optional<hal::CanFrame> receive() override { return bus_.receive(); }
  [[nodiscard]] hal::CanState state() const override { return bus_.state(); }
  [[nodiscard]] hal::CanCounters counters() const override { return bus_.counters(); }

  [[nodiscard]] bool session_open() const { return session_open_; }
  [[nodiscard]] bool self_test_passed() const { return self_test_passed_; }

 private:
  hal::CanBus& bus_;
  bool session_open_ = false;
  bool self_test_passed_ = false;
};

/// A line that may be typed at the pad, and what is done then.
struct PadCommand {
  std::string_view text;
  std::string_view meaning;
  std::function<void()> act;
};

/// What the hand at the pad does, from standard input, one command a line. After a command that waits, the next one is
/// read when its condition holds, so that a script needs no clock.
class PadScript {
 public:
  /// Beside these commands there are `wait session`, `wait self-test`, `help` and `quit`. The ear outlives it.
  PadScript(const PadEar& ear, std::vector<PadCommand> commands);
  PadScript(const PadScript&) = delete;  // its own commands point to it
  PadScript& operator=(const PadScript&) = delete;

  /// Does what has been typed by now. Says on standard error what is not a command. False after "quit".
  [[nodiscard]] bool obey();

 private:
  [[nodiscard]] std::string help() const;

  std::vector<PadCommand> commands_;
  LineInput input_;
  std::function<bool()> awaited_;  ///< empty: nothing is
  bool is_over_ = false;
};

}  // namespace fantail::tool
