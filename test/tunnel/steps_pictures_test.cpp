// SPDX-License-Identifier: MIT
#include <array>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "distributions/quantiles.hpp"
#include "tunnel/made_steps.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {
namespace {

TEST(Outliers, AreTheStepsThatLieApartFromTheMedianByFigureAndNumber) {
  std::vector<Planted> rockets(7, {19.4, 9.6, -4.0});
  for (std::size_t i = 0; i < rockets.size(); ++i) {
    rockets[i].alpha_m2 += 0.1 * static_cast<double>(i % 3);
  }
  rockets[4].alpha_m2 = 26.0;
  const StepTable table = identify_steps(made_run(rockets), tasha, at_22_m_s());
  std::vector<Outlier> of_alpha = outliers(table);
  std::erase_if(of_alpha, [](const Outlier& one) { return step_fields[one.figure].key != "alpha"; });
  ASSERT_EQ(of_alpha.size(), 1U);
  EXPECT_EQ(of_alpha[0].step, 5U);
  EXPECT_NEAR(of_alpha[0].value, 26.0, 0.1);
  EXPECT_NEAR(of_alpha[0].median, 19.5, 0.1);
  const std::vector<result::Block> shown = overlay(table);
  EXPECT_EQ(std::get<result::Picture>(shown[0]).chart.series.back().name, "step 5");
  EXPECT_TRUE(std::get<result::Sentences>(shown[1]).all[0].starts_with("Step 5: alpha 26.0"));
}

TEST(Outliers, WhatIsNegligibleIsNoneHoweverWellTheOthersAgree) {
  std::vector<Planted> rockets(7, {20.0, 9.6, -4.0});
  for (std::size_t i = 0; i < rockets.size(); ++i) {
    rockets[i].alpha_m2 += 0.001 * static_cast<double>(i % 3);
  }
  rockets[4].alpha_m2 = 20.3;  // 1.5 %
  EXPECT_TRUE(outliers(identify_steps(made_run(rockets), tasha, at_22_m_s())).empty());
  rockets[4].alpha_m2 = 20.6;  // 3 %
  EXPECT_FALSE(outliers(identify_steps(made_run(rockets), tasha, at_22_m_s())).empty());
}

TEST(Overlay, SaysWhyUpAndDownStepsAreTwoBundles) {
  const std::vector<Planted> rockets(6, {20.0, 9.6, -4.0});
  StepTable table = identify_steps(made_run(rockets), tasha, at_22_m_s());
  const auto explains = [](const StepTable& some) {
    return std::get<result::Picture>(overlay(some)[0]).caption.find("two bundles") != std::string::npos;
  };
  EXPECT_TRUE(explains(table));
  const auto explains_the_first = [](const StepTable& some) {
    return std::get<result::Picture>(overlay(some)[0]).caption.find("Step 1 begins") != std::string::npos;
  };
  EXPECT_TRUE(explains_the_first(table));
  std::erase_if(table.steps, [](const StepResult& result) { return result.step.to_rad < result.step.from_rad; });
  EXPECT_FALSE(table.steps.empty());
  EXPECT_FALSE(explains(table));
  table.steps.erase(table.steps.begin());
  EXPECT_FALSE(explains_the_first(table));
}

logs::RollLog noisy_run(const std::vector<Planted>& rockets) {
  logs::RollLog log = made_run(rockets);
  std::mt19937 random{7};
  std::normal_distribution<double> noise_rad{0.0, 0.1 * degree};
  for (double& angle_rad : log.roll_angle_rad) {
    angle_rad += noise_rad(random);
  }
  return log;
}

// Student's quantile times the standard error to either side; alpha's comes from the likelihood and is not symmetric.
TEST(OverSteps, HasAnErrorBarOfTheNinetyFivePercentIntervalAtEachStep) {
  const StepTable table = identify_steps(noisy_run(std::vector<Planted>(6, {20.0, 9.6, -4.0})), tasha, at_22_m_s());
  const std::vector<result::Block> shown = over_steps(table);
  ASSERT_EQ(shown.size(), 4U);
  constexpr double deg = 180.0 / std::numbers::pi;
  const std::array in_shown_unit{1.0, 1.0, deg, deg};
  const std::array errors{&StepFigures::alpha_m2, &StepFigures::beta_m, &StepFigures::disturbance_begin_rad,
                          &StepFigures::disturbance_end_rad};
  std::size_t around_the_truth = 0;
  for (std::size_t figure = 0; figure < 4; ++figure) {
    const page::Chart& chart = std::get<result::Picture>(shown[figure]).chart;
    ASSERT_EQ(chart.areas.size(), table.steps.size());
    for (std::size_t i = 0; i < table.steps.size(); ++i) {
      const page::Area& bar = chart.areas[i];
      EXPECT_NEAR(0.5 * (bar.x[0] + bar.x[1]), static_cast<double>(table.steps[i].number), 1e-12);
      EXPECT_LT(bar.low[0], chart.series[0].y[i]);
      EXPECT_GT(bar.high[0], chart.series[0].y[i]);
      const double error = standard_errors_of(table.steps[i]).*errors[figure] * in_shown_unit[figure];
      const double freedom = table.steps[i].identified.uncertainty.value().degrees_of_freedom;
      const double expected = 2.0 * distributions::student_975(freedom) * error;
      EXPECT_NEAR(bar.high[0] - bar.low[0], expected, (figure == 0 ? 0.05 : 1e-9) * expected);
      const double truth = std::array{20.0, 9.6, -4.0, -4.0}[figure];
      around_the_truth += bar.low[0] <= truth && truth <= bar.high[0] ? 1 : 0;
    }
  }
  EXPECT_GE(around_the_truth, 20U) << "of 24";
  EXPECT_NE(result::html(steps_answer({.airframe = tasha, .options = at_22_m_s()}, table, {})).find("95 % interval"),
            std::string::npos);
}

TEST(OneStep, HasItsIntervalsInWordsAndItsOwnCurvesAndNoMean) {
  const StepTable table = identify_steps(noisy_run({{20.0, 9.6, -4.0}}), tasha, at_22_m_s());
  ASSERT_EQ(table.steps.size(), 1U);
  const result::Document found = steps_answer({.airframe = tasha, .options = at_22_m_s()}, table, {});
  const std::string text = result::text(found);
  EXPECT_NE(text.find("Step 1: damping alpha "), std::string::npos) << text;
  EXPECT_NE(text.find("95 % intervals: alpha "), std::string::npos) << text;
  for (const char* of_several : {"ean of", "\n  mean", "From step to step", "deviation"}) {
    EXPECT_EQ(text.find(of_several), std::string::npos) << of_several << "\n" << text;
  }
  const std::string page = result::html(found);
  EXPECT_NE(page.find("Roll angle after step 1, measured and modelled"), std::string::npos);
  for (const char* of_several : {"All steps together", "<details"}) {
    EXPECT_EQ(page.find(of_several), std::string::npos) << of_several;
  }
}

TEST(Outliers, AreNoneWhereNobodyCouldSayWhichAreTheOddOnes) {
  EXPECT_TRUE(outliers(identify_steps(made_run(three_rockets), tasha, at_22_m_s())).empty());
  EXPECT_TRUE(outliers({}).empty());
}

}  // namespace
}  // namespace fantail::tunnel
