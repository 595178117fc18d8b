// SPDX-License-Identifier: MIT
#include "log_export/csv.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "flight/six_decimals.hpp"
#include "flight/write_csv.hpp"

namespace fantail::log_export {
namespace {

// As flight.csv has it.
struct Cell {
  fmt::memory_buffer& out;

  void operator()(std::monostate) const {}
  void operator()(double value) const { out.append(flight::SixDecimals{value}.text()); }
  void operator()(std::int64_t value) const {
    const fmt::format_int digits{value};
    out.append(digits.data(), digits.data() + digits.size());
  }
  void operator()(bool value) const { out.push_back(value ? '1' : '0'); }
  void operator()(const Word& word) const { out.append(word.text); }
};

}  // namespace

std::string flight_csv(const Source& source, const flight::Flight& report) {
  flight::Flight part = report;
  std::erase_if(part.rows, [&source](const flight::Row& row) { return !source.inside(row.time_s); });
  return flight::csv(part);
}

std::string csv(const Source& source, const Selection& selection) {
  fmt::memory_buffer out;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "" : ",", fields()[selection[i]].name);
  }
  out.push_back('\n');
  TickReader reader{source};
  const auto& ticks = source.flight().ticks;
  for (std::size_t tick = 0; tick < ticks.size(); ++tick) {
    if (!source.inside(ticks[tick].tick.time)) {
      continue;
    }
    const std::span<const Value> values = reader.read(tick);
    for (std::size_t i = 0; i < selection.size(); ++i) {
      if (i > 0) {
        out.push_back(',');
      }
      std::visit(Cell{out}, values[selection[i]]);
    }
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace fantail::log_export
