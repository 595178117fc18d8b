// SPDX-License-Identifier: MIT
#include "input/scenario_file.hpp"
#include "look_away.hpp"
#include "predict/decision.hpp"
#include "test.hpp"

namespace fantail::predict {
namespace {

constexpr std::size_t runs_flown = 8;

Prediction predicted(std::vector<std::string> changes) {
  changes.insert(changes.end(), {"controller.entry=capture", "excitation.form=none"});
  const sim::Scenario flown = input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
  return predict(flown, read_tunnel_result(flown.tunnel_result.value(), {}), {.runs = runs_flown}, look_away);
}

// The second launch is at its largest dynamic pressure 3.08 s after lift-off, and burns out at 3.19 s with 82 m/s.
TEST(PredictedGate, SaysWhenItOpensHowTheRocketTurnsThenAndHowSoonItIsCaptured) {
  const Prediction p = predicted({"dormancy.until=max_dynamic_pressure"});
  EXPECT_EQ(p.opened.count, runs_flown);
  EXPECT_NEAR(p.gate_time_s.value().p50, 3.19, 0.03);
  EXPECT_NEAR(p.gate_speed_m_s.value().p50, 81.5, 0.5);
  EXPECT_LT(p.gate_rate_rad_s.value().p50, 0.0);
  EXPECT_LT(p.captured_after_s.value().p95, 1.2);
  const Criterion c = gate(p, 0.1).value();
  EXPECT_EQ(c.judgement, Judgement::met);
  EXPECT_NE(c.clause.find("the gate opens at 3.19 s, 151 m, 81 m/s through the air; the rocket then turns at -"),
            std::string::npos)
      << c.clause;
  EXPECT_NE(c.clause.find("The roll is captured in 8 of 8 runs, 95 % of them within 1.0"), std::string::npos)
      << c.clause;
  EXPECT_NEAR(p.speeds_m_s.front(), 20.0, 0.1);
}

TEST(PredictedGate, AboveTheApogeeIsANoGoThatSaysSoOnce) {
  const Prediction p = predicted({"dormancy.until=height"});
  EXPECT_FALSE(p.gate_time_s.has_value());
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.text.find("No go: the gate is not reached: the apogee of 42"), 0U) << d.text;
  EXPECT_NE(d.text.find("is below dormancy.height_m = 1500. Control never begins"), std::string::npos) << d.text;
  EXPECT_EQ(d.text.find("control does not begin"), std::string::npos) << d.text;
}

// The guide leans, and the rocket tilts past its limit while it waits; the height it would never reach.
TEST(PredictedGate, AboveTheApogeeIsSaidWhereTheTiltLimitEndsTheWait) {
  const Prediction p = predicted(
      {"dormancy.until=height", "flight.motion=six_dof", "launch_guide.tilt_deg=10", "run.tilt_limit_deg=20"});
  const Decision d = decide(p, {});
  EXPECT_NE(d.text.find("the gate is not reached: the apogee of "), std::string::npos) << d.text;
  EXPECT_NE(d.text.find("is below dormancy.height_m = 1500. Control never begins"), std::string::npos) << d.text;
  EXPECT_EQ(d.text.find("tilted too far"), std::string::npos) << d.text;
}

TEST(PredictedGate, ThatCanardsCannotStopTheRotationIsSaidWithTheRateThatRemains) {
  const Prediction p = predicted({"dormancy.until=max_dynamic_pressure", "controller.canard_limit_deg=2"});
  const Criterion c = gate(p, 0.9).value();
  EXPECT_NE(c.clause.find("8 of 8 runs the canards cannot stop the rotation: about "), std::string::npos) << c.clause;
}

TEST(PredictedGate, IsNoneOfAPlanThatWaitsForTheGuideAlone) {
  EXPECT_FALSE(gate(predicted({"dormancy.until=guide"}), 0.9).has_value());
}

}  // namespace
}  // namespace fantail::predict
