// SPDX-License-Identifier: MIT
#include "identify/model/open_loop.hpp"

#include <cmath>

#include "identify/model/alpha_fit.hpp"
#include "identify/model/least_squares.hpp"

namespace fantail::identify::model {
namespace {

using Eigen::Index;

void add_starts(RollModel& model, const Record& record) {
  if (model.initial.empty()) {
    model.initial = measured_starts(record);
  }
}

}  // namespace

Simulation simulate_open_loop(const Record& record, const Airframe& airframe, const RollModel& model) {
  const std::vector<RollEquation> equation = roll_equations(record, airframe);
  const auto acceleration = [&](std::size_t i) {
    return equation[i].acceleration_rad_s2(model.beta_m,
                                           record.canard_rad[i] + model.disturbance_rad(record.time_s[i]));
  };
  Simulation result;
  result.canard_rad = record.canard_rad;
  std::size_t segment = 0;
  InitialState state{};
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (segment < record.segment_begin.size() && i == record.segment_begin[segment]) {
      state = model.initial[segment];
      ++segment;
    } else {
      const double damping_per_m2_s = 0.5 * (equation[i - 1].damping_per_m2_s + equation[i].damping_per_m2_s);
      const RampStep step =
          ramp_step(model.alpha_m2 * damping_per_m2_s, step_s(record.time_s[i - 1], record.time_s[i]));
      const double before = acceleration(i - 1);
      const double now = acceleration(i);
      state.angle_rad += step.angle_change(state.rate_rad_s, before, now);
      state.rate_rad_s = step.rate_after(state.rate_rad_s, before, now);
    }
    result.roll_angle_rad.push_back(state.angle_rad);
    result.roll_rate_rad_s.push_back(state.rate_rad_s);
  }
  result.compare_with(record);
  return result;
}

GridResult search_open_loop_grid(const Record& record, const Airframe& airframe, const NodeTimes& nodes, Start start,
                                 const Grid& grid) {
  const ResponseBasis basis{record, airframe, nodes, start};
  GridResult result;
  ErrorMap& errors = result.errors;
  errors.alpha_m2 = grid.alpha_m2.values();
  errors.beta_m = grid.beta_m.values();
  const std::size_t width = errors.alpha_m2.size();
  errors.mean_abs_angle_error_rad.resize(width * errors.beta_m.size());
  std::size_t best = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const AlphaFit fit{basis, errors.alpha_m2[i]};
    const std::vector<double> along_beta = fit.mean_abs_error_rad(grid.beta_m);
    for (std::size_t j = 0; j < errors.beta_m.size(); ++j) {
      const std::size_t cell = j * width + i;
      errors.mean_abs_angle_error_rad[cell] = along_beta[j];
      if (errors.mean_abs_angle_error_rad[cell] < errors.mean_abs_angle_error_rad[best]) {
        best = cell;
      }
    }
  }
  // A grid that is not empty has a width. NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
  result.model = AlphaFit{basis, errors.alpha_m2[best % width]}.model(errors.beta_m[best / width], nodes);
  add_starts(result.model, record);
  return result;
}

RollModel fit_open_loop(const Record& record, const Airframe& airframe, const NodeTimes& nodes, Start start,
                        const Grid& grid) {
  const ResponseBasis basis{record, airframe, nodes, start};
  const AlphaRange range = alpha_range(airframe);
  const double log_alpha =
      least_over([&basis](double x) { return AlphaFit{basis, std::exp(x)}.least_squares_rad2(); },
                 {.low = std::log(range.lowest_m2), .high = std::log(range.highest_m2)}, /*places=*/12);
  const AlphaFit fit{basis, std::exp(log_alpha)};
  RollModel model = fit.model(fit.best_beta_m().value_or(0.5 * (grid.beta_m.first + grid.beta_m.last)), nodes);
  add_starts(model, record);
  return model;
}

RollModel fit_open_loop_with(double alpha_m2, double beta_m, const Record& record, const Airframe& airframe,
                             const NodeTimes& nodes, Start start) {
  RollModel model = AlphaFit{ResponseBasis{record, airframe, nodes, start}, alpha_m2}.model(beta_m, nodes);
  add_starts(model, record);
  return model;
}

Sensitivities open_loop_sensitivities(const Record& record, const Airframe& airframe, const RollModel& model) {
  const ResponseBasis basis{record, airframe, model.node_time_s, Start::fitted};
  const auto nodes = static_cast<Index>(basis.nodes());
  const auto segments = static_cast<Index>(record.segment_begin.size());
  const auto canard = static_cast<Index>(basis.canard_column());

  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(static_cast<Index>(basis.columns()));
  for (Index k = 0; k < nodes; ++k) {
    coefficients(k) = model.beta_m * model.node_rad[static_cast<std::size_t>(k)];
  }
  for (Index s = 0; s < segments; ++s) {
    coefficients(nodes + 2 * s) = model.initial[static_cast<std::size_t>(s)].angle_rad;
    coefficients(nodes + 2 * s + 1) = model.initial[static_cast<std::size_t>(s)].rate_rad_s;
  }
  coefficients(canard) = model.beta_m;

  Sensitivities result;
  const auto samples = static_cast<Index>(basis.samples());
  result.numbers.resize(samples, 2 + nodes);
  Eigen::MatrixXd angles;
  const double step_m2 = 1e-4 * model.alpha_m2;
  basis.respond(model.alpha_m2 + step_m2, angles);
  result.numbers.col(0) = angles * coefficients;
  basis.respond(model.alpha_m2 - step_m2, angles);
  result.numbers.col(0) -= angles * coefficients;
  result.numbers.col(0) /= 2.0 * step_m2;

  basis.respond(model.alpha_m2, angles);
  result.numbers.col(1) = angles.col(canard) + angles.leftCols(nodes) * coefficients.head(nodes) / model.beta_m;
  result.numbers.rightCols(nodes) = model.beta_m * angles.leftCols(nodes);
  result.start_angle.resize(samples, segments);
  result.start_rate.resize(samples, segments);
  for (Index s = 0; s < segments; ++s) {
    result.start_angle.col(s) = angles.col(nodes + 2 * s);
    result.start_rate.col(s) = angles.col(nodes + 2 * s + 1);
  }
  result.lag =
      model.beta_m * angles.middleCols(static_cast<Index>(basis.lag_column()), static_cast<Index>(basis.lag_columns()));
  return result;
}

}  // namespace fantail::identify::model
