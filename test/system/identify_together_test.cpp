// SPDX-License-Identifier: MIT
// Several flights and one roll model, as a person asks for it.

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using Words = std::vector<std::string>;

/// Two flights of one rocket with different gains and noise, and one of a rocket with more damping.
class Flights : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Folder>();
    fly({"--out", "first"});
    fly({"--out", "second", "--seed", "5", "--set", "controller.proportional_gain=0.8"});
    fly({"--out", "other", "--set", "aerodynamics.damping_m2=30"});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static void fly(const Words& rest) {
    Words words{"fly", "tasha3_launch2"};
    words.insert(words.end(), rest.begin(), rest.end());
    ASSERT_EQ(fantail(words, {.working_folder = folder_->path()}).exit_code, 0);
  }
  static Outcome run(const Words& rest) {
    Words words{"identify"};
    words.insert(words.end(), rest.begin(), rest.end());
    return fantail(words, {.working_folder = folder_->path()});
  }
  static void expect_usage_error(const Words& words, const std::string& sentence) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 64) << outcome.out;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
  }

  static std::unique_ptr<Folder> folder_;
};
std::unique_ptr<Folder> Flights::folder_;

TEST_F(Flights, OfOneRocketGiveOneModelAndAnother) {
  const Outcome joint = run({"first", "second", "--shared", "alpha,beta", "--json"});
  ASSERT_EQ(joint.exit_code, 0) << joint.err;
  const json::Value model = json::parse(joint.out);
  EXPECT_NEAR(model["alpha_m2"].number(), 23.0, 0.05);
  EXPECT_NEAR(model["beta_m"].number(), 9.0, 0.02);
  EXPECT_EQ(model["agree"], true);
  EXPECT_EQ(model["windows"].size(), 2U);
  for (const char* file : {"report.html", "identification.json", "model_1.csv", "model_2.csv"}) {
    EXPECT_GT(content(*folder_ / (std::string{"out/identify/first+second/"} + file)).size(), 500U) << file;
  }
  const Outcome together = run({"first", "other", "--shared", "alpha,beta", "--out", "both"});
  EXPECT_EQ(together.exit_code, 0);
  EXPECT_NE(together.out.find("These windows disagree about damping and torque: "), std::string::npos) << together.out;
  EXPECT_EQ(json::parse(content(*folder_ / "both/identification.json"))["answer"], "undecided");
}

TEST_F(Flights, AreWhatAModelIsHeldAgainst) {
  ASSERT_EQ(run({"first", "--out", "model"}).exit_code, 0);
  const Outcome same = run({"second", "--validate", "model"});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("The model holds: "), std::string::npos) << same.out;
  EXPECT_GT(content(*folder_ / "out/validate/second/report.html").size(), 500U);
  const Outcome other = run({"other", "--validate", "model/identification.json", "--json", "--out", "v"});
  ASSERT_EQ(other.exit_code, 1) << other.err;
  EXPECT_EQ(json::parse(other.out)["windows"][0]["holds"], false);
}

TEST_F(Flights, ThatAreAskedForTogetherMustSayWhatTheyShare) {
  expect_usage_error({"first", "second"}, "2 logs: name their common values with --shared alpha,beta");
  expect_usage_error({"first", "--shared", "alpha,beta"}, "--shared needs two windows or more");
  expect_usage_error({"first", "second", "--shared", "alpha"}, "--shared: alpha not in {alpha,beta}");
  expect_usage_error({"first", "second", "--shared", "alpha,beta", "--method", "both"}, "--method continuous");
  expect_usage_error({"first", "second", "--shared", "alpha,beta", "--loss", "huber"}, "--loss squares");
  expect_usage_error({"first", "second", "--validate", "model"}, "one log at a time");
  expect_usage_error({"first", "--validate", "model", "--shared", "alpha,beta"}, "--shared");
}

}  // namespace
}  // namespace fantail::test
