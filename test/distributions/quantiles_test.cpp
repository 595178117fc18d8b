// SPDX-License-Identifier: MIT
#include "distributions/quantiles.hpp"

#include "test.hpp"

namespace fantail::distributions {
namespace {

TEST(NormalQuantile, IsTheInverseOfTheNormalLaw) {
  EXPECT_NEAR(normal_quantile(0.975), normal_975, 1e-14);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-16);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-12);
  for (double probability = 1e-12; probability < 1.0; probability = std::max(1.7 * probability, probability + 1e-3)) {
    const double back = 0.5 * std::erfc(-normal_quantile(probability) / std::numbers::sqrt2);
    EXPECT_NEAR(back / probability, 1.0, 1e-12) << probability;
  }
}

// Where no closed form is named, SciPy 1.17 computed the values: scipy.stats.chi2.ppf, beta.ppf and t.ppf.

TEST(ChiSquareQuantile, IsThatOfTheTables) {
  EXPECT_NEAR(chi_square_quantile(0.025, 1.0), 0.0009820691171752555, 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.975, 1.0), 5.023886187314888, 1e-8);
  EXPECT_NEAR(chi_square_quantile(0.95, 4.0), 9.487729036781154, 1e-8);
  EXPECT_NEAR(chi_square_quantile(0.025, 7.0), 1.689869180677355, 1e-8);
  EXPECT_NEAR(chi_square_quantile(0.975, 100.0), 129.56119718583659, 1e-7);
  for (const double probability : {1e-6, 0.5, 0.95}) {
    EXPECT_NEAR(chi_square_quantile(probability, 2.0), -2.0 * std::log1p(-probability), 1e-9) << probability;
  }
}

TEST(BetaQuantile, IsThatOfTheClosedForms) {
  for (const double probability : {1e-6, 0.05, 0.5, 0.95}) {
    EXPECT_NEAR(beta_quantile(probability, 1.0, 7.0), -std::expm1(std::log1p(-probability) / 7.0), 1e-12);
    EXPECT_NEAR(beta_quantile(probability, 7.0, 1.0), std::pow(probability, 1.0 / 7.0), 1e-12);
    const double sine = std::sin(0.5 * std::numbers::pi * probability);
    EXPECT_NEAR(beta_quantile(probability, 0.5, 0.5), sine * sine, 1e-12) << probability;
  }
}

TEST(Student, IsThatOfTheClosedFormsAndOfTheTables) {
  EXPECT_NEAR(student_975(1.0), std::tan(0.475 * std::numbers::pi), 1e-8);
  EXPECT_NEAR(student_975(2.0), 0.95 / std::sqrt(2.0 * 0.975 * 0.025), 1e-9);
  EXPECT_NEAR(student_975(3.0), 3.1824463052837078, 1e-9);
  EXPECT_NEAR(student_975(10.0), 2.228138851986274, 1e-9);
  EXPECT_NEAR(student_975(30.0), 2.0422724563012378, 1e-7);
  EXPECT_NEAR(student_975(1e9), normal_975, 1e-8);
  EXPECT_EQ(student_975(0.0), student_975(1.0));
}

TEST(Student, TheSmallNumbersAndTheExpansionForTheLargeAgreeWhereTheyMeet) {
  EXPECT_NEAR(student_975(std::nextafter(20.0, 0.0)), student_975(20.0), 1e-6);
}

}  // namespace
}  // namespace fantail::distributions
