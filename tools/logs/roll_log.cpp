// SPDX-License-Identifier: MIT
#include "logs/roll_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "flight/columns.hpp"
#include "input/messages.hpp"
#include "logs/flight_file.hpp"
#include "logs/interpolator.hpp"
#include "report/results.hpp"
#include "text/error.hpp"

namespace fantail::logs {
namespace {

using text::Error;
using text::ErrorKind;

struct Signal {
  std::vector<double> RollLog::* list;
  std::string_view column;  // of flight.csv
};

constexpr std::array signals{
    Signal{&RollLog::time_s, "time_s"},
    Signal{&RollLog::roll_angle_rad, "roll_angle_deg"},
    Signal{&RollLog::roll_rate_rad_s, "roll_rate_deg_s"},
    Signal{&RollLog::canard_rad, "canard_deg"},
    Signal{&RollLog::speed_m_s, "speed_m_s"},
    Signal{&RollLog::command_rad, "command_deg"},
    Signal{&RollLog::reference_rad, "reference_deg"},
    Signal{&RollLog::excitation_rad, "excitation_deg"},
    Signal{&RollLog::offset_estimate_rad, "offset_estimate_deg"},
    Signal{&RollLog::height_m, "height_m"},
    Signal{&RollLog::specific_force_m_s2, "specific_force_m_s2"},
};

// In SI and radians; of the truth, where it is wanted and the column has one.
std::vector<double> values(const std::vector<flight::Row>& rows, std::string_view name, bool of_truth) {
  const flight::Column* column = of_truth ? flight::find_column(fmt::format("true_{}", name)) : nullptr;
  if (column == nullptr) {
    column = flight::find_column(name);
  }
  std::vector<double> list(rows.size());
  std::ranges::transform(rows, list.begin(), column->get);
  if (std::ranges::all_of(list, [](double value) { return std::isnan(value); })) {
    list.clear();
  }
  return list;
}

// Takes whole turns out of a roll angle that is kept between two limits one turn apart, with the roll rate as witness.
// Returns how many jumps there were.
std::size_t continue_over_turns(RollLog& log) {
  constexpr double turn = 2.0 * std::numbers::pi;
  std::vector<double>& angle = log.roll_angle_rad;
  const std::vector<double>& rate = log.roll_rate_rad_s;
  if (angle.empty() || rate.empty() || std::ranges::any_of(angle, [](double a) { return std::isnan(a); })) {
    return 0;
  }
  const auto [low, high] = std::ranges::minmax_element(angle);
  if (*high - *low > 1.01 * turn) {  // an angle that goes on already
    return 0;
  }
  std::size_t jumps = 0;
  double added = 0.0;
  double before = angle[0];
  for (std::size_t i = 1; i < angle.size(); ++i) {
    const double expected = 0.5 * (rate[i - 1] + rate[i]) * (log.time_s[i] - log.time_s[i - 1]);
    const double surprise = angle[i] - before - expected;
    before = angle[i];
    // Behind a long gap the rate is no witness any more, and the model starts anew there.
    if (std::abs(expected) < 0.5 && std::abs(std::abs(surprise) - turn) < 1.0) {
      added -= std::copysign(turn, surprise);
      ++jumps;
    }
    angle[i] += added;
  }
  return jumps;
}

void refuse_what_only_a_table_has(const std::string& file, const Reading& reading) {
  const char* const why = reading.truth                          ? "it contains only measurements, not true values"
                          : !reading.columns.empty()             ? "its column names are fixed"
                          : reading.angles != AngleUnit::degrees ? "its angle unit is fixed"
                                                                 : nullptr;
  if (why != nullptr) {
    throw Error{ErrorKind::bad_configuration, fmt::format("{}: this is a flight log: {}", file, why)};
  }
}

/// Is there a column for the roll angle, or one that is likely meant to be it? An angle under a misspelt name must not
/// be replaced without a question.
bool may_have_roll_angle(const flight::Table& table, const Reading& reading) {
  if (files::find(reading.columns, files::Quantity::roll_angle) != nullptr) {
    return true;
  }
  std::vector<std::string> unclaimed;
  for (const std::string& name : table.columns()) {
    if (std::ranges::none_of(reading.columns, [&](const auto& mapped) { return mapped.column == name; })) {
      unclaimed.push_back(name);
    }
  }
  return input::suggestion("roll_angle_deg", unclaimed).has_value();
}

/// Makes the roll angle the integral of the roll rate, zero at the first sample, and adds a warning that says so.
void integrate_roll_rate(RollLog& log, const Reading& reading) {
  const double longest_gap_s = std::max(0.1, 5.0 * usual_interval_s(log.time_s));
  std::size_t gaps = 0;
  log.roll_angle_rad.assign(log.time_s.size(), 0.0);
  for (std::size_t i = 1; i < log.time_s.size(); ++i) {
    const double step_s = log.time_s[i] - log.time_s[i - 1];
    gaps += step_s > longest_gap_s ? 1 : 0;
    log.roll_angle_rad[i] =
        log.roll_angle_rad[i - 1] + 0.5 * (log.roll_rate_rad_s[i - 1] + log.roll_rate_rad_s[i]) * step_s;
  }
  std::string sentence =
      "The log has no roll angle. The roll rate is integrated from zero at the first sample, so the angle drifts "
      "with the gyro's offset";
  if (gaps > 0) {
    sentence += fmt::format("; over {} of more than {} s the rate is interpolated",
                            gaps == 1 ? "a gap" : fmt::format("{} gaps", gaps), input::about(longest_gap_s));
  }
  if (!reading.options.empty()) {
    sentence += fmt::format(". If a column has the roll angle, give {}columns roll_angle=COLUMN:UNIT", reading.options);
  }
  log.warnings.push_back(sentence + ".");
}

}  // namespace

RollLog roll_log(const flight::Flight& flight, std::string name, const Reading& reading) {
  RollLog log;
  log.name = std::move(name);
  log.vehicle = flight.vehicle;
  if (flight.rows.size() < 2) {
    throw Error{ErrorKind::bad_data, log.name + ": fewer than two rows with numbers"};
  }
  for (const Signal& signal : signals) {
    log.*signal.list = values(flight.rows, signal.column, reading.truth);
  }
  log.estimated_speed_m_s = values(flight.rows, "speed_m_s", false);
  if (flight.known.phase) {
    log.phase.resize(flight.rows.size());
    std::ranges::transform(flight.rows, log.phase.begin(), &flight::Row::phase);
  }
  log.burnout_s = flight.events.burnout_s;
  log.apogee_s = flight.events.apogee_s;
  log.speed_bound_from_s = flight.unmeasured.speed_bound_from_s;
  log.warnings = flight.notes;
  note_doubtful_units(log, reading);
  if (const std::size_t turns = continue_over_turns(log); turns > 0) {
    log.warnings.push_back(fmt::format("the roll angle jumps by a whole turn {} {}; the jumps are removed", turns,
                                       turns == 1 ? "time" : "times"));
  }
  note_doubtful_motion(log);
  return log;
}

RollLog read_roll_log(const std::filesystem::path& path, const Reading& reading, const Needs& needs) {
  const std::filesystem::path file = flight_file(path);
  if (is_flight_log(file)) {
    refuse_what_only_a_table_has(file.string(), reading);
    if (file != path) {
      expect_one_flight(path, nullptr);
    }
    return roll_log(read_flight_log(file), file.string(), reading);
  }
  Reading mapped = reading;
  const std::string said = follow_kept_sources(file, mapped);
  const files::Loaded table = files::load(file, files::Beside::ftl);
  Needs present = needs;
  present.roll_angle = needs.roll_angle && (!needs.roll_rate || may_have_roll_angle(table.table, mapped));
  flight::Flight flight = read_flight_csv(table, mapped, present);
  if (!said.empty()) {
    flight.notes.insert(flight.notes.begin(), said);
  }
  if (file != path) {
    expect_one_flight(path, &flight);
    const flight::Events events = report::summary_events(path / "summary.json");
    flight.events.burnout_s = events.burnout_s;
    flight.events.apogee_s = events.apogee_s;
    flight.unmeasured = report::summary_unmeasured(path / "summary.json");
  } else {
    expect_rows_of_log_beside(flight, path);
  }
  RollLog log = roll_log(flight, path.string(), mapped);
  if (needs.roll_angle && !present.roll_angle) {
    integrate_roll_rate(log, mapped);
  }
  return log;
}

}  // namespace fantail::logs
