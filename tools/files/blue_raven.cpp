// SPDX-License-Identifier: MIT
#include "files/blue_raven.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "files/clock_time.hpp"
#include "text/number.hpp"

namespace fantail::files {
namespace {

/// One column of the export: a word of the record, counted from 0, over a scale.
struct Word {
  std::string_view name;
  std::size_t word;
  double per_unit;
};

struct Record {
  std::string_view mark;
  std::size_t words;  ///< of a whole record
  std::size_t check;  ///< where its "CRC:" stands
  std::span<const Word> columns;
};

// Quat: x, y and z, then the scalar, which the export has first.
constexpr std::array high_rate{
    Word{"Gyro_X", 8, 100.0},     Word{"Gyro_Y", 9, 100.0},     Word{"Gyro_Z", 10, 100.0},
    Word{"Accel_X", 11, 100.0},   Word{"Accel_Y", 12, 100.0},   Word{"Accel_Z", 13, 100.0},
    Word{"Quat_1", 17, 30'000.0}, Word{"Quat_2", 14, 30'000.0}, Word{"Quat_3", 15, 30'000.0},
    Word{"Quat_4", 16, 30'000.0},
};
constexpr std::array low_rate{
    Word{"Temperature_(F)", 9, 100.0},  Word{"Baro_Press_(atm)", 10, 50'000.0}, Word{"Velocity_Up", 18, 1.0},
    Word{"Inertial_Altitude", 22, 1.0}, Word{"Tilt_Angle_(deg)", 26, 10.0},
};
constexpr std::array records{Record{"LOG_HIR", 22, 20, high_rate}, Record{"LOG_LOW", 40, 38, low_rate}};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(" \t\r"); begin != std::string_view::npos;
       begin = line.find_first_not_of(" \t\r", begin)) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

/// Its numbers as a row; empty: the record is broken.
std::string row_of_record(const Record& kind, const std::vector<std::string_view>& words,
                          std::optional<double>& begin_s) {
  constexpr std::size_t date = 3;
  if (words.size() != kind.words || words[1] != kind.mark || words[kind.check] != "CRC:") {
    return {};
  }
  const auto clock_s =
      clock_time_s(fmt::format("{}-{:0>2}-{:0>2} {}", words[date], words[date + 1], words[date + 2], words[date + 3]));
  if (!clock_s) {
    return {};
  }
  begin_s = begin_s.value_or(*clock_s);
  std::string row = fmt::format("{:.3f}", *clock_s - *begin_s);
  for (const Word& column : kind.columns) {
    const auto number = text::number(words[column.word]);
    if (!number) {
      return {};
    }
    row += fmt::format(",{:g}", *number / column.per_unit);
  }
  return row + '\n';
}

}  // namespace

std::optional<BlueRavenTable> blue_raven_table(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const auto* const kind = std::ranges::find_if(
      records, [&](const Record& one) { return text.starts_with("@ ") && text.substr(2).starts_with(one.mark); });
  if (kind == records.end()) {
    return {};
  }
  BlueRavenTable table{.text = "Flight_Time_(s)"};
  for (const Word& column : kind->columns) {
    table.text += fmt::format(",{}", column.name);
  }
  table.text += '\n';
  std::optional<double> begin_s;
  std::size_t read = 0;
  std::size_t broken = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, end));
    if (!words.empty()) {
      const std::string row = row_of_record(*kind, words, begin_s);
      ++read;
      broken += row.empty() ? 1 : 0;
      table.text += row;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  table.notes.emplace_back("The raw text of a Blue Raven: its time begins with the first record.");
  if (broken > 0) {
    table.notes.push_back(fmt::format("Broken records, which are left out: {} of {}.", broken, read));
  }
  return table;
}

}  // namespace fantail::files
