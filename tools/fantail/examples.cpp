// SPDX-License-Identifier: MIT
#include "fantail/examples.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "text/wrapped.hpp"

namespace fantail::tool {
namespace {

constexpr std::string_view command_indent = "  ";
constexpr std::string_view next_indent = "      ";
constexpr std::string_view meaning_indent = "    ";
constexpr std::string_view goes_on = " \\";

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

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

/// Options with their values, where a line can hold them.
std::vector<std::string_view> parts_of(std::string_view command, std::size_t columns) {
  std::vector<std::string_view> parts;
  for (const std::string_view part : split(command, {" --", " | "})) {
    const bool fits = next_indent.size() + part.size() + goes_on.size() <= columns;
    std::ranges::copy(fits ? std::vector{part} : split(part, {" "}), std::back_inserter(parts));
  }
  return parts;
}

std::string command_text(std::string_view command, std::size_t columns) {
  std::string whole;
  std::string line;
  for (const std::string_view part : parts_of(command, columns)) {
    if (!line.empty() && line.size() + 1 + part.size() + goes_on.size() > columns) {
      whole += line;
      whole += goes_on;
      whole += '\n';
      line = next_indent;
    } else {
      line += line.empty() ? command_indent : " ";
    }
    line += part;
  }
  return whole + line + "\n";
}

class Example {
 public:
  void add_to_command(std::string_view part) {
    command_ += command_.empty() ? "" : " ";
    command_ += part.substr(0, part.size() - (part.ends_with(goes_on) ? goes_on.size() : 0));
    goes_on_ = part.ends_with(goes_on);
  }
  void add_to_meaning(std::string_view part) {
    meaning_ += meaning_.empty() ? meaning_indent : std::string_view{" "};
    meaning_ += part;
  }
  [[nodiscard]] bool goes_on_below() const { return goes_on_; }

  /// And forgets it.
  std::string text(std::size_t columns) {
    std::string all = command_.empty() ? "" : command_text(command_, columns);
    all += meaning_.empty() ? "" : text::wrapped(meaning_ + "\n", columns);
    *this = {};
    return all;
  }

 private:
  std::string command_{};
  std::string meaning_{};
  bool goes_on_ = false;
};

}  // namespace

std::string examples_text(std::string_view text, std::size_t columns) {
  const std::vector<std::string_view> lines = lines_of(text);
  if (std::ranges::all_of(lines, [columns](std::string_view line) { return text::display_width(line) <= columns; })) {
    return std::string{text} + "\n";
  }
  std::string all;
  Example example;
  for (const std::string_view line : lines) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::string_view words = line.substr(indent);
    if (indent < command_indent.size()) {
      all += example.text(columns) + text::wrapped(std::string{line} + "\n", columns);
    } else if (indent > command_indent.size() && !example.goes_on_below()) {
      example.add_to_meaning(words);
    } else {
      all += example.goes_on_below() ? "" : example.text(columns);
      const std::size_t gap = words.find("  ");
      example.add_to_command(words.substr(0, gap));
      if (gap != std::string_view::npos) {
        example.add_to_meaning(words.substr(words.find_first_not_of(' ', gap)));
      }
    }
  }
  return all + example.text(columns);
}

}  // namespace fantail::tool
