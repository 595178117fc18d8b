// SPDX-License-Identifier: MIT
#include "tunnel/steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/error.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/steady.hpp"

namespace fantail::tunnel {
namespace {

bool wanted(const ReferenceStep& step, Direction direction) {
  return direction == Direction::both || (direction == Direction::up) == (step.to_rad > step.from_rad);
}

StepResult identify_step(const logs::RollLog& log, const identify::model::Airframe& airframe,
                         const StepOptions& options, const ReferenceStep& step, std::size_t number) {
  const std::string name = fmt::format("step {}", number);
  StepResult result{.number = number, .step = step};
  try {
    result.record = identify::make_record(
        log, {.from_s = step.begin_s, .to_s = std::min(step.end_s, step.begin_s + options.seconds), .name = name},
        options.record);
    result.identified = identify::identify(
        result.record, airframe,
        {.nodes = identify::EvenNodes{options.intervals}, .method = options.method, .with_error_map = false});
  } catch (const text::Error& error) {
    throw text::Error{error.kind(), fmt::format("{} (at {:g} s): {}", name, step.begin_s, error.what())};
  }
  return result;
}

constexpr std::array columns{
    StepColumn{"alpha_m2", "\u03b1 / m\u00b2", &StepFigures::alpha_m2, false},
    StepColumn{"beta_m", "\u03b2 / m", &StepFigures::beta_m, false},
    StepColumn{"disturbance_begin_deg", "begin / deg", &StepFigures::disturbance_begin_rad, true},
    StepColumn{"disturbance_end_deg", "end / deg", &StepFigures::disturbance_end_rad, true},
    StepColumn{"mean_abs_angle_error_deg", "angle error / deg", &StepFigures::mean_abs_angle_error_rad, true},
    StepColumn{"mean_abs_rate_error_deg_s", "rate error / deg/s", &StepFigures::mean_abs_rate_error_rad_s, true},
};

void summarise(StepTable& table) {
  const auto count = static_cast<double>(table.steps.size());
  for (const StepColumn& column : columns) {
    std::vector<double> values;
    values.reserve(table.steps.size());
    for (const StepResult& step : table.steps) {
      values.push_back(figures_of(step).*column.figure);
    }
    const Moments m = moments(values);
    table.mean.*column.figure = m.mean;
    table.standard_deviation.*column.figure =
        count > 1.0 ? m.standard_deviation * std::sqrt(count / (count - 1.0)) : 0.0;
  }
}

void remark_on(const StepResult& result, const StepOptions& options, StepTable& table) {
  if (result.step.end_s - result.step.begin_s < options.seconds - 0.1) {
    table.remarks.push_back(
        fmt::format("Step {} lasts only {:.2f} s.", result.number, result.step.end_s - result.step.begin_s));
  }
  for (const std::string& remark : result.identified.remarks) {
    table.remarks.push_back(fmt::format("Step {}: {}", result.number, remark));
  }
  if (result.identified.uncertainty && !result.identified.uncertainty->alpha_identifiable) {
    table.remarks.push_back(fmt::format("Step {}: {}", result.number, result.identified.uncertainty->verdict));
  }
}

/// In quotes where a table would take it for several cells.
std::string in_csv(const std::string& text) {
  if (text.find_first_of(",\"\n\r#") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  }
  return quoted + '"';
}

}  // namespace

StepFigures figures_of(const StepResult& result) {
  const auto& [model, simulation] = std::tie(result.identified.model, result.identified.simulation);
  return {.alpha_m2 = model.alpha_m2,
          .beta_m = model.beta_m,
          .disturbance_begin_rad = model.node_rad.front(),
          .disturbance_end_rad = model.node_rad.back(),
          .mean_abs_angle_error_rad = simulation.mean_abs_angle_error_rad,
          .mean_abs_rate_error_rad_s = simulation.mean_abs_rate_error_rad_s};
}

double StepColumn::printed(const StepFigures& figures) const {
  return is_angle ? text::degrees(figures.*figure) : figures.*figure;
}

std::span<const StepColumn> step_columns() { return columns; }

std::vector<ReferenceStep> find_reference_steps(const logs::RollLog& log) {
  if (log.reference_rad.empty()) {
    throw text::Error{text::ErrorKind::bad_data,
                      log.name + ": no column reference_deg; a run is split at the changes of the reference"};
  }
  constexpr double same_rad = 1e-6;
  std::vector<ReferenceStep> steps;
  const auto in_control = [&log](std::size_t i) {
    return log.phase.empty() || log.phase[i] == core::Phase::controlling;
  };
  for (std::size_t i = 1; i < log.time_s.size() && (steps.empty() || in_control(i)); ++i) {
    if (in_control(i) && std::abs(log.reference_rad[i] - log.reference_rad[i - 1]) > same_rad) {
      steps.push_back({.begin_s = log.time_s[i],
                       .end_s = log.time_s[i],
                       .from_rad = log.reference_rad[i - 1],
                       .to_rad = log.reference_rad[i]});
    } else if (!steps.empty()) {
      steps.back().end_s = log.time_s[i];
    }
  }
  if (steps.empty()) {
    throw text::Error{text::ErrorKind::bad_data,
                      log.name + ": reference_deg never changes under control, so there are no steps"};
  }
  return steps;
}

StepTable identify_steps(const logs::RollLog& log, const identify::model::Airframe& airframe,
                         const StepOptions& options) {
  StepTable table;
  const std::vector<ReferenceStep> all = find_reference_steps(log);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (wanted(all[i], options.direction)) {
      table.steps.push_back(identify_step(log, airframe, options, all[i], i + 1));
      remark_on(table.steps.back(), options, table);
    }
  }
  if (table.steps.empty()) {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: none of the {} steps goes {}", log.name, all.size(),
                                                             options.direction == Direction::up ? "up" : "down")};
  }
  summarise(table);
  table.remarks.insert(table.remarks.end(), log.warnings.begin(), log.warnings.end());
  return table;
}

double mean_wind_speed_m_s(const TunnelLog& wind, const std::vector<ReferenceStep>& steps) {
  const double begin_s = steps.front().begin_s;
  const double end_s = steps.back().end_s;
  const auto index = [&wind](double time_s) {
    return static_cast<std::size_t>(std::ranges::lower_bound(wind.time_s, time_s) - wind.time_s.begin());
  };
  const std::size_t first = index(begin_s);
  const std::size_t count = index(end_s) - first;
  if (count == 0) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: no wind speed between {:g} and {:g} s, the time of the steps", wind.name, begin_s, end_s)};
  }
  const auto [slowest, fastest] = std::ranges::minmax(std::span{wind.fan_rpm}.subspan(first, count));
  if (fastest - slowest > SteadyOptions{}.rpm_tolerance) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}: the fan changes from {:g} to {:g} rpm during the steps; they need a constant wind speed",
                    wind.name, slowest, fastest)};
  }
  return moments(std::span{wind.wind_speed_m_s}.subspan(first, count)).mean;
}

StepSpeed speed_of_steps(const logs::RollLog& roll, const std::filesystem::path& roll_path, const SpeedChoice& choice) {
  if (choice.speed_m_s) {
    return {choice.speed_m_s, "from the command line"};
  }
  if (const auto wind = find_tunnel_log(roll, roll_path, choice.wind, choice.truth, "give --speed or --wind")) {
    return {mean_wind_speed_m_s(*wind, find_reference_steps(roll)), "mean of " + wind->name};
  }
  return {std::nullopt, "of the log"};
}

std::string steps_csv(const StepsHeading& heading, const StepTable& table) {
  const std::string whose = fmt::format(",{},{}", in_csv(heading.vehicle), heading.airframe.reference_area_m2);
  std::string text = "step,begin_s";
  for (const StepColumn& column : columns) {
    text += fmt::format(",{}", column.name);
  }
  text += ",vehicle,reference_area_m2";
  for (const StepResult& result : table.steps) {
    text += fmt::format("\n{},{:.6f}", result.number, result.step.begin_s);
    for (const StepColumn& column : columns) {
      text += fmt::format(",{:.6f}", column.printed(figures_of(result)));
    }
    text += whose;
  }
  return text + "\n";
}

}  // namespace fantail::tunnel
