// SPDX-License-Identifier: MIT
#include "trajectory/exported_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::trajectory {
namespace {

constexpr std::array separators{',', ';', '\t'};
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

struct Line {
  std::size_t begin;
  std::size_t end;
  std::size_t number;  ///< counted from 1
};

[[noreturn]] void refuse(const std::string& name, std::size_t line, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, fmt::format("{}:{}: {}", name, line, complaint)};
}

bool begins_with_time(std::string_view cell) {
  constexpr std::string_view word = "time";
  const std::string_view trimmed = text::trimmed(cell);
  return trimmed.size() >= word.size() &&
         std::ranges::equal(trimmed.substr(0, word.size()), word, {},
                            [](unsigned char c) { return static_cast<char>(std::tolower(c)); }) &&
         (trimmed.size() == word.size() || trimmed.substr(word.size()).starts_with(" ("));
}

bool is_header(std::string_view line) {
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find_first_of(",;\t", begin), line.size());
    if (begins_with_time(line.substr(begin, end - begin))) {
      return true;
    }
    begin = end + 1;
  }
  return false;
}

/// Where the names of the columns stand: in the last comment that can be one before the first row, or in the first line
/// that is no comment.
std::optional<Line> find_header(std::string& text) {
  std::optional<Line> header;
  std::size_t begin = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  for (std::size_t number = 1; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text::trimmed(std::string_view{text}.substr(begin, end - begin));
    if (!line.empty() && line.front() != '#') {
      return is_header(line) || !header ? Line{begin, end, number} : header;
    }
    if (!line.empty() && is_header(line.substr(1))) {
      header = Line{begin, end, number};
    }
    begin = end + 1;
  }
  return header;
}

void refuse_unnamed_velocities(const std::string& name, std::size_t line, std::string_view header) {
  if (header.find("E3,W1 (rad/s)") != std::string_view::npos && header.find("Vx") == std::string_view::npos) {
    refuse(name, line,
           "RocketPy wrote this without names of variables, and its header then lacks the three velocities; name them: "
           "export_data(\"flight.csv\", \"altitude\", \"speed\", \"vz\", \"attitude_angle\", \"density\", "
           "time_step=0.01)");
  }
}

void make_commas(std::string& text, const std::string& name, char separator) {
  std::size_t line = 1;
  bool is_comment = false;
  bool at_begin = true;
  for (char& c : text) {
    if (c == '\n') {
      ++line;
      at_begin = true;
      is_comment = false;
      continue;
    }
    is_comment = is_comment || (at_begin && c == '#');
    at_begin = at_begin && (c == ' ' || is_comment);
    if (c == ',' && !is_comment) {
      refuse(name, line,
             fmt::format("a comma, where the columns are separated by {}; numbers are expected with a decimal point",
                         separator == ';' ? "semicolons" : "tabs"));
    }
    if (c == separator) {
      c = ',';
    }
  }
}

}  // namespace

flight::Table exported_table(std::string text, const std::string& name) {
  if (const auto header = find_header(text)) {
    const std::string_view line = std::string_view{text}.substr(header->begin, header->end - header->begin);
    refuse_unnamed_velocities(name, header->number, line);
    const auto* used = std::ranges::find_if(
        separators, [&](char separator) { return line.find(separator) != std::string_view::npos; });
    const char separator = used == separators.end() ? ',' : *used;
    const std::size_t mark = text.find_first_not_of(" \t", header->begin);
    if (text[mark] == '#') {
      text[mark] = ' ';
    }
    if (separator != ',') {
      make_commas(text, name, separator);
    }
  }
  return flight::Table::parse(std::move(text), name);
}

}  // namespace fantail::trajectory
