// SPDX-License-Identifier: MIT
#include "fantail/pad_commands.hpp"

#include <array>
#include <string_view>

#include <fmt/core.h>

#include "fantail/standard_streams.hpp"

namespace fantail::tool {
namespace {

struct Word {
  std::string_view text;
  PadCommand command;
  std::string_view meaning;
};
constexpr std::array<Word, 5> words{{
    {"switch close", PadCommand::close_switch, "close the arm switch"},
    {"switch open", PadCommand::open_switch, "open the arm switch"},
    {"ignite", PadCommand::ignite, "ignite the motor"},
    {"help", PadCommand::help, "list these commands"},
    {"quit", PadCommand::quit, "end the program"},
}};

}  // namespace

std::string PadCommands::help() {
  std::string text;
  for (const Word& word : words) {
    text += fmt::format("  {:<14}{}\n", word.text, word.meaning);
  }
  return text;
}

std::optional<PadCommand> PadCommands::next() {
  while (const auto line = input_.next()) {
    for (const Word& word : words) {
      if (*line == word.text) {
        return word.command;
      }
    }
    if (!line->empty()) {
      say(fmt::format("\"{}\" is not a command; there are:\n{}", *line, help()));
    }
  }
  return std::nullopt;
}

}  // namespace fantail::tool
