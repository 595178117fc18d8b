// SPDX-License-Identifier: MIT
#include "tunnel/steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/quoting.hpp"
#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

bool wanted(const ReferenceStep& step, Direction direction) {
  return direction == Direction::both || (direction == Direction::up) == (step.to_rad > step.from_rad);
}

StepResult identify_step(const logs::RollLog& log, const identify::model::Airframe& airframe,
                         const StepOptions& options, const ReferenceStep& step, std::size_t number) {
  StepResult result{.number = number, .step = step};
  result.record = identify::make_record(log,
                                        {.from_s = step.begin_s,
                                         .to_s = std::min(step.end_s, step.begin_s + options.seconds),
                                         .name = fmt::format("step {}", number)},
                                        options.record);
  result.identified = identify::identify(result.record, airframe,
                                         {.nodes = identify::EvenNodes{options.intervals},
                                          .method = options.method,
                                          .start = options.start,
                                          .with_error_map = false});
  return result;
}

// Numbers that the step does not tell would move the mean and widen the spread by whatever they happen to be.
std::string why_useless(const StepResult& result) {
  const auto& known = result.identified.uncertainty;
  return known && !(known->alpha_identifiable && known->beta_identifiable) ? known->verdict : std::string{};
}

/// As step_fields has them.
constexpr std::array members{&StepFigures::alpha_m2,
                             &StepFigures::beta_m,
                             &StepFigures::disturbance_begin_rad,
                             &StepFigures::disturbance_end_rad,
                             &StepFigures::mean_abs_angle_error_rad,
                             &StepFigures::mean_abs_rate_error_rad_s};

std::vector<double> values(const StepTable& table, double StepFigures::* figure,
                           StepFigures (*of)(const StepResult& result)) {
  std::vector<double> all(table.steps.size());
  std::ranges::transform(table.steps, all.begin(), [=](const StepResult& step) { return of(step).*figure; });
  return all;
}

void summarise(StepTable& table) {
  if (table.steps.size() > 1) {
    table.standard_deviation.emplace();
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::vector<double> found = values(table, members[i], figures_of);
    table.mean.*members[i] = mean(found);
    if (!table.standard_deviation) {
      continue;
    }
    (*table.standard_deviation).*members[i] = moments(found).standard_deviation;
    if (i < step_estimates) {
      table.spreads.push_back({i, between_values(found, values(table, members[i], standard_errors_of))});
    }
  }
}

// A launch is split at its steps as readily.
std::string remark_on_speed(const StepResult& result) {
  constexpr double steady_share = 0.2;
  const std::vector<double>& speed_m_s = result.record.speed_m_s;
  const auto [least, most] = std::ranges::minmax(speed_m_s);
  if (most - least <= steady_share * most) {
    return {};
  }
  return fmt::format(
      "Step {}: the speed changes from {:.0f} to {:.0f} m/s, so the wind was not steady, and one density does not "
      "fit all heights. For a flight use fantail identify.",
      result.number, speed_m_s.front(), speed_m_s.back());
}

void remark_on(const StepResult& result, const StepOptions& options, StepTable& table) {
  if (result.step.end_s - result.step.begin_s < options.seconds - 0.1) {
    table.remarks.push_back(
        fmt::format("Step {} lasts only {:.2f} s.", result.number, result.step.end_s - result.step.begin_s));
  }
  if (const std::string remark = remark_on_speed(result); !remark.empty()) {
    table.remarks.push_back(remark);
  }
  for (const std::string& remark : result.identified.remarks) {
    table.remarks.push_back(fmt::format("Step {}: {}", result.number, remark));
  }
}

std::string place(const ReferenceStep& step, std::size_t number) {
  return fmt::format("step {} (at {:g} s, {:.2f} s long)", number, step.begin_s, step.end_s - step.begin_s);
}

[[noreturn]] void refuse_without_steps(const logs::RollLog& log, const StepOptions& options, std::size_t steps,
                                       const std::vector<std::string>& left_out) {
  const std::string why =
      left_out.empty()
          ? fmt::format("none of its {} steps goes {}", steps, options.direction == Direction::up ? "up" : "down")
          : fmt::format("none of its steps determines a roll model; left out: {}", left_out.front());
  throw text::Error{text::ErrorKind::bad_data, log.name + ": " + why};
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

StepFigures standard_errors_of(const StepResult& result) {
  const std::vector<double>& known = result.identified.uncertainty.value().standard_deviation;
  constexpr std::size_t first_node = 2;
  return {.alpha_m2 = known[0],
          .beta_m = known[1],
          .disturbance_begin_rad = known[first_node],
          .disturbance_end_rad = known.back()};
}

result::Column step_column(const StepTable& table, std::size_t figure) {
  result::Column column = result::column(step_fields[figure]);
  const bool is_area_or_length = column.unit.symbol == "m2" || column.unit.symbol == "m";
  column.decimals = is_area_or_length && std::abs(table.mean.*members[figure]) < 1.0 ? 5 : column.decimals;
  return column;
}

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
                         const StepOptions& options, const StepProgress& progress) {
  StepTable table;
  const std::vector<ReferenceStep> all = find_reference_steps(log);
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (progress) {
      progress(i, all.size());
    }
    if (!wanted(all[i], options.direction)) {
      continue;
    }
    std::string why;
    try {
      StepResult result = identify_step(log, airframe, options, all[i], i + 1);
      why = why_useless(result);
      if (why.empty()) {
        table.steps.push_back(std::move(result));
        remark_on(table.steps.back(), options, table);
      }
    } catch (const text::Error& error) {
      why = error.what();
    }
    if (!why.empty()) {
      left_out.push_back(fmt::format("{}: {}", place(all[i], i + 1), why));
      table.remarks.push_back(fmt::format("Left out: {}.", left_out.back()));
    }
  }
  if (table.steps.empty()) {
    refuse_without_steps(log, options, all.size(), left_out);
  }
  summarise(table);
  table.remarks.insert(table.remarks.end(), log.warnings.begin(), log.warnings.end());
  return table;
}

}  // namespace fantail::tunnel
