// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "fantail/help.hpp"
#include "manual/command.hpp"
#include "text/layout.hpp"

namespace fantail::tool {
namespace {

constexpr std::string_view command_indent = "  ";
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
    std::string all = command_.empty() ? "" : manual::command_lines(command_, command_indent, columns);
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
