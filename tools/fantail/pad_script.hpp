// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

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

enum class PadCommand : std::uint8_t {
  close_switch,
  open_switch,
  press_abort,
  release_abort,
  ignite,
  await_session,
  await_self_test,
  help,
  quit
};

[[nodiscard]] std::string pad_commands_help();

/// What the hand at the pad does, from standard input, one command a line. After a command that waits, the next one is
/// read when its condition holds, so that a script needs no clock.
class PadScript {
 public:
  explicit PadScript(const PadEar& ear) : ear_{ear} {}

  /// The next command to be done now. Says on standard error what is not a command.
  [[nodiscard]] std::optional<PadCommand> next();

 private:
  [[nodiscard]] bool waits();

  const PadEar& ear_;
  LineInput input_;
  std::optional<PadCommand> awaited_;
};

}  // namespace fantail::tool
