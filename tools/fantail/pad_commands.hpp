// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fantail/line_input.hpp"

namespace fantail::tool {

/// The commands at a simulated pad.
enum class PadCommand : std::uint8_t { close_switch, open_switch, ignite, help, quit };

/// Words on standard input, one command a line.
class PadCommands {
 public:
  /// Says on standard error what it did not understand.
  [[nodiscard]] std::optional<PadCommand> next();

  [[nodiscard]] static std::string help();

 private:
  LineInput input_;
};

}  // namespace fantail::tool
