// SPDX-License-Identifier: MIT
#include "files/clocks.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <vector>

#include "text/quoting.hpp"

namespace fantail::files {
namespace {

/// "time", "time.1", "Time@Baro (Atm)".
bool is_time(std::string_view name) {
  constexpr std::string_view time = "time";
  if (name.size() < time.size() || !std::ranges::equal(name.substr(0, time.size()), time, {}, [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
      })) {
    return false;
  }
  const std::string_view rest = name.substr(time.size());
  return rest.empty() || rest.front() == '@' ||
         (rest.front() == '.' && rest.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

struct Reading {
  double time = 0.0;
  std::size_t row = 0;
  std::size_t group = 0;
};

/// A column of time and those behind it, up to the next.
struct Group {
  std::size_t time = 0;
  std::size_t end = 0;
};

}  // namespace

std::optional<std::string> in_one_clock(const flight::Table& table) {
  const std::vector<std::string>& names = table.columns();
  std::vector<Group> groups;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_time(names[i])) {
      groups.push_back({.time = i, .end = names.size()});
      if (groups.size() > 1) {
        groups[groups.size() - 2].end = i;
      }
    }
  }
  if (groups.size() < 2 || groups.front().time != 0 || table.find("time_s")) {
    return {};
  }
  std::vector<Reading> readings;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t group = 0; group < groups.size(); ++group) {
      if (const auto time = table.number(row, groups[group].time)) {
        readings.push_back({.time = *time, .row = row, .group = group});
      }
    }
  }
  std::ranges::stable_sort(readings, {}, &Reading::time);
  std::string text = "time";
  for (const Group& group : groups) {
    for (std::size_t i = group.time + 1; i < group.end; ++i) {
      text += ',' + text::csv_cell(names[i]);
    }
  }
  text += '\n';
  for (const Reading& reading : readings) {
    text += table.cell(reading.row, groups[reading.group].time);
    for (std::size_t group = 0; group < groups.size(); ++group) {
      for (std::size_t i = groups[group].time + 1; i < groups[group].end; ++i) {
        text += ',';
        text += group == reading.group ? text::csv_cell(std::string{table.cell(reading.row, i)}) : "";
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace fantail::files
