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
    {"switch close", PadCommand::close_switch, "a hand closes the arm switch"},
    {"switch open", PadCommand::open_switch, "and opens it again"},
    {"ignite", PadCommand::ignite, "the motor burns"},
    {"help", PadCommand::help, "these words"},
    {"quit", PadCommand::quit, "end"},
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
      say(fmt::format("\"{}\" is no command; there are:\n{}", *line, help()));
    }
  }
  return std::nullopt;
}

}  // namespace fantail::tool
