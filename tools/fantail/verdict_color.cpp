// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/tick_record.hpp"
#include "fantail/terminal.hpp"

namespace fantail::tool {
namespace {

// Where the line behind the one of `from` begins; the end of the text when there is none.
std::size_t next_line(std::string_view text, std::size_t from) {
  const std::size_t newline = text.find('\n', from);
  return newline == std::string_view::npos ? text.size() : newline + 1;
}

}  // namespace

std::string painted_decision(std::string text) {
  constexpr std::array decisions{std::pair{"Outside the model:", Color::yellow}, std::pair{"PASS\n", Color::green},
                                 std::pair{"FAIL\n", Color::red}};
  for (std::size_t line = 0; line < text.size(); line = next_line(text, line)) {
    for (const auto& [words, color] : decisions) {
      if (std::string_view{text}.substr(line).starts_with(words)) {
        const std::string_view said = std::string_view{words}.substr(0, std::string_view{words}.size() - 1);
        text.replace(line, said.size(), painted(color, said));
        break;
      }
    }
  }
  return text;
}

std::string painted_phase(std::string text) {
  for (std::size_t line = 0; line < text.size(); line = next_line(text, line)) {
    const std::size_t begin = std::min(text.find_first_not_of(' ', line), text.size());
    constexpr std::string_view label = "phase ";
    if (!std::string_view{text}.substr(begin).starts_with(label)) {
      continue;
    }
    const std::size_t word = begin + label.size();
    const std::string phase = text.substr(word, text.find_first_of(" \n", word) - word);
    const bool is_safe = phase == core::name(core::Phase::safe);
    if (is_safe || phase != core::name(core::Phase::finished)) {
      const Color color =
          is_safe ? Color::green : (phase == core::name(core::Phase::armed) ? Color::yellow : Color::cyan);
      text.replace(word, phase.size(), painted(color, phase));
    }
  }
  return text;
}

}  // namespace fantail::tool
