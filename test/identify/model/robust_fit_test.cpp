// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "identify/model/least_squares.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/model/planted.hpp"
#include "seed.hpp"

namespace fantail::identify::model {
namespace {

const Planting planting{.seconds = 3.0};

// Of each hundred samples one, at an angle that is wrong by up to 30 degrees: a glitch of a bus.
void add_outliers(Record& record, std::uint64_t seed) {
  std::mt19937_64 generator{seed};
  std::uniform_int_distribution<std::size_t> which{0, record.size() - 1};
  std::uniform_real_distribution<double> wrong_deg{-30.0, 30.0};
  for (std::size_t i = 0; i < record.size() / 100; ++i) {
    record.roll_angle_rad[which(generator)] += radians_per_degree * wrong_deg(generator);
  }
}

Record noisy_record(const Noise& noise, bool outliers, std::uint64_t seed) {
  Record record = planted_record(planting);
  add_noise(record, noise, seed);
  if (outliers) {
    add_outliers(record, seed);
  }
  return record;
}

result::Identification identified(const Record& record, Loss loss) {
  return identify(record, tasha,
                  {.nodes = NodeTimes{0.0}, .start = Start::fitted, .loss = loss, .with_error_map = false});
}

TEST(RobustFit, OfACleanRecordIsThePlantedModel) {
  const RobustFit fit = fit_open_loop_robustly(planted_record(planting), tasha, {0.0}, {});
  EXPECT_NEAR(fit.model.alpha_m2, 20.0, 5e-3);
  EXPECT_NEAR(fit.model.beta_m, 9.0, 5e-3);
  EXPECT_TRUE(fit.settled);
}

// What Huber's loss is: the slope of the sum of losses over each number of the model is zero.
TEST(RobustFit, IsWhereTheSumOfHubersLossesIsLeast) {
  const Record record = noisy_record({}, true, 4);
  const RobustFit fit = fit_open_loop_robustly(record, tasha, {0.0}, {});
  const auto losses = [&](const RollModel& model) {
    const std::vector<double> modelled = simulate_open_loop(record, tasha, model).roll_angle_rad;
    double sum = 0.0;
    for (std::size_t i = 0; i < record.size(); ++i) {
      const double error = std::abs(record.roll_angle_rad[i] - modelled[i]);
      sum += error <= fit.threshold_rad ? 0.5 * error * error : fit.threshold_rad * (error - 0.5 * fit.threshold_rad);
    }
    return sum;
  };
  const double least = losses(fit.model);
  for (double RollModel::* number : {&RollModel::alpha_m2, &RollModel::beta_m}) {
    for (const double factor : {0.999, 1.001}) {
      RollModel other = fit.model;
      other.*number *= factor;
      EXPECT_GT(losses(other), least);
    }
  }
  for (const double step_rad : {-1e-4, 1e-4}) {
    RollModel other = fit.model;
    other.node_rad[0] += step_rad;
    EXPECT_GT(losses(other), least);
    other = fit.model;
    other.initial[0].angle_rad += step_rad;
    EXPECT_GT(losses(other), least);
  }
}

TEST(RobustFit, FindsTheModelBesideAnAngleThatIsOffByAMillionDegrees) {
  Record record = noisy_record({.angle_deg = 0.1}, false, 5);
  record.roll_angle_rad[0] += 1e6 * radians_per_degree;
  record.roll_angle_rad[150] -= 1e6 * radians_per_degree;
  const RobustFit fit = fit_open_loop_robustly(record, tasha, {0.0}, {});
  EXPECT_TRUE(fit.settled);
  EXPECT_NEAR(fit.model.alpha_m2, 20.0, 0.7);
  EXPECT_NEAR(fit.model.beta_m, 9.0, 0.3);
}

struct Case {
  std::string name;
  Noise noise;
  bool outliers;
  double most_width;  ///< of alpha's interval, as a share of that of least squares, in the median
};

class RobustCoverage : public testing::TestWithParam<Case> {};

TEST_P(RobustCoverage, TheTruthLiesInsideTheStatedIntervals) {
  constexpr int records = 400;
  const std::uint64_t first_seed = test::seed(20151211);
  struct Count {
    int alpha = 0;
    int profile = 0;
    int beta = 0;
    int disturbance = 0;
  };
  const auto count = [](const result::Identification& found, Count& inside) {
    const result::Uncertainty& u = *found.uncertainty;
    const auto holds = [](const result::Interval& i, double truth) {
      return i.low.value_or(truth) <= truth && truth <= i.high.value_or(truth) ? 1 : 0;
    };
    inside.alpha += holds(u.interval[0], planting.alpha_m2);
    inside.profile += holds(u.alpha_profile_m2, planting.alpha_m2);
    inside.beta += holds(u.interval[1], planting.beta_m);
    inside.disturbance += holds(u.interval[2], radians_per_degree * planting.node_deg[0]);
    return u.standard_deviation[0];
  };
  Count huber;
  Count squares;
  std::vector<double> width;
  for (int i = 0; i < records; ++i) {
    const Record record =
        noisy_record(GetParam().noise, GetParam().outliers, first_seed + static_cast<std::uint64_t>(i));
    const double of_huber = count(identified(record, Loss::huber), huber);
    width.push_back(of_huber / count(identified(record, Loss::squares), squares));
  }
  std::ranges::nth_element(width, width.begin() + records / 2);
  const auto said = [](const Count& c) {
    return "alpha " + std::to_string(c.alpha) + ", profile " + std::to_string(c.profile) + ", beta " +
           std::to_string(c.beta) + ", disturbance " + std::to_string(c.disturbance);
  };
  RecordProperty("huber", said(huber));
  RecordProperty("squares", said(squares));
  RecordProperty("width", std::to_string(width[records / 2]));
  for (const int inside : {huber.alpha, huber.profile, huber.beta, huber.disturbance}) {
    EXPECT_GE(inside, 92 * records / 100);
    EXPECT_LT(inside, records);
  }
  EXPECT_LT(width[records / 2], GetParam().most_width);
}

INSTANTIATE_TEST_SUITE_P(
    Noises, RobustCoverage,
    testing::Values(Case{"outliers", {}, true, 0.3},
                    Case{"outliers_correlated", {.angle_deg = 0.3, .correlation_s = 0.03}, true, 0.5},
                    Case{"none", {}, false, 1.1}),
    [](const testing::TestParamInfo<Case>& each) { return each.param.name; });

}  // namespace
}  // namespace fantail::identify::model
