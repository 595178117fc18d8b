// SPDX-License-Identifier: MIT
#include "playground/flown.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "flight/flight.hpp"
#include "fly/fly_scenario.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "playground/shipped_texts.hpp"
#include "report/answer.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "sim/scenario.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::playground {
namespace {

constexpr std::size_t most_rows = 6000;      // a plot is hardly wider than a thousand pixels
constexpr std::size_t longest_words = 4000;  // of all settings together
constexpr double longest_launch_s = 300.0;   // which keeps every tick
constexpr double longest_run_s = 1500.0;     // in the tunnel; shipped ones are under control for up to 600 s
constexpr std::string_view faults_prefix = "faults.";

[[noreturn]] void refuse(const std::string& sentence) {
  throw text::Error{text::ErrorKind::bad_configuration, sentence};
}

/// What a page asks for.
struct Wish {
  std::string scenario;
  std::vector<std::string> settings{};  ///< of plan, vehicle and scenario
  std::string fault{};                  ///< as the section of a scenario; empty: none
  std::optional<std::uint64_t> seed{};
};

Wish wish_of(std::string_view words) {
  if (words.size() > longest_words) {
    refuse("the settings are longer than " + std::to_string(longest_words) + " characters");
  }
  Wish wish{.scenario = std::string{words.substr(0, words.find('\n'))}};
  std::string_view rest = words.substr(std::min(words.size(), wish.scenario.size() + 1));
  while (!rest.empty()) {
    const std::string line{rest.substr(0, rest.find('\n'))};
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (line.starts_with("seed=")) {
      wish.seed = text::whole_number(std::string_view{line}.substr(5));
      if (!wish.seed) {
        refuse(line + ": not a seed; allowed: a whole number, 0 to 18446744073709551615");
      }
    } else if (line.starts_with(faults_prefix)) {
      wish.fault += (wish.fault.empty() ? "\n[[faults]]\n" : "") + line.substr(faults_prefix.size()) + '\n';
    } else {
      wish.settings.push_back(line);
    }
  }
  return wish;
}

sim::Scenario scenario_of(const Wish& wish) {
  append_to_scenarios(wish.fault);
  const std::vector<input::Override> changes = input::parse_overrides(wish.settings);
  sim::Scenario scenario = input::load_scenario(wish.scenario, changes);
  scenario.changed_values = changes.size() + (wish.seed ? 1 : 0);
  scenario.seed = wish.seed.value_or(scenario.seed);
  return scenario;
}

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

float degrees(std::optional<double> radians) { return radians ? static_cast<float>(text::degrees(*radians)) : nothing; }

struct Column {
  std::string_view name;
  float (*value)(const flight::Row& row, const flight::Flight& flight);
};

std::optional<double> of_truth(const flight::Row& row, double flight::Truth::* member) {
  return row.truth ? std::optional{(*row.truth).*member} : std::nullopt;
}

constexpr std::array columns{
    Column{"time_s", [](const flight::Row& r, const flight::Flight&) { return static_cast<float>(r.time_s); }},
    Column{"roll_deg", [](const flight::Row& r, const flight::Flight&) { return degrees(r.roll_angle_rad); }},
    Column{"true_roll_deg", [](const flight::Row& r,
                               const flight::Flight&) { return degrees(of_truth(r, &flight::Truth::roll_angle_rad)); }},
    Column{"reference_deg",
           [](const flight::Row& r, const flight::Flight&) {
             return r.phase == core::Phase::controlling ? degrees(r.reference_rad) : nothing;
           }},
    Column{"settle_deg",
           [](const flight::Row& r, const flight::Flight& f) {
             return r.phase == core::Phase::controlling ? degrees(flight::settle_point_rad(r, f)) : nothing;
           }},
    Column{"rate_deg_s", [](const flight::Row& r, const flight::Flight&) { return degrees(r.roll_rate_rad_s); }},
    Column{"command_deg", [](const flight::Row& r, const flight::Flight&) { return degrees(r.command_rad); }},
    Column{"canard_deg", [](const flight::Row& r, const flight::Flight&) { return degrees(r.canard_rad); }},
    Column{"height_m",
           [](const flight::Row& r, const flight::Flight&) {
             return static_cast<float>(r.truth ? r.truth->height_m : r.height_m);
           }},
    Column{"speed_m_s",
           [](const flight::Row& r, const flight::Flight&) {
             return static_cast<float>(r.truth ? r.truth->speed_m_s : r.speed_m_s);
           }},
};

void take_rows(const flight::Flight& flight, Flown& flown) {
  const std::size_t step = (flight.rows.size() + most_rows - 1) / most_rows;
  flown.rows = step == 0 ? 0 : (flight.rows.size() + step - 1) / step;
  flown.columns.reserve(columns.size() * flown.rows);
  for (const Column& column : columns) {
    for (std::size_t i = 0; i < flight.rows.size(); i += step) {
      flown.columns.push_back(column.value(flight.rows[i], flight));
    }
  }
}

fly::Look ends_what_takes_too_long(const sim::Scenario& scenario) {
  const bool is_launch = scenario.surroundings == sim::Surroundings::flight;
  return [longest_s = is_launch ? longest_launch_s : longest_run_s](double simulated_s) {
    if (simulated_s > longest_s) {
      refuse("a page can fly this scenario for at most " + text::brief(longest_s, 0) +
             " s from power-up; these settings take longer");
    }
  };
}

}  // namespace

std::string_view column_names() {
  static const std::string names = [] {
    std::string all;
    for (const Column& column : columns) {
      all += (all.empty() ? "" : " ") + std::string{column.name};
    }
    return all;
  }();
  return names;
}

Flown fly(std::string_view words) {
  const Wish wish = wish_of(words);
  const sim::Scenario scenario = scenario_of(wish);
  const fly::Look look = ends_what_takes_too_long(scenario);
  flight::Flight flight = fly::fly_scenario(scenario, look, {}, fly::Log::kept);
  flight.without_control = fly::roll_without_control(scenario, flight, look);
  flight.changes = wish.settings;
  if (wish.seed) {
    flight.changes.push_back("seed=" + std::to_string(*wish.seed));
  }
  const report::Figures figures = report::figures(flight);
  Flown flown{.summary = result::json(report::summary(flight, figures, report::verdict(flight, figures)))};
  take_rows(flight, flown);
  return flown;
}

}  // namespace fantail::playground
