// SPDX-License-Identifier: MIT
#include "identify/model/alpha_fit.hpp"

#include <gtest/gtest.h>

#include "identify/model/open_loop.hpp"
#include "identify/model/planted.hpp"

namespace fantail::identify::model {
namespace {

RollModel some_model(const Record& record) {
  return {.alpha_m2 = 31.0,
          .beta_m = 7.0,
          .node_time_s = {0.3, 1.1, 3.0},
          .node_rad = {0.02, -0.1, 0.04},
          .initial = measured_starts(record)};
}

Record with_gap() {
  Record record = planted_record({});
  record.segment_begin = {0, 150};
  return record;
}

TEST(OpenLoop, ItsStepsFollowAFineIntegration) {
  const Planting planting{.node_time_s = {0.0, 4.0}, .node_deg = {-2.0, -6.0}};
  const Record record = planted_record(planting);
  const RollModel truth{.alpha_m2 = planting.alpha_m2,
                        .beta_m = planting.beta_m,
                        .node_time_s = planting.node_time_s,
                        .node_rad = {-2.0 * radians_per_degree, -6.0 * radians_per_degree},
                        .initial = measured_starts(record)};
  const Simulation simulation = simulate_open_loop(record, tasha, truth);
  // Straight lines through canard angles at 100 Hz: 31 rad/s are bent by 1 % between samples.
  EXPECT_LT(simulation.mean_abs_angle_error_rad, 0.02 * radians_per_degree);
}

TEST(ResponseBasis, ItsColumnsAddUpToTheSimulation) {
  const Record record = with_gap();
  const RollModel model = some_model(record);
  for (const Start start : {Start::measured, Start::fitted}) {
    const ResponseBasis basis{record, tasha, model.node_time_s, start};
    Eigen::MatrixXd angles;
    basis.respond(model.alpha_m2, angles);
    Eigen::VectorXd sum = angles.col(static_cast<Eigen::Index>(basis.free_column())) +
                          model.beta_m * angles.col(static_cast<Eigen::Index>(basis.canard_column()));
    for (std::size_t k = 0; k < basis.nodes(); ++k) {
      sum += model.beta_m * model.node_rad[k] * angles.col(static_cast<Eigen::Index>(k));
    }
    for (std::size_t s = 0; s < basis.initial_columns() / 2; ++s) {
      const auto column = static_cast<Eigen::Index>(basis.nodes() + 2 * s);
      sum += model.initial[s].angle_rad * angles.col(column) + model.initial[s].rate_rad_s * angles.col(column + 1);
    }
    const Simulation simulation = simulate_open_loop(record, tasha, model);
    for (std::size_t i = 0; i < record.size(); ++i) {
      ASSERT_NEAR(sum(static_cast<Eigen::Index>(i)), simulation.roll_angle_rad[i], 1e-12) << i;
    }
  }
}

TEST(Sensitivities, TheyAreThoseOfFiniteDifferences) {
  const Record record = with_gap();
  const RollModel model = some_model(record);
  const Sensitivities found = open_loop_sensitivities(record, tasha, model);
  const auto check = [&](const char* what, const Eigen::VectorXd& column, const auto& change, double step) {
    RollModel up = model;
    RollModel down = model;
    change(up, step);
    change(down, -step);
    const Simulation above = simulate_open_loop(record, tasha, up);
    const Simulation below = simulate_open_loop(record, tasha, down);
    const double size = column.cwiseAbs().maxCoeff();
    ASSERT_GT(size, 0.0) << what;
    for (std::size_t i = 0; i < record.size(); ++i) {
      const double expected = (above.roll_angle_rad[i] - below.roll_angle_rad[i]) / (2.0 * step);
      ASSERT_NEAR(column(static_cast<Eigen::Index>(i)), expected, 1e-6 * size) << what << " at sample " << i;
    }
  };
  check("alpha", found.numbers.col(0), [](RollModel& m, double d) { m.alpha_m2 += d; }, 1e-3);
  check("beta", found.numbers.col(1), [](RollModel& m, double d) { m.beta_m += d; }, 1e-3);
  check("node", found.numbers.col(3), [](RollModel& m, double d) { m.node_rad[1] += d; }, 1e-4);
  check("angle", found.start_angle.col(1), [](RollModel& m, double d) { m.initial[1].angle_rad += d; }, 1e-4);
  check("rate", found.start_rate.col(0), [](RollModel& m, double d) { m.initial[0].rate_rad_s += d; }, 1e-4);
}

}  // namespace
}  // namespace fantail::identify::model
