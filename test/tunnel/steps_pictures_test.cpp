// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

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

TEST(Outliers, AreNoneWhereNobodyCouldSayWhichAreTheOddOnes) {
  EXPECT_TRUE(outliers(identify_steps(made_run(three_rockets), tasha, at_22_m_s())).empty());
  EXPECT_TRUE(outliers({}).empty());
}

}  // namespace
}  // namespace fantail::tunnel
