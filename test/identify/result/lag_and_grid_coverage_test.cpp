// SPDX-License-Identifier: MIT
// Intervals of a fit that also finds the lag, and of a grid, hold the truth as often as they say.
#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "identify/planted_log.hpp"
#include "identify/study.hpp"
#include "seed.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;

constexpr int records = 300;
constexpr int least_inside = 276;  // 92 %: 95 % less two and a half standard deviations of the count

struct Inside {
  int alpha = 0;
  int alpha_profile = 0;
  int beta = 0;
  int lag = 0;
};

bool holds(const Interval& interval, double truth) {
  return interval.low.value_or(truth) <= truth && truth <= interval.high.value_or(truth);
}

Inside count(const Planting& planting, const Question& question, int samples_late, double correlation_s = 0.0) {
  const Record clean = planted_record(planting);
  logs::RollLog log = planted_log(planting);
  delay_canards(log, samples_late);
  Inside inside;
  const std::uint64_t first_seed = test::seed(20160102);
  for (int i = 0; i < records; ++i) {
    Record noisy = clean;
    add_noise(noisy, {.angle_deg = 0.3, .correlation_s = correlation_s}, first_seed + static_cast<std::uint64_t>(i));
    log.roll_angle_rad = noisy.roll_angle_rad;
    log.roll_rate_rad_s = noisy.roll_rate_rad_s;
    const WindowFindings window = study(log, question).windows[0];
    const Uncertainty& known = *window.results[0].uncertainty;
    inside.alpha += holds(known.interval[0], planting.alpha_m2) ? 1 : 0;
    inside.alpha_profile += holds(known.alpha_profile_m2, planting.alpha_m2) ? 1 : 0;
    inside.beta += holds(known.interval[1], planting.beta_m) ? 1 : 0;
    const double late_s = samples_late / planting.sample_hz;
    inside.lag += known.lag_s && std::abs(window.lag_s - late_s) <= known.lag_s->reach ? 1 : 0;
  }
  testing::Test::RecordProperty("inside", "alpha " + std::to_string(inside.alpha) + ", profile " +
                                              std::to_string(inside.alpha_profile) + ", beta " +
                                              std::to_string(inside.beta) + ", lag " + std::to_string(inside.lag));
  return inside;
}

class LagCoverage : public testing::TestWithParam<double> {};  // correlation time of the noise, s

TEST_P(LagCoverage, IntervalsHoldTheTruthWhenTheLagIsFitted) {
  const Planting planting{.seconds = 3.0, .sample_hz = 200.0};
  Question question = planted_question("0");
  question.options.with_error_map = false;
  question.options.start = Start::fitted;
  question.fit_lag = true;
  const Inside inside = count(planting, question, 3, GetParam());
  EXPECT_GE(inside.alpha, least_inside);
  EXPECT_GE(inside.alpha_profile, least_inside);
  EXPECT_GE(inside.beta, least_inside);
  EXPECT_GE(inside.lag, least_inside);
  EXPECT_LT(inside.alpha, records);
  EXPECT_LT(inside.lag, records);
}

INSTANTIATE_TEST_SUITE_P(Noises, LagCoverage, testing::Values(0.0, 0.03));

TEST(GridCoverage, IntervalsHoldTheTruthBetweenTheGridsPoints) {
  const Planting planting{.alpha_m2 = 20.47, .beta_m = 9.22, .seconds = 3.0};
  Question question = planted_question("0");
  question.methods = {Method::grid};
  const Inside inside = count(planting, question, 0);
  EXPECT_GE(inside.alpha, least_inside);
  EXPECT_GE(inside.alpha_profile, least_inside);
  EXPECT_GE(inside.beta, least_inside);
}

}  // namespace
}  // namespace fantail::identify::result
