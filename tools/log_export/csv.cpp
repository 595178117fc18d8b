// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "flight/columns.hpp"
#include "flight/write_csv.hpp"
#include "flight_log/schema.hpp"
#include "log_export/formats.hpp"

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

using flight_log::SchemaField;

std::string column_name(const SchemaField& field) {
  return field.unit.empty() ? field.name : fmt::format("{}_{}", field.name, field.unit);
}

std::vector<SchemaField> tick_fields(const flight_log::Flight& flight) {
  const auto schema = flight_log::parse_schema(flight.schema);
  const flight_log::SchemaRecord* tick = flight_log::find_record(schema, "tick");
  return tick != nullptr ? tick->fields : std::vector<SchemaField>{};
}

flight::Row logged_row(const ReplayedFlight& source, std::size_t i) {
  const protocol::LogTick& tick = source.flight().ticks[i].tick;
  flight::Row row = flight::unknown_row();
  row.replayed = false;
  row.time_s = source.time_s(tick.time);
  row.phase = tick.phase;
  row.command_rad = static_cast<double>(tick.command.radians());
  row.saturated = tick.saturated;
  const core::EncoderAngles encoders = flight_log::encoders_of(source.flight(), tick);
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    if (const auto& command = tick.canard_commands[canard]) {
      row.commands_rad[canard] = static_cast<double>(command->radians());
    }
    if (encoders[canard]) {
      row.encoders_rad[canard] = static_cast<double>(encoders[canard]->radians());
    }
  }
  return row;
}

}  // namespace

std::string flight_csv(const ReplayedFlight& source, const flight::Flight& report) {
  flight::Flight part = report;
  part.rows.clear();
  std::size_t replayed = 0;
  for (std::size_t i = 0; i < source.flight().ticks.size(); ++i) {
    const flight::Row row = source.record(i) != nullptr ? report.rows[replayed++] : logged_row(source, i);
    if (source.inside(row.time_s)) {
      part.rows.push_back(row);
    }
  }
  return flight::csv(part);
}

std::string csv(const ReplayedFlight& source, const Selection& selection) {
  fmt::memory_buffer out;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "" : ",", fields()[selection[i]].name);
  }
  out.push_back('\n');
  for_each_tick(source, [&](std::size_t, core::Microseconds, std::span<const Value> values) {
    for (std::size_t i = 0; i < selection.size(); ++i) {
      if (i > 0) {
        out.push_back(',');
      }
      std::visit(Cell{out}, values[selection[i]]);
    }
    out.push_back('\n');
  });
  return fmt::to_string(out);
}

std::vector<std::string> foreign_fields(const flight_log::Flight& flight) {
  std::vector<std::string> names;
  for (const SchemaField& field : tick_fields(flight)) {
    names.push_back(column_name(field));
  }
  if (!names.empty()) {
    names.insert(names.begin(), {"time_s", "time_us", "sequence"});
  }
  return names;
}

std::string foreign_csv(const flight_log::Flight& flight, std::span<const std::string> names, const Window& window) {
  const std::vector<SchemaField> fields = tick_fields(flight);
  std::vector<const SchemaField*> columns;  // null: of the clock
  for (const std::string& name : names) {
    const auto found = std::ranges::find(fields, name, column_name);
    columns.push_back(found == fields.end() ? nullptr : &*found);
  }
  fmt::memory_buffer out;
  fmt::format_to(std::back_inserter(out), "{}\n", fmt::join(names, ","));
  for (const flight_log::RawRecord& tick : flight.foreign_ticks) {
    const double time_s = 1e-6 * static_cast<double>((tick.time - flight.foreign_ticks.front().time).count());
    if (time_s < window.from_s.value_or(time_s) || time_s > window.until_s.value_or(time_s)) {
      continue;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      fmt::format_to(std::back_inserter(out), "{}", i == 0 ? "" : ",");
      if (columns[i] != nullptr) {
        // The shortest digits that give the number again.
        if (const auto value = flight_log::value(*columns[i], tick.payload); value && std::isfinite(*value)) {
          fmt::format_to(std::back_inserter(out), "{}", *value);
        }
      } else if (names[i] == "time_s") {
        fmt::format_to(std::back_inserter(out), "{:.6f}", time_s);
      } else {
        fmt::format_to(std::back_inserter(out), "{}",
                       names[i] == "time_us" ? tick.time.count() : static_cast<std::int64_t>(tick.sequence));
      }
    }
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace fantail::log_export
