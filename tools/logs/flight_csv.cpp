// SPDX-License-Identifier: MIT
#include "logs/flight_csv.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "logs/words.hpp"
#include "report/numbers.hpp"
#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"

namespace fantail::logs {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(const std::string& message) { throw sim::InputError{sim::InputFault::bad_data, message}; }

// A column of flight.csv and its place in a row.
struct Known {
  std::string_view name;
  bool is_angle;
  void (*set)(report::Row&, double);
};

template <double report::Row::* member>
void set(report::Row& row, double value) {
  row.*member = value;
}
template <double report::Truth::* member>
void set_truth(report::Row& row, double value) {
  if (!row.truth) {
    row.truth = report::Truth{unknown, unknown, unknown, unknown, unknown, unknown};
  }
  (*row.truth).*member = value;
}
template <std::size_t canard>
void set_command(report::Row& row, double value) {
  row.commands_rad[canard] = value;
}
template <std::size_t canard>
void set_encoder(report::Row& row, double value) {
  row.encoders_rad[canard] = value;
}
void set_canard(report::Row& row, double value) { row.canard_rad = value; }

using report::Row;
using report::Truth;
constexpr std::array<Known, 23> columns{{
    {"roll_angle_deg", true, set<&Row::roll_angle_rad>},
    {"roll_rate_deg_s", true, set<&Row::roll_rate_rad_s>},
    {"reference_deg", true, set<&Row::reference_rad>},
    {"excitation_deg", true, set<&Row::excitation_rad>},
    {"command_deg", true, set<&Row::command_rad>},
    {"command_1_deg", true, set_command<0>},
    {"command_2_deg", true, set_command<1>},
    {"command_3_deg", true, set_command<2>},
    {"command_4_deg", true, set_command<3>},
    {"encoder_1_deg", true, set_encoder<0>},
    {"encoder_2_deg", true, set_encoder<1>},
    {"encoder_3_deg", true, set_encoder<2>},
    {"encoder_4_deg", true, set_encoder<3>},
    {"canard_deg", true, set_canard},
    {"specific_force_m_s2", false, set<&Row::specific_force_m_s2>},
    {"height_m", false, set<&Row::height_m>},
    {"speed_m_s", false, set<&Row::speed_m_s>},
    {"true_roll_angle_deg", true, set_truth<&Truth::roll_angle_rad>},
    {"true_roll_rate_deg_s", true, set_truth<&Truth::roll_rate_rad_s>},
    {"true_canard_deg", true, set_truth<&Truth::canard_rad>},
    {"true_height_m", false, set_truth<&Truth::height_m>},
    {"true_speed_m_s", false, set_truth<&Truth::speed_m_s>},
    {"true_disturbance_deg", true, set_truth<&Truth::disturbance_rad>},
}};

struct Found {
  std::size_t index;
  const Known* column;
};

std::vector<Found> find_columns(const Table& table) {
  std::vector<Found> found;
  for (const Known& column : columns) {
    if (const auto index = table.find(column.name)) {
      found.push_back({*index, &column});
    }
  }
  if (found.empty()) {
    std::string message = fmt::format("{}: none of its columns is one of a flight;", table.name());
    for (const Known& column : columns) {
      message += fmt::format(" {}", column.name);
    }
    refuse(message);
  }
  return found;
}

report::Row empty_row() {
  report::Row row;
  row.roll_angle_rad = row.roll_rate_rad_s = row.reference_rad = row.excitation_rad = row.command_rad = unknown;
  row.specific_force_m_s2 = row.height_m = row.speed_m_s = unknown;
  return row;
}

core::Phase phase_of(const Table& table, std::size_t row, std::size_t column) {
  constexpr std::array all{core::Phase::safe, core::Phase::armed, core::Phase::launched, core::Phase::controlling,
                           core::Phase::finished};
  const std::string_view word = table.cell(row, column);
  const auto* const phase = std::ranges::find(all, word, [](core::Phase one) { return core::name(one); });
  if (phase == all.end()) {
    refuse(fmt::format("{}: phase {}; allowed: safe, armed, launched, controlling, finished", table.where(row),
                       in_quotes(word)));
  }
  return *phase;
}

// What the phases of the rows tell; why they changed stands in no table.
void note_phases(report::Flight& flight) {
  const report::Row* before = nullptr;
  for (const report::Row& row : flight.rows) {
    const bool changed = before == nullptr ? row.phase != core::Phase::safe : row.phase != before->phase;
    if (changed) {
      flight.phase_changes.push_back({row.time_s, row.phase, {}});
    }
    if (changed && before != nullptr) {
      report::Events& e = flight.events;
      if (row.phase == core::Phase::launched) {
        e.detected_s = row.time_s;
      } else if (row.phase == core::Phase::controlling) {
        e.control_start_s = row.time_s;
      } else if (row.phase == core::Phase::finished) {
        e.control_end_s = row.time_s;
      }
    }
    before = &row;
  }
}

}  // namespace

report::Flight read_flight_csv(const Table& table) {
  const std::size_t time = table.column("time_s");
  const std::vector<Found> found = find_columns(table);
  const auto phase = table.find("phase");
  const auto saturated = table.find("saturated");
  report::Flight flight;
  flight.known = {.plan = false, .phase = phase.has_value(), .saturation = saturated.has_value()};
  flight.rows.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    report::Row row = empty_row();
    const auto time_s = table.number(i, time);
    if (!time_s || (!flight.rows.empty() && *time_s <= flight.rows.back().time_s)) {
      refuse(fmt::format("{}: time_s {}{}; allowed: numbers that increase", table.where(i),
                         in_quotes(table.cell(i, time)),
                         flight.rows.empty() ? "" : " after " + sim::input::shown(flight.rows.back().time_s)));
    }
    row.time_s = *time_s;
    for (const Found& one : found) {
      if (const auto value = table.number(i, one.index)) {
        one.column->set(row, one.column->is_angle ? report::radians(*value) : *value);
      }
    }
    if (phase) {
      row.phase = phase_of(table, i, *phase);
    }
    row.saturated = saturated && table.number(i, *saturated).value_or(0.0) != 0.0;
    flight.rows.push_back(row);
  }
  if (flight.rows.empty()) {
    refuse(table.name() + ": no row behind the header");
  }
  if (phase) {
    note_phases(flight);
  }
  return flight;
}

}  // namespace fantail::logs
