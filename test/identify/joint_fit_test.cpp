// SPDX-License-Identifier: MIT
#include "identify/joint_fit.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/identification.hpp"
#include "identify/model/planted.hpp"
#include "identify/result/answer.hpp"
#include "logs/refused.hpp"
#include "text/error.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;
namespace output = fantail::result;

/// One log of one rocket: its own fin offset, speeds and noise.
struct Flown {
  Planting planting{};
  Noise noise{};
};

std::vector<Flown> three_flights() {
  return {
      {.planting = {.node_deg = {-5.0}}, .noise = {.angle_deg = 0.3, .correlation_s = 0.03}},
      {.planting = {.node_deg = {3.0}, .seconds = 2.0, .canard_amplitude_deg = 2.0}, .noise = {.angle_deg = 0.3}},
      {.planting = {.node_deg = {-1.0}, .speed_begin_m_s = 25.0, .speed_end_m_s = 25.0}, .noise = {.angle_deg = 0.6}}};
}

Study study_of(const Flown& flown, std::uint64_t seed) {
  WindowFindings window;
  window.record = planted_record(flown.planting);
  add_noise(window.record, flown.noise, seed);
  window.results = {
      identify(window.record, tasha, {.nodes = NodeTimes{0.0}, .start = Start::fitted, .with_error_map = false})};
  return {.data = "log", .airframe = tasha, .windows = {window}};
}

JointFindings joint(const std::vector<Flown>& flights, std::uint64_t seed) {
  std::vector<Study> studies;
  for (const Flown& each : flights) {
    studies.push_back(study_of(each, 100 * seed + studies.size()));
  }
  return fit_jointly(studies);
}

bool holds(const Interval& interval, double value) { return *interval.low <= value && value <= *interval.high; }

TEST(JointFit, OfCleanLogsFindsWhatWasPlantedAndEachLogsOwnOffset) {
  std::vector<Flown> flights = three_flights();
  for (Flown& each : flights) {
    each.noise = {.angle_deg = 1e-6, .rate_deg_s = 1e-6};
  }
  const JointFindings found = joint(flights, 1);
  EXPECT_NEAR(found.together.value(0), 20.0, 5e-3);
  EXPECT_NEAR(found.together.value(1), 9.0, 5e-3);
  ASSERT_EQ(found.windows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.windows[i].window.results[0].model.node_rad[0] / radians_per_degree,
                flights[i].planting.node_deg[0], 5e-3);
  }
}

TEST(JointCoverage, TheTruthLiesInsideTheStatedIntervalsAndOneRocketIsRarelyCalledTwo) {
  constexpr int sets = 400;
  int alpha = 0;
  int beta = 0;
  int agreed = 0;
  for (int i = 0; i < sets; ++i) {
    const JointFindings found = joint(three_flights(), 5000 + static_cast<std::uint64_t>(i));
    alpha += holds(interval_of(found.together, 0), 20.0) ? 1 : 0;
    beta += holds(interval_of(found.together, 1), 9.0) ? 1 : 0;
    agreed += found.agreement.agree() ? 1 : 0;
  }
  RecordProperty("inside", "alpha " + std::to_string(alpha) + ", beta " + std::to_string(beta) + ", agreed " +
                               std::to_string(agreed) + " of " + std::to_string(sets));
  EXPECT_GE(alpha, 93 * sets / 100);
  EXPECT_GE(beta, 93 * sets / 100);
  EXPECT_GE(agreed, 92 * sets / 100);
  // Nor may an interval be right because it is boundless.
  EXPECT_LT(std::min({alpha, beta, agreed}), sets);
}

TEST(JointFit, KnowsMoreThanEachOfItsLogsAlone) {
  const JointFindings found = joint(three_flights(), 7);
  double shares = 0.0;
  for (const JointWindow& window : found.windows) {
    EXPECT_LT(found.together.covariance(0, 0), constants_of(window.own).covariance(0, 0));
    EXPECT_LT(found.together.covariance(1, 1), constants_of(window.own).covariance(1, 1));
    shares += window.information_share;
  }
  EXPECT_NEAR(shares, 1.0, 1e-9);
}

TEST(JointFit, OfTheSameLogTwiceFindsWhatOneSaysWithHalfTheVariance) {
  const Study one = study_of(three_flights()[0], 11);
  const Constants own = constants_of(one.windows[0].results[0]);
  const JointFindings found = fit_jointly({one, one});
  EXPECT_NEAR(found.together.value(0), own.value(0), 1e-4 * own.value(0));
  EXPECT_NEAR(found.together.covariance(0, 0), 0.5 * own.covariance(0, 0), 1e-6 * own.covariance(0, 0));
  EXPECT_NEAR(found.agreement.chi_square, 0.0, 1e-9);
}

// The angle fits, but the rate is a fifth too large: motion that the model does not have.
TEST(JointFit, ThatAgreesOnAModelThatDoesNotFitIsUndecided) {
  std::vector<Study> studies{study_of(three_flights()[0], 5), study_of(three_flights()[2], 6)};
  const auto verdict = [&studies] { return result::answer(fit_jointly(studies), {}).verdict; };
  EXPECT_EQ(verdict().answer, output::Answer::yes);
  for (double& rate_rad_s : studies[1].windows[0].record.roll_rate_rad_s) {
    rate_rad_s *= 1.2;
  }
  EXPECT_EQ(verdict().answer, output::Answer::undecided);
  EXPECT_NE(verdict().heading.find("does not fit"), std::string::npos) << verdict().heading;
  EXPECT_NE(verdict().sentence.find("1 of 2 windows"), std::string::npos) << verdict().sentence;
}

TEST(JointFit, SeesThatTwoRocketsAreNotOne) {
  std::vector<Flown> flights = three_flights();
  flights[2].planting.alpha_m2 = 40.0;
  EXPECT_FALSE(joint(flights, 3).agreement.agree());
}

TEST(JointFit, ALogOfWhichTheCanardsStoodStillTakesNothingFromTheOthers) {
  for (const double amplitude_deg : {0.01, 0.0}) {
    std::vector<Flown> flights = three_flights();
    flights[1].planting.canard_amplitude_deg = amplitude_deg;
    const JointFindings found = joint(flights, 4);
    EXPECT_FALSE(found.windows[1].own.uncertainty->beta_identifiable) << amplitude_deg;
    EXPECT_TRUE(holds(interval_of(found.together, 0), 20.0)) << found.together.value(0);
    EXPECT_TRUE(holds(interval_of(found.together, 1), 9.0)) << found.together.value(1);
    EXPECT_TRUE(found.agreement.agree()) << found.agreement.chi_square;
  }
}

TEST(JointFit, RefusesLogsWithDifferentReferenceAreas) {
  std::vector<Study> studies{study_of(three_flights()[0], 1), study_of(three_flights()[1], 2)};
  studies[1].airframe.reference_area_m2 *= 2.0;
  test::expect_refused(text::ErrorKind::bad_configuration, {"--shared alpha,beta", "reference area", "--vehicle"},
                       [&] { (void)fit_jointly(studies); });
}
}  // namespace
}  // namespace fantail::identify
