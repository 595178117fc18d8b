// SPDX-License-Identifier: MIT
// What takes the green from a go, or the go itself, without a run that was lost.

#include "input/scenario_file.hpp"
#include "predict/decision.hpp"
#include "test.hpp"

namespace fantail::predict {
namespace {

/// 200 runs that leave nothing to be desired.
Prediction all_held() {
  Prediction p;
  p.reach.angle_rad = text::radians(9.0);
  p.flown = input::load_scenario("tasha3_launch2", {});
  p.runs.resize(200, {.authority_margin_rad = text::radians(4.9), .outcome = report::Outcome::held});
  p.authority = share(200, 200);
  p.held = share(200, 200);
  p.offset_size_rad = {.p50 = text::radians(4.1)};
  p.worst_speed = MarginsAtSpeed{.speed_m_s = 81.6, .phase_margin_rad = {.p5 = text::radians(45.4)}};
  return p;
}

Judgement judgement_of(const Decision& decision, std::string_view key) {
  return std::ranges::find(decision.criteria, key, &Criterion::key)->judgement;
}

// 200 runs that rest 70.7 degrees away are none that is held, and the sentence says how far and what was asked.
TEST(Caution, ARollThatRestsFarFromItsCommandIsNoGo) {
  Prediction p = all_held();
  p.held = share(0, 200);
  for (predict::Run& run : p.runs) {
    run.outcome = report::Outcome::off_command;
    run.verdict =
        "Steady, 70.7 deg from the command (10 deg is the limit): roll stayed within 1.2 deg of where this law "
        "settles.";
  }
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.text,
            "No go: roll is held in none of the runs, in all runs the roll rests too far from its command (run 0: "
            "Steady, 70.7 deg from the command (10 deg is the limit)).");
}

TEST(Caution, FasterThanTheModelHoldsForIsNotJudgedAndNoGo) {
  Prediction p = all_held();
  p.held = share(0, 200);
  p.outside_model = 200;
  for (predict::Run& run : p.runs) {
    run.outcome = report::Outcome::outside_model;
    run.extremes.top_mach = 1.27;
  }
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(
      d.text,
      "No go: outside the model: 200 of 200 runs are faster than Mach 0.8, up to Mach 1.27, and the simulation of "
      "roll ends there.");
  EXPECT_EQ(judgement_of(d, "model"), Judgement::not_judged);
  EXPECT_EQ(judgement_of(d, "held"), Judgement::not_judged);
}

// An unstable rocket has no pitch frequency, so that nothing is near a resonance: it must not look better for that.
TEST(Caution, ARocketThatIsNotStableIsNotJudgedAndNoGo) {
  Prediction p = all_held();
  p.held = share(0, 200);
  p.outside_model = 200;
  for (predict::Run& run : p.runs) {
    run.outcome = report::Outcome::outside_model;
    run.extremes.static_margin_calibres = -5.0;
  }
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(d.text,
            "No go: outside the model: 200 of 200 runs are of a rocket that is not stable, with a static margin down "
            "to -5.00 calibres, "
            "and the simulation of roll ends there.");
  EXPECT_EQ(judgement_of(d, "model"), Judgement::not_judged);
  EXPECT_EQ(judgement_of(d, "held"), Judgement::not_judged);
}

// The wind of a run is drawn: one that blows hard counts as one that is not held, as any other loss.
TEST(Caution, AFewRunsInAirFromTheSideAreACautionAndManyNoGo) {
  Prediction p = all_held();
  const auto blown = [&p](std::size_t runs) {
    for (std::size_t i = 0; i < runs; ++i) {
      p.runs[i].outcome = report::Outcome::outside_model;
      p.runs[i].extremes.angle_of_attack_rad = text::radians(20.3);
    }
    p.outside_model = runs;
    p.held = share(200 - runs, 200);
    return decide(p, {});
  };
  const Decision few = blown(2);
  EXPECT_EQ(few.heading(), "Go with caution");
  EXPECT_TRUE(
      few.text.ends_with("; but outside the model: 2 of 200 runs meet the air at more than 15 deg, with an "
                         "angle of attack of up to 20.3 deg under control, and the simulation of roll ends "
                         "there."))
      << few.text;
  EXPECT_FALSE(blown(60).go);
  EXPECT_EQ(judgement_of(blown(60), "model"), Judgement::not_judged);
}

TEST(Caution, AGoWithLittleStaticMarginSaysSoInItsHeadline) {
  Prediction p = all_held();
  for (predict::Run& run : p.runs) {
    run.extremes.static_margin_calibres = 0.25;
  }
  const Decision d = decide(p, {});
  EXPECT_EQ(d.heading(), "Go with caution");
  EXPECT_TRUE(d.text.ends_with("; but the static margin is down to 0.25 calibres, and 1 is usual.")) << d.text;
  for (predict::Run& run : p.runs) {
    run.extremes.static_margin_calibres = 1.0;
  }
  EXPECT_EQ(decide(p, {}).heading(), "Go");
}

TEST(Caution, AGoOfARocketWithoutAirframeSaysWhatIsUnknown) {
  Prediction p = all_held();
  p.flown.vehicle.airframe.reset();
  const Decision d = decide(p, {});
  EXPECT_EQ(d.heading(), "Go with caution");
  EXPECT_TRUE(
      d.text.ends_with("; but static margin and roll resonance are unknown, because the vehicle has no "
                       "[airframe]."))
      << d.text;
}

TEST(Caution, AGoNearRollResonanceSaysSoInItsHeadline) {
  Prediction p = all_held();
  p.resonance = RollResonance{.near = 3, .past = 9, .with_canards = 200, .runs = 200};
  const Decision d = decide(p, {});
  EXPECT_TRUE(d.go);
  EXPECT_EQ(d.heading(), "Go with caution");
  EXPECT_TRUE(d.text.starts_with("Go with caution: ")) << d.text;
  EXPECT_TRUE(
      d.text.ends_with("; but roll resonance, a roll rate equal to the pitch frequency, is reached in 12 of 200 "
                       "runs without control, and in 200 with the canards at their limit."))
      << d.text;
  p.resonance->with_canards = 0;
  EXPECT_EQ(decide(p, {}).heading(), "Go");
}

}  // namespace
}  // namespace fantail::predict
