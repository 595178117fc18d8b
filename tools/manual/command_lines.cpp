// SPDX-License-Identifier: MIT
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "manual/command.hpp"

namespace fantail::manual {
namespace {

constexpr std::string_view goes_on = " \\";

/// Before every blank that one of these begins with; what is quoted stays together.
std::vector<std::string_view> split(std::string_view text, std::initializer_list<std::string_view> before) {
  std::vector<std::string_view> parts;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    quoted = quoted != (text[i] == '\'' || text[i] == '"');
    const auto is_next = [&](std::string_view what) { return text.substr(i).starts_with(what); };
    if (!quoted && std::ranges::any_of(before, is_next)) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// Options with their values, where a line of so many columns can hold them.
std::vector<std::string_view> parts_of(std::string_view command, std::size_t columns) {
  std::vector<std::string_view> parts;
  for (const std::string_view part : split(command, {" --", " | "})) {
    const bool fits = part.size() + goes_on.size() <= columns;
    std::ranges::copy(fits ? std::vector{part} : split(part, {" "}), std::back_inserter(parts));
  }
  return parts;
}

}  // namespace

std::string command_lines(std::string_view command, std::string_view indent, std::size_t columns) {
  const std::string next_indent = std::string{indent} + "    ";
  std::string whole;
  std::string line;
  for (const std::string_view part : parts_of(command, columns - std::min(columns, next_indent.size()))) {
    if (!line.empty() && line.size() + 1 + part.size() + goes_on.size() > columns) {
      whole += line;
      whole += goes_on;
      whole += '\n';
      line = next_indent;
    } else {
      line += line.empty() ? indent : " ";
    }
    line += part;
  }
  return whole + line + "\n";
}

}  // namespace fantail::manual
