// SPDX-License-Identifier: MIT
#include "log_export/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "core/tick_record_fields.hpp"
#include "flight/columns.hpp"
#include "input/messages.hpp"
#include "text/degrees.hpp"

namespace fantail::log_export {
namespace {

// Signals that stand in the log itself are taken from there: they are there without a replay too.
constexpr std::array<std::string_view, 6> recorded_signals{"time",      "phase",        "command_status",
                                                           "saturated", "timing_fault", "command"};

std::string_view name(protocol::DeviceStatus status) {
  switch (status) {
    case protocol::DeviceStatus::ok: return "ok";
    case protocol::DeviceStatus::error: return "error";
    case protocol::DeviceStatus::no_reading: return "no_reading";
  }
  return "unknown";
}

std::string file_name(std::string_view name, std::string_view unit) {
  if (name == "specific_force_x" && unit == "m_s2") {
    return "specific_force_m_s2";  // the axial one, as in flight.csv
  }
  if (unit.empty()) {
    return std::string{name};
  }
  return fmt::format("{}_{}", name, unit == "rad" ? "deg" : unit == "rad_s" ? "deg_s" : unit);
}

Value value_of(bool value, std::string_view /*unit*/) { return value; }
Value value_of(core::Microseconds value, std::string_view /*unit*/) { return std::int64_t{value.count()}; }
Value value_of(double value, std::string_view unit) {
  if (!std::isfinite(value)) {
    return {};
  }
  return unit == "rad_s" || unit == "rad" ? text::degrees(value) : value;
}
Value value_of(float value, std::string_view unit) { return value_of(static_cast<double>(value), unit); }
Value value_of(core::Angle value, std::string_view unit) { return value_of(value.radians(), unit); }
template <typename T>
  requires std::is_enum_v<T>
Value value_of(T value, std::string_view /*unit*/) {
  return Word{static_cast<std::uint8_t>(value), name(value)};
}
template <typename T>
  requires std::is_integral_v<T>
Value value_of(T value, std::string_view /*unit*/) {
  return static_cast<std::int64_t>(value);
}
template <typename T>
Value value_of(const std::optional<T>& value, std::string_view unit) {
  return value ? value_of(*value, unit) : Value{};
}

FieldType type_of(bool) { return FieldType::flag; }
FieldType type_of(float) { return FieldType::number; }
FieldType type_of(double) { return FieldType::number; }
FieldType type_of(core::Angle) { return FieldType::number; }
FieldType type_of(core::Microseconds) { return FieldType::integer; }
template <typename T>
  requires(std::is_enum_v<T> || std::is_integral_v<T>)
FieldType type_of(T) {
  return std::is_enum_v<T> ? FieldType::word : FieldType::integer;
}

template <typename T>
FieldType type_of(const std::optional<T>&) {
  return type_of(T{});
}

struct Counts {
  std::array<std::string_view, 3> names;
  const std::array<std::int16_t, 3>& values;
};

// Shows everything that the log itself says of a tick, by the names of its schema; and whether a replay leads to it.
template <typename Visitor>
void visit_logged(const flight_log::LoggedTick& logged, double time_s, bool replayed, Visitor&& visit) {
  const protocol::LogTick& tick = logged.tick;
  visit("time", "s", time_s);
  visit("time", "us", tick.time);
  visit("sequence", "", logged.sequence);
  visit("phase", "", tick.phase);
  visit("command_status", "", tick.command_status);
  visit("saturated", "", tick.saturated);
  visit("timing_fault", "", tick.timing_fault);
  visit("command", "rad", tick.command);
  visit("arm_switch_closed", "", tick.arm_switch_closed);
  visit("arm_command", "", tick.arm_command);
  visit("start_command", "", tick.start_command);
  visit("abort", "", tick.abort);
  visit("imu_status", "", tick.imu_status);
  visit("imu_age", "us", tick.time - tick.imu_time);
  visit("accelerometer_status", "", tick.accelerometer_status);
  visit("accelerometer_age", "us", tick.time - tick.accelerometer_time);
  for (const Counts& counts :
       {Counts{{"rate_x", "rate_y", "rate_z"}, tick.rate_counts},
        Counts{{"specific_force_x", "specific_force_y", "specific_force_z"}, tick.specific_force_counts},
        Counts{{"accelerometer_x", "accelerometer_y", "accelerometer_z"}, tick.accelerometer_counts}}) {
    for (std::size_t i = 0; i < counts.values.size(); ++i) {
      visit(counts.names[i], "count", counts.values[i]);
    }
  }
  constexpr std::array<std::string_view, core::canard_count> encoders{"encoder_1", "encoder_2", "encoder_3",
                                                                      "encoder_4"};
  constexpr std::array<std::string_view, core::canard_count> statuses{"encoder_1_status", "encoder_2_status",
                                                                      "encoder_3_status", "encoder_4_status"};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    visit(encoders[i], "count", tick.encoder_counts[i]);
    visit(statuses[i], "", tick.encoder_status[i]);
  }
  const auto of_second = [&tick](auto value_of_second) {
    return tick.second_gyro ? std::optional{value_of_second(*tick.second_gyro)} : std::nullopt;
  };
  using SecondGyro = protocol::LogSecondGyro;
  visit("second_gyro_status", "", of_second([](const SecondGyro& gyro) { return gyro.status; }));
  visit("second_gyro_age", "us", of_second([&tick](const SecondGyro& gyro) { return tick.time - gyro.time; }));
  constexpr std::array<std::string_view, 3> second_rates{"second_rate_x", "second_rate_y", "second_rate_z"};
  for (std::size_t i = 0; i < second_rates.size(); ++i) {
    visit(second_rates[i], "count", of_second([i](const SecondGyro& gyro) { return gyro.rate_counts[i]; }));
  }
  using Pressure = protocol::LogPressure;
  const auto of_pressure = [&tick](auto value_of) {
    return tick.pressure ? std::optional{value_of(*tick.pressure)} : std::nullopt;
  };
  visit("pressure", "pa", of_pressure([](const Pressure& pressure) { return pressure.pressure_pa; }));
  visit("pressure_age", "us", of_pressure([&tick](const Pressure& pressure) { return tick.time - pressure.time; }));
  visit("duration_before", "us", tick.duration_before);
  visit("digest", "", tick.digest);
  visit("replayed", "", replayed);
}

// The rest: `visit` as above, only for signals that are not in the log.
template <typename Visitor>
void visit_replayed(const core::TickRecord& record, Visitor&& visit) {
  core::visit_signals(record, [&visit](const core::SignalName& signal, const auto& value) {
    if (std::ranges::find(recorded_signals, signal.name) == recorded_signals.end()) {
      visit(signal.name, signal.unit, value);
    }
  });
}

std::vector<Field> list_fields() {
  std::vector<Field> list;
  bool replayed = false;
  const auto add = [&](std::string_view signal, std::string_view unit, const auto& value) {
    const std::string name = file_name(signal, unit);
    flight::ColumnText text = flight::column_text(name).value_or(flight::ColumnText{});
    list.push_back({name, type_of(value), text.unit, std::move(text.description), replayed});
  };
  visit_logged({}, 0.0, false, add);
  replayed = true;
  visit_replayed({}, add);
  return list;
}

// 0 to 3 for "command_1" to "command_4".
std::optional<std::size_t> commanded_canard(std::string_view signal) {
  constexpr std::string_view prefix = "command_";
  const bool numbered = signal.size() == prefix.size() + 1 && signal.starts_with(prefix);
  return numbered ? std::optional{static_cast<std::size_t>(signal.back() - '1')} : std::nullopt;
}

}  // namespace

std::span<const Field> fields() {
  static const std::vector<Field> list = list_fields();
  return list;
}

std::optional<std::size_t> find_field(std::string_view name) {
  const auto all = fields();
  const auto found = std::ranges::find(all, name, &Field::name);
  return found == all.end() ? std::nullopt : std::optional{static_cast<std::size_t>(found - all.begin())};
}

std::string unknown_field(std::string_view name) {
  std::vector<std::string> names;
  std::ranges::transform(fields(), std::back_inserter(names), &Field::name);
  const auto meant = input::suggestion(name, names);
  return fmt::format("no field \"{}\"{}; there are: {}", name, meant ? " (did you mean " + *meant + "?)" : "",
                     fmt::join(names, ", "));
}

Selection every_field(const ReplayedFlight& source) {
  Selection all;
  const auto& plan = source.flight().plan;
  const bool has_barometer = plan && plan->sensors.barometer != core::BarometerUse::none;
  for (std::size_t i = 0; i < fields().size(); ++i) {
    const std::string& name = fields()[i].name;
    const bool of_two_gyros = name.starts_with("second_") || name == "gyro_vote";
    const bool of_barometer = name.starts_with("pressure") || name == "barometer_state";
    if ((!of_two_gyros || source.flight().second_rate_scale_rad_s) && (!of_barometer || has_barometer)) {
      all.push_back(i);
    }
  }
  return all;
}

std::span<const Value> TickReader::read(std::size_t tick) {
  values_.clear();
  const flight_log::LoggedTick& logged = source_.flight().ticks[tick];
  const core::TickRecord* record = source_.record(tick);
  visit_logged(
      logged, source_.time_s(logged.tick.time), record != nullptr,
      [this](std::string_view, std::string_view unit, const auto& value) { values_.push_back(value_of(value, unit)); });
  static const core::TickRecord none{};
  visit_replayed(record != nullptr ? *record : none,
                 [&](std::string_view name, std::string_view unit, const auto& value) {
                   if (const auto canard = commanded_canard(name)) {
                     const bool replayed = record != nullptr;
                     const bool driven = replayed && record->canards[*canard].driven;
                     values_.push_back(driven     ? value_of(value, unit)
                                       : replayed ? Value{}
                                                  : value_of(logged.tick.canard_commands[*canard], unit));
                   } else {
                     values_.push_back(record != nullptr ? value_of(value, unit) : Value{});
                   }
                 });
  return values_;
}

}  // namespace fantail::log_export
