// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <ceres/ceres.h>

#include "benchmark/identify_answer.hpp"
#include "identify/model/alpha_fit.hpp"
#include "identify/model/roll_equation.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::benchmark {
namespace {

using identify::model::Record;

constexpr int node_count = 5;

// What does not depend on alpha and beta, made once as a careful user would.
struct Prepared {
  explicit Prepared(const IdentifyTask& task);

  const Record& record;
  std::vector<double> dt_s{};
  std::vector<double> damping_per_m2_s{};
  std::vector<double> authority_per_m_s2{};
  std::vector<identify::model::NodeShare> share{};
};

Prepared::Prepared(const IdentifyTask& task) : record{task.record} {
  const std::vector<identify::model::RollEquation> equation = identify::model::roll_equations(record, task.airframe);
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (i + 1 < record.size()) {
      dt_s.push_back(identify::model::step_s(record.time_s[i], record.time_s[i + 1]));
      damping_per_m2_s.push_back(0.5 * (equation[i].damping_per_m2_s + equation[i + 1].damping_per_m2_s));
    }
    authority_per_m_s2.push_back(equation[i].authority_per_m_s2);
    share.push_back(identify::model::node_share(task.node_time_s, record.time_s[i]));
  }
}

// The same steps as everybody's; Ceres makes the derivatives itself (dual numbers of five parts).
struct AngleErrors {
  const Prepared& prepared;
  const std::vector<identify::model::RampStep>& steps;
  double beta_m;

  template <typename Number>
  bool operator()(const Number* node_rad, Number* error) const {
    const Record& record = prepared.record;
    const auto acceleration = [&](std::size_t i) {
      const identify::model::NodeShare& share = prepared.share[i];
      return prepared.authority_per_m_s2[i] * beta_m *
             (record.canard_rad[i] +
              (node_rad[share.left] + share.right_share * (node_rad[share.right] - node_rad[share.left])));
    };
    Number angle{record.roll_angle_rad[0]};
    Number rate{record.roll_rate_rad_s[0]};
    Number before = acceleration(0);
    error[0] = Number{0.0};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const identify::model::RampStep& t = steps[i];
      const Number now = acceleration(i + 1);
      angle += t.angle_p * rate + t.angle_0 * before + t.angle_1 * now;
      rate = t.decay * rate + t.rate_0 * before + t.rate_1 * now;
      error[i + 1] = record.roll_angle_rad[i + 1] - angle;
      before = now;
    }
    return true;
  }
};

// Ceres stops when a step changes the squared error by less than this share of it. With its default the errors of the
// grid are 1e-3 degrees off; `close` takes one step more and has everybody's table.
constexpr double by_default = 1e-6;
constexpr double close = 1e-14;

// Fits the nodes at one point, from zero; returns the mean absolute angle error.
double fit(const Prepared& prepared, double tolerance, double alpha_m2, double beta_m, std::vector<double>& node_rad) {
  std::vector<identify::model::RampStep> steps;
  for (std::size_t i = 0; i < prepared.dt_s.size(); ++i) {
    steps.push_back(identify::model::ramp_step(alpha_m2 * prepared.damping_per_m2_s[i], prepared.dt_s[i]));
  }
  const AngleErrors errors{.prepared = prepared, .steps = steps, .beta_m = beta_m};
  node_rad.assign(node_count, 0.0);
  ceres::Problem problem;
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<AngleErrors, ceres::DYNAMIC, node_count>(
                               new AngleErrors{errors}, static_cast<int>(prepared.record.size())),
                           nullptr, node_rad.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;  // faster than DENSE_QR here
  options.function_tolerance = tolerance;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  std::vector<double> error_rad(prepared.record.size());
  errors(node_rad.data(), error_rad.data());
  double sum = 0.0;
  for (const double error : error_rad) {
    sum += std::abs(error);
  }
  return sum / static_cast<double>(error_rad.size());
}

void ceres_grid(::benchmark::State& state, double tolerance) {
  const IdentifyTask& task = task_of(state);
  identify::model::GridResult found;
  for ([[maybe_unused]] auto _ : state) {
    found = {};
    found.errors.alpha_m2 = task.some_points.alpha_m2.values();
    found.errors.beta_m = task.some_points.beta_m.values();
    const Prepared prepared{task};
    double least = 0.0;
    for (const double beta_m : found.errors.beta_m) {
      for (const double alpha_m2 : found.errors.alpha_m2) {
        std::vector<double> node_rad;
        const double error = fit(prepared, tolerance, alpha_m2, beta_m, node_rad);
        if (found.errors.mean_abs_angle_error_rad.empty() || error < least) {
          least = error;
          found.model = {.alpha_m2 = alpha_m2, .beta_m = beta_m, .node_time_s = task.node_time_s, .node_rad = node_rad};
        }
        found.errors.mean_abs_angle_error_rad.push_back(error);
      }
    }
  }
  tell_grid(state, found);
}

}  // namespace
}  // namespace fantail::benchmark

using namespace fantail::benchmark;

BENCHMARK_CAPTURE(ceres_grid, close, fantail::benchmark::close)->Name("identify_ceres")->Arg(100)->Arg(1000);
BENCHMARK_CAPTURE(ceres_grid, by_default, by_default)->Name("identify_ceres_default")->Arg(100)->Arg(1000);
