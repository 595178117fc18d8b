// SPDX-License-Identifier: MIT
// The roll model from flights whose law goes beyond the publication.

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

using Words = std::vector<std::string>;

/// The second launch with each mode of the law: alpha 23, beta 9, fin offset -4.9 degrees.
class ModesOfTheLaw : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Folder>();
    fly({"--out", "published"});
    fly({"--out", "integral", "--set", "offset.rejection=integral"});
    fly({"--out", "observer", "--set", "offset.rejection=observer", "--set", "roll_model.roll_inertia_kg_m2=0.00393",
         "--set", "roll_model.reference_area_m2=5.0265e-5", "--set", "roll_model.damping_m2=23", "--set",
         "roll_model.torque_m=9"});
    fly({"--out", "schedule", "--set", "gain_schedule.speeds_m_s=[40,80]", "--set", "gain_schedule.factors=[2,0.75]"});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static Words joined(Words words, const Words& rest) {
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
  }
  static void fly(const Words& rest) {
    ASSERT_EQ(fantail(joined({"fly", "tasha3_launch2"}, rest), {.working_folder = folder_->path()}).exit_code, 0);
  }
  static Outcome run(const Words& rest) {
    return fantail(joined({"identify"}, rest), {.working_folder = folder_->path()});
  }
  static json::Value identified(const Words& rest) {
    const Outcome outcome = run(joined(rest, {"--window", "0.9:8", "--json", "--out", "i"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  static std::unique_ptr<Folder> folder_;
};
std::unique_ptr<Folder> ModesOfTheLaw::folder_;

TEST_F(ModesOfTheLaw, ChangeNothingForTheOpenLoop) {
  for (const char* flight : {"published", "integral", "observer", "schedule"}) {
    const auto json = identified({flight});
    EXPECT_NEAR(json["alpha_m2"].number(), 23.0, 0.05) << flight;
    EXPECT_NEAR(json["beta_m"].number(), 9.0, 0.02) << flight;
    EXPECT_NEAR(json["disturbance_deg"][0].number(), -4.9, 0.002) << flight;
    EXPECT_NEAR(json["disturbance_deg"][1].number(), -4.9, 0.002) << flight;
    EXPECT_EQ(json["frequency_response"]["instrument"], "excitation") << flight;
  }
}

// The flown servos have a delay beside lag and play, so the closed loop is off in each, in all by the same, and says
// so.
TEST_F(ModesOfTheLaw, AreKnownToTheClosedLoopFromThePlanInTheFlightLog) {
  const Words closed{"--loop", "closed", "--servo-lag", "0.026"};
  const auto published = identified(joined({"published"}, closed));
  EXPECT_NEAR(published["alpha_m2"].number(), 23.0, 2.5);
  for (const char* flight : {"integral", "integral/flight.csv", "integral/flight.ftl", "observer", "schedule"}) {
    const auto json = identified(joined({flight}, closed));
    EXPECT_NEAR(json["alpha_m2"].number(), published["alpha_m2"].number(), 0.5) << flight;
    EXPECT_NEAR(json["beta_m"].number(), published["beta_m"].number(), 0.2) << flight;
    EXPECT_NEAR(json["disturbance_deg"][0].number(), -4.9, 0.05) << flight;
    EXPECT_LT(json["mean_abs_angle_error_deg"].number(), 0.05) << flight;
    EXPECT_NE(json["remarks"].dump().find("So the model is incomplete"), std::string::npos) << json["remarks"];
    EXPECT_NE(json["remarks"].dump().find("the plan in the flight log"), std::string::npos) << json["remarks"];
  }
}

TEST_F(ModesOfTheLaw, ALogWithAnEstimateIsFlownWithItWhateverPlanIsGiven) {
  const auto by_hand = identified(
      {"integral", "--loop", "closed", "--servo-lag", "0.026", "--kp", "0.5", "--kd", "0.05", "--limit", "9"});
  const auto by_plan = identified({"integral", "--loop", "closed", "--servo-lag", "0.026"});
  EXPECT_EQ(by_hand["alpha_m2"], by_plan["alpha_m2"]);
  EXPECT_NE(by_hand["remarks"].dump().find("subtracted an estimate of the fin offset from its command"),
            std::string::npos)
      << by_hand["remarks"];
}

TEST_F(ModesOfTheLaw, ATableWithoutWhatTheyNeedIsRefused) {
  const auto without = [this](const std::string& column, const std::string& flight) {
    std::string table = content(*folder_ / (flight + "/flight.csv"));
    return table.replace(table.find(column), column.size(), "other");
  };
  folder_->write("older/flight.csv", without("offset_estimate_deg", "integral"));
  folder_->write("older/flight.ftl", content(*folder_ / "integral/flight.ftl"));
  const Outcome older = run({"older", "--vehicle", "tasha3_launch2", "--loop", "closed"});
  EXPECT_EQ(older.exit_code, 65) << older.out;
  EXPECT_NE(
      older.err.find("offset_estimate_deg is missing; the closed loop with a plan that rejects the offset needs it"),
      std::string::npos)
      << older.err;
  folder_->write("slow/flight.csv", without("speed_m_s", "schedule"));
  folder_->write("slow/flight.ftl", content(*folder_ / "schedule/flight.ftl"));
  const Outcome slow = run({"slow", "--vehicle", "tasha3_launch2", "--loop", "closed", "--speed", "70"});
  EXPECT_EQ(slow.exit_code, 65) << slow.out;
  EXPECT_NE(slow.err.find("speed_m_s is missing"), std::string::npos) << slow.err;
}

TEST_F(ModesOfTheLaw, ShareOneRollModel) {
  const Outcome joint = run({"published", "integral", "observer", "schedule", "--shared", "alpha,beta", "--window",
                             "0.9:8", "--json", "--out", "joint"});
  ASSERT_EQ(joint.exit_code, 0) << joint.err;
  const json::Value model = json::parse(joint.out);
  EXPECT_NEAR(model["alpha_m2"].number(), 23.0, 0.05);
  EXPECT_EQ(model["agree"], true);
  const Outcome held = run({"integral", "--validate", "joint", "--window", "0.9:8", "--out", "held"});
  EXPECT_EQ(held.exit_code, 0) << held.out << held.err;
}

}  // namespace
}  // namespace fantail::test
