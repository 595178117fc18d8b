// SPDX-License-Identifier: MIT
#include "logs/roll_columns.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/core.h>

#include "logs/words.hpp"
#include "sim/input/messages.hpp"
#include "sim/input_error.hpp"

namespace fantail::logs {
namespace {

using sim::InputError;
using sim::InputFault;

struct Known {
  std::string_view name;
  std::vector<double> RollLog::* list;
  bool is_angle = false;
  bool has_truth = false;
  bool Needs::* need = nullptr;
};

constexpr std::array known{
    Known{"time_s", &RollLog::time_s},
    Known{"roll_angle_deg", &RollLog::roll_angle_rad, true, true, &Needs::roll_angle},
    Known{"roll_rate_deg_s", &RollLog::roll_rate_rad_s, true, true, &Needs::roll_rate},
    Known{"canard_deg", &RollLog::canard_rad, true, true, &Needs::canard},
    Known{"speed_m_s", &RollLog::speed_m_s, false, true, &Needs::speed},
    Known{"command_deg", &RollLog::command_rad, true},
    Known{"reference_deg", &RollLog::reference_rad, true},
    Known{"excitation_deg", &RollLog::excitation_rad, true},
    Known{"height_m", &RollLog::height_m, false, true},
    Known{"specific_force_m_s2", &RollLog::specific_force_m_s2},
};
constexpr std::string_view phase_name = "phase";

void refuse_unknown_names(const Reading& reading) {
  std::vector<std::string> names{std::string{phase_name}};
  std::ranges::for_each(known, [&](const Known& column) { names.emplace_back(column.name); });
  for (const auto& [ours, theirs] : reading.columns) {
    if (std::ranges::find(names, ours) != names.end()) {
      continue;
    }
    std::string message = fmt::format("--column {}={}: unknown column {}", ours, theirs, in_quotes(ours));
    if (const auto meant = sim::input::suggestion(ours, names)) {
      message += "; did you mean " + *meant + "?";
    }
    message += " Fantail's columns:";
    std::ranges::for_each(names, [&](const std::string& name) { message += " " + name; });
    throw InputError{InputFault::bad_configuration, message};
  }
}

// What the file itself would call a column in radians.
std::string in_radians(std::string name) {
  const std::size_t unit = name.find("_deg");
  return unit == std::string::npos ? name : name.replace(unit, 4, "_rad");
}

struct Wish {
  std::string name;
  bool by_the_person;
};

Wish wish(std::string_view ours, bool has_truth, bool is_angle, const Table& table, const Reading& reading) {
  if (const auto named = reading.columns.find(std::string{ours}); named != reading.columns.end()) {
    return {named->second, true};
  }
  const std::string name = (reading.truth && has_truth ? "true_" : "") + std::string{ours};
  const bool radians = is_angle && reading.angles == AngleUnit::radians && !table.find(name);
  return {radians && table.find(in_radians(name)) ? in_radians(name) : name, false};
}

[[noreturn]] void refuse_missing(const Table& table, const std::string& name, const Known& column) {
  std::string message = fmt::format("{}: {}; if it is called otherwise: --column {}=NAME", table.name(),
                                    missing_column(name, table.columns()), column.name);
  if (column.need == &Needs::speed) {
    message += "; if nobody measured it: --speed";
  }
  throw InputError{InputFault::bad_data, message};
}

}  // namespace

std::vector<FoundColumn> find_roll_columns(const Table& table, const Reading& reading, const Needs& needs) {
  refuse_unknown_names(reading);
  std::vector<FoundColumn> found;
  for (const Known& column : known) {
    const Wish wanted = wish(column.name, column.has_truth, column.is_angle, table, reading);
    const bool needed = column.list == &RollLog::time_s || (column.need != nullptr && needs.*column.need);
    if (const auto index = table.find(wanted.name)) {
      found.push_back({*index, column.name, column.list, column.is_angle, needed});
    } else if (needed || wanted.by_the_person) {
      refuse_missing(table, wanted.name, column);
    }
  }
  return found;
}

std::optional<std::size_t> find_phase_column(const Table& table, const Reading& reading) {
  const Wish wanted = wish(phase_name, false, false, table, reading);
  return wanted.by_the_person ? table.column(wanted.name) : table.find(wanted.name);
}

}  // namespace fantail::logs
