// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>

#include "manual/roff.hpp"

namespace fantail::manual {
namespace {

constexpr std::string_view exit_code = "Exit code";
constexpr std::size_t far_right = 12;  // further than a command that goes on

void append(std::string& text, std::string_view more) { text.append(text.empty() ? "" : " ").append(more); }

/// One line of the examples, without the spaces before it.
void add_example(Notes& notes, std::string_view line, std::size_t spaces) {
  if (spaces > far_right && !notes.examples.empty()) {
    append(notes.examples.back().meaning, line);
    return;
  }
  if (spaces <= 2 || notes.examples.empty()) {
    notes.examples.emplace_back();
  }
  const std::size_t gap = std::min(line.find("  "), line.size());
  const std::size_t meaning = std::min(line.find_first_not_of(' ', gap), line.size());
  std::string& command = notes.examples.back().command;
  if (command.ends_with(" \\")) {  // it goes on here
    command.resize(command.size() - 2);
  }
  append(command, line.substr(0, gap));
  if (meaning < line.size()) {
    append(notes.examples.back().meaning, line.substr(meaning));
  }
}

}  // namespace

Notes notes_of(std::string_view text) {
  Notes notes;
  bool goes_on = false;  // the line before was a sentence that has not ended
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t spaces = std::min(line.find_first_not_of(' '), line.size());
    line.remove_prefix(spaces);
    if (line.empty() || line == "Examples:") {
      goes_on = false;
    } else if (spaces > 0) {
      add_example(notes, line, spaces);
    } else {
      auto& list = line.starts_with(exit_code) ? notes.exits : notes.sentences;
      if (!goes_on) {
        list.emplace_back();
      }
      append(list.back(), line);
      goes_on = !line.ends_with('.');
    }
  }
  return notes;
}

}  // namespace fantail::manual
