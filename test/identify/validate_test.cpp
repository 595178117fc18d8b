// SPDX-License-Identifier: MIT
#include "identify/validate.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "identify/identification.hpp"
#include "identify/model/planted.hpp"
#include "identify/result/answer.hpp"
#include "logs/refused.hpp"
#include "system/folder.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

Study study_of(const Planting& planting, std::uint64_t seed, double angle_noise_deg = 0.3) {
  WindowFindings window;
  window.record = planted_record(planting);
  add_noise(window.record, {.angle_deg = angle_noise_deg}, seed);
  window.results = {identify(window.record, tasha, {.nodes = NodeTimes{0.0}, .with_error_map = false})};
  return {.data = "log.csv", .airframe = tasha, .windows = {window}};
}

KnownModel found_in(const Study& study) {
  return {.source = "model",
          .constants = constants_of(study.windows[0].results[0]),
          .covariance_is_known = true,
          .reference_area_m2 = study.airframe.reference_area_m2};
}

KnownModel exact(double alpha_m2, double beta_m) {
  return {.source = "model",
          .constants = {.value = {alpha_m2, beta_m}, .degrees_of_freedom = std::numeric_limits<double>::infinity()},
          .reference_area_m2 = tasha.reference_area_m2};
}

// Of 300 right models 95 % should hold; fewer than 92 % would be 2.4 standard deviations.
TEST(Validate, AModelOfTheSameRocketHoldsInAnotherFlightAsOftenAsStated) {
  constexpr int pairs = 300;
  int holds = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto seed = 9000 + 2 * static_cast<std::uint64_t>(i);
    const KnownModel known = found_in(study_of({.node_deg = {-5.0}}, seed));
    const Study other = study_of({.node_deg = {3.0}, .speed_begin_m_s = 30.0, .speed_end_m_s = 45.0}, seed + 1);
    holds += validate(known, other, Start::measured).windows[0].agreement.agree() ? 1 : 0;
  }
  RecordProperty("holds", holds);
  EXPECT_GE(holds, 92 * pairs / 100);
  EXPECT_LT(holds, pairs);
}

TEST(Validate, AModelOfAnotherRocketDoesNotHoldAndTheVerdictSaysByHowMuch) {
  const Validation found = validate(exact(25.0, 9.0), study_of({}, 1), Start::measured);
  const ValidatedWindow& window = found.windows[0];
  EXPECT_TRUE(window.can_tell());
  EXPECT_FALSE(window.holds());
  EXPECT_NEAR(window.largest_difference(), 0.25, 0.05);
  EXPECT_EQ(figures(verdict(found, window)).at(0), text::brief(100.0 * window.largest_difference(), 2))
      << verdict(found, window);
}

TEST(Validate, OnlyTheDisturbanceIsFittedAnew) {
  const Study study = study_of({.node_deg = {3.0}}, 1, 1e-6);
  const Validation found = validate(exact(20.0, 9.0), study, Start::measured);
  const Identification& held = found.windows[0].window.results[0];
  EXPECT_EQ(held.model.alpha_m2, 20.0);
  EXPECT_EQ(held.model.beta_m, 9.0);
  EXPECT_NEAR(held.model.node_rad[0] / radians_per_degree, 3.0, 0.01);
  EXPECT_GT(explained_share(study.windows[0].record, held.simulation), 0.99);
}

TEST(Validate, AWindowThatSaysLittleCannotTell) {
  const Validation found = validate(exact(60.0, 27.0), study_of({.canard_amplitude_deg = 0.0}, 1), Start::measured);
  EXPECT_FALSE(found.windows[0].can_tell());
  EXPECT_NE(verdict(found, found.windows[0]).find(found.windows[0].own.uncertainty->verdict), std::string::npos);
}

TEST(Validate, ConstantsForAnotherAreaAreConverted) {
  KnownModel known = exact(10.0, 4.5);
  known.reference_area_m2 = 2.0 * tasha.reference_area_m2;
  const Validation found = validate(known, study_of({}, 1), Start::measured);
  EXPECT_NEAR(found.model.constants.value(0), 20.0, 1e-9);
  EXPECT_TRUE(found.windows[0].holds());
}

TEST(KnownModel, IsReadAsItWasWritten) {
  const test::Folder folder;
  const Study study = study_of({}, 1);
  folder.write("id/identification.json", fantail::result::json(answer(study)));
  const KnownModel read = read_model(folder.path() / "id");
  const Constants written = constants_of(study.windows[0].results[0]);
  EXPECT_NEAR(read.constants.value(0), written.value(0), 1e-6);
  EXPECT_NEAR(read.constants.covariance(0, 1), written.covariance(0, 1), 1e-6 * written.covariance(0, 0));
  EXPECT_NEAR(read.constants.degrees_of_freedom, written.degrees_of_freedom, 1e-4);
  EXPECT_TRUE(read.covariance_is_known);
  EXPECT_EQ(read.how, "open loop, continuous, window " + study.windows[0].record.window + " of log.csv");
}

TEST(KnownModel, OfSeveralWindowsIsTheCommonOne) {
  const test::Folder folder;
  Study study = study_of({}, 1);
  study.windows.push_back(study_of({.node_deg = {2.0}}, 2).windows[0]);
  folder.write("each/identification.json", fantail::result::json(answer(study)));
  test::expect_refused(text::ErrorKind::bad_data, {"several results", "--shared alpha,beta"},
                       [&] { (void)read_model(folder.path() / "each"); });
}

TEST(KnownModel, IsRefusedWithTheFileTheKeyAndTheValue) {
  const test::Folder folder;
  const auto file = folder.path() / "identification.json";
  const auto refused = [&](const std::string& content, std::initializer_list<const char*> words) {
    folder.write("identification.json", content);
    test::expect_refused(text::ErrorKind::bad_data, words, [&] { (void)read_model(file); });
  };
  refused("{", {"identification.json", "not JSON"});
  refused("[1]", {"not a JSON object"});
  refused(R"({"beta_m": 9, "reference_area_m2": 5e-5})", {"alpha_m2 is missing"});
  refused(R"({"alpha_m2": -3, "beta_m": 9, "reference_area_m2": 5e-5})", {"alpha_m2 is -3", "above 0"});
  test::expect_refused(text::ErrorKind::no_such_input, {"nowhere", "fantail identify"},
                       [] { (void)read_model("nowhere"); });
}

}  // namespace
}  // namespace fantail::identify
