// SPDX-License-Identifier: MIT
#include "tunnel/steps.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/error.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/steady.hpp"

namespace fantail::tunnel {
namespace {

using text::degrees;

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

template <typename Value>
Spread spread(const std::vector<StepResult>& steps, Value value) {
  std::vector<double> values;
  values.reserve(steps.size());
  for (const StepResult& step : steps) {
    values.push_back(value(step.identified));
  }
  const Moments m = moments(values);
  const auto count = static_cast<double>(values.size());
  return {.mean = m.mean, .deviation = count > 1.0 ? m.standard_deviation * std::sqrt(count / (count - 1.0)) : 0.0};
}

void summarise(StepTable& table) {
  using identify::result::Identification;
  const std::vector<StepResult>& steps = table.steps;
  table.alpha_m2 = spread(steps, [](const Identification& i) { return i.model.alpha_m2; });
  table.beta_m = spread(steps, [](const Identification& i) { return i.model.beta_m; });
  table.disturbance_begin_rad = spread(steps, [](const Identification& i) { return i.model.node_rad.front(); });
  table.disturbance_end_rad = spread(steps, [](const Identification& i) { return i.model.node_rad.back(); });
  table.mean_abs_angle_error_rad =
      spread(steps, [](const Identification& i) { return i.simulation.mean_abs_angle_error_rad; });
  table.mean_abs_rate_error_rad_s =
      spread(steps, [](const Identification& i) { return i.simulation.mean_abs_rate_error_rad_s; });
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

}  // namespace

std::vector<ReferenceStep> find_reference_steps(const logs::RollLog& log) {
  if (log.reference_rad.empty()) {
    throw text::Error{text::ErrorKind::bad_data,
                      log.name + ": no column reference_deg; a run is cut at the changes of the reference"};
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
                      log.name + ": reference_deg never changes under control; there is no step to cut out"};
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
        fmt::format("{}: no wind speed between {:g} and {:g} s, where the steps are", wind.name, begin_s, end_s)};
  }
  const auto [slowest, fastest] = std::ranges::minmax(std::span{wind.fan_rpm}.subspan(first, count));
  if (fastest - slowest > SteadyOptions{}.rpm_tolerance) {
    throw text::Error{text::ErrorKind::bad_data,
                      fmt::format("{}: the fan goes from {:g} to {:g} rpm during the steps, which need one speed",
                                  wind.name, slowest, fastest)};
  }
  return moments(std::span{wind.wind_speed_m_s}.subspan(first, count)).mean;
}

std::string steps_csv(const StepTable& table) {
  std::string text =
      "step,begin_s,alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,mean_abs_angle_error_deg,"
      "mean_abs_rate_error_deg_s\n";
  for (const StepResult& result : table.steps) {
    const identify::model::RollModel& model = result.identified.model;
    const identify::model::Simulation& simulation = result.identified.simulation;
    text += fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", result.number, result.step.begin_s,
                        model.alpha_m2, model.beta_m, degrees(model.node_rad.front()), degrees(model.node_rad.back()),
                        degrees(simulation.mean_abs_angle_error_rad), degrees(simulation.mean_abs_rate_error_rad_s));
  }
  return text;
}

}  // namespace fantail::tunnel
