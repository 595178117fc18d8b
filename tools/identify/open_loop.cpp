// SPDX-License-Identifier: MIT
#include "identify/open_loop.hpp"

#include <cmath>

#include "identify/alpha_fit.hpp"
#include "identify/minimum.hpp"
#include "identify/node_times.hpp"
#include "identify/ramp_transition.hpp"
#include "identify/response_basis.hpp"
#include "identify/simulation_errors.hpp"

namespace fantail::identify {
namespace {

void add_starts(Model& model, const Record& record) {
  if (model.initial.empty()) {
    model.initial = measured_starts(record);
  }
}

double disturbance_rad(const Model& model, double time_s) {
  const NodeShare share = node_share(model.node_time_s, time_s);
  return model.node_rad[share.left] + share.right_share * (model.node_rad[share.right] - model.node_rad[share.left]);
}

}  // namespace

std::vector<InitialState> measured_starts(const Record& record) {
  std::vector<InitialState> starts;
  starts.reserve(record.segment_begin.size());
  for (const std::size_t at : record.segment_begin) {
    starts.push_back({.angle_rad = record.roll_angle_rad[at], .rate_rad_s = record.roll_rate_rad_s[at]});
  }
  return starts;
}

Simulation simulate_open_loop(const Record& record, const Airframe& airframe, const Model& model) {
  Simulation result;
  result.canard_rad = record.canard_rad;
  std::size_t segment = 0;
  InitialState state{};
  const auto acceleration = [&](std::size_t i) {
    return authority_per_m_s2(airframe, record.density_kg_m3[i], record.speed_m_s[i]) * model.beta_m *
           (record.canard_rad[i] + disturbance_rad(model, record.time_s[i]));
  };
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (segment < record.segment_begin.size() && i == record.segment_begin[segment]) {
      state = model.initial[segment];
      ++segment;
    } else {
      const auto damping = [&](std::size_t at) {
        return damping_per_m2_s(airframe, record.density_kg_m3[at], record.speed_m_s[at]);
      };
      const RampTransition t = ramp_transition(model.alpha_m2 * 0.5 * (damping(i - 1) + damping(i)),
                                               step_s(record.time_s[i - 1], record.time_s[i]));
      const double before = acceleration(i - 1);
      const double now = acceleration(i);
      state.angle_rad += t.angle_p * state.rate_rad_s + t.angle_0 * before + t.angle_1 * now;
      state.rate_rad_s = t.decay * state.rate_rad_s + t.rate_0 * before + t.rate_1 * now;
    }
    result.roll_angle_rad.push_back(state.angle_rad);
    result.roll_rate_rad_s.push_back(state.rate_rad_s);
  }
  add_errors(result, record);
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

Model fit_open_loop(const Record& record, const Airframe& airframe, const NodeTimes& nodes, Start start,
                    const Grid& grid) {
  const ResponseBasis basis{record, airframe, nodes, start};
  const double log_alpha =
      least_over([&basis](double x) { return AlphaFit{basis, std::exp(x)}.least_squares_rad2(); },
                 {.low = std::log(lowest_alpha_m2), .high = std::log(highest_alpha_m2)}, /*places=*/12);
  const AlphaFit fit{basis, std::exp(log_alpha)};
  Model model = fit.model(fit.best_beta_m().value_or(0.5 * (grid.beta_m.first + grid.beta_m.last)), nodes);
  add_starts(model, record);
  return model;
}

}  // namespace fantail::identify
