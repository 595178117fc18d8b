// SPDX-License-Identifier: MIT
// What takes the green from a go, or the go itself, without a run that was lost.

#include "figures.hpp"
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

TEST(Caution, HeldRunsThatRestOnTheTiltLimitsAllowanceAreCounted) {
  Prediction p = all_held();
  p.runs[3].allowed_tilt_end_s = 7.4;
  p.runs[5].allowed_tilt_end_s = 2.0;
  EXPECT_NE(decide(p, {}).text.find("In 2 of 200 held runs the tilt limit ended control up to 7.40 s before apogee, "
                                    "which verdict.tilt_end_before_apogee_s allows"),
            std::string::npos);
}

// 200 runs that rest 70.7 degrees away are none that is held, and the decision says how far and what was asked.
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
  EXPECT_EQ(judgement_of(d, "held"), Judgement::not_met);
  EXPECT_EQ(figures(d.text), (Numbers{"0", "70.7", "10"}));
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
  EXPECT_EQ(figures(d.text), (Numbers{"200", "200", "0.8", "1.27"}));
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
  EXPECT_EQ(figures(d.text), (Numbers{"200", "200", "-5.00"}));
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
  ASSERT_EQ(few.cautions.size(), 1U);
  EXPECT_EQ(figures(few.cautions[0]), (Numbers{"2", "200", "15", "20.3"}));
  EXPECT_TRUE(few.text.ends_with(few.cautions[0] + ".")) << few.text;
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
  EXPECT_TRUE(d.text.ends_with(" Caution: the static margin falls to 0.25 calibres, and 1 is usual.")) << d.text;
  for (predict::Run& run : p.runs) {
    run.extremes.static_margin_calibres = 1.0;
  }
  EXPECT_EQ(decide(p, {}).heading(), "Go");
}

TEST(Caution, NumbersAreNotRoundedToTheLimitThatTheyMiss) {
  Prediction p = all_held();
  p.runs[3].extremes.static_margin_calibres = 0.998;
  EXPECT_EQ(figures(decide(p, {}).cautions.at(0)), (Numbers{"0.998", "1"}));
  p.runs[3].extremes = {.top_mach = 0.801};
  p.outside_model = 1;
  EXPECT_EQ(figures(within_model(p).value().found), (Numbers{"1", "200", "0.8", "0.801"}));
}

// 58 of 60 degrees: a little more wind would have ended control, and a go said nothing of it.
TEST(Caution, AGoNearTheTiltLimitNamesTheTilt) {
  Prediction p = all_held();
  p.flown.motion = sim::FlightMotion::six_dof;
  p.runs[11].largest_tilt_rad = text::radians(58.0);
  const Decision d = decide(p, {});
  EXPECT_EQ(d.heading(), "Go with caution");
  ASSERT_EQ(d.cautions.size(), 1U);
  EXPECT_EQ(figures(d.cautions[0]), (Numbers{"58.0", "60"}));
  EXPECT_TRUE(d.text.ends_with(d.cautions[0] + ".")) << d.text;
  EXPECT_NE(d.text.find("from the vertical"), std::string::npos) << d.text;
  p.flown.plan.run.tilt_from = core::TiltOrigin::guide;
  EXPECT_NE(tilt_caution(p).find("from the launch guide"), std::string::npos) << tilt_caution(p);
  p.runs[11].largest_tilt_rad = text::radians(59.97);
  EXPECT_EQ(figures(tilt_caution(p)), (Numbers{"59.97", "60"}));
  p.runs[11].largest_tilt_rad = text::radians(54.9);
  EXPECT_EQ(tilt_caution(p), "");
  p.runs[11].largest_tilt_rad = text::radians(61.0);
  EXPECT_EQ(figures(tilt_caution(p)), (Numbers{"61.0", "60"})) << "the avionics measured less";
  p.runs[11].ended_by_tilt = true;
  EXPECT_EQ(tilt_caution(p), "") << "such a run is named as one that ends early";
}

TEST(Caution, ControlThatBeginsInTheLaunchGuideIsNoGo) {
  Prediction p = all_held();
  p.runs[3].begun_on_guide_s = 0.25;
  p.runs[9].begun_on_guide_s = 0.125;
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(judgement_of(d, "guide"), Judgement::not_met);
  EXPECT_EQ(figures(d.text), (Numbers{"2", "200", "0.250"}));
  EXPECT_NE(d.text.find("check guide.length_m in the plan"), std::string::npos) << d.text;
}

// 73 of 73 is the least that can promise 95 %: 73 / (73 + 1.96^2) = 0.950.
TEST(Caution, RunsThatAreTooFewToTellAreNoGo) {
  Prediction p = all_held();
  p.authority = share(72, 72);
  const Decision d = decide(p, {});
  EXPECT_FALSE(d.go);
  EXPECT_EQ(figures(d.text), (Numbers{"72", "95", "4.1", "9"}));
  EXPECT_NE(d.text.find("--runs"), std::string::npos) << d.text;
  EXPECT_EQ(judgement_of(d, "authority"), Judgement::not_judged) << "all of them, which is not a no";
  EXPECT_NE(d.criteria[0].found.find("too few runs"), std::string::npos);
  p.authority = share(68, 72);
  EXPECT_EQ(judgement_of(decide(p, {}), "authority"), Judgement::not_met) << "94.4 %";
  p.authority = share(72, 72);
  p.held = share(100, 200);
  const std::string text = decide(p, {}).text;
  EXPECT_LT(text.find("only 50 %"), text.find("too few")) << "what is wrong comes first: " << text;
  p.held = share(200, 200);
  p.authority = share(73, 73);
  EXPECT_TRUE(decide(p, {}).go);
}

// Every run in the same wind of 3 m/s was a go that did not name it; in 4 m/s give or take 1.5 it was a no go.
TEST(Caution, AGoInAWindThatDoesNotVaryNamesItAndWhatVariesIt) {
  Prediction p = all_held();
  p.flown.wind.speed_m_s = 3.0;
  EXPECT_EQ(decide(p, {}).heading(), "Go") << "along a straight line no wind is simulated";
  p.flown.motion = sim::FlightMotion::six_dof;
  const Decision d = decide(p, {});
  EXPECT_EQ(d.heading(), "Go with caution");
  ASSERT_EQ(d.cautions.size(), 1U);
  EXPECT_EQ(figures(d.cautions[0]), Numbers{"3"});
  EXPECT_NE(d.cautions[0].find("--set wind.speed_spread_m_s="), std::string::npos) << d.cautions[0];
  p.flown.wind_spread.direction_rad = 1.0;
  EXPECT_EQ(decide(p, {}).cautions.size(), 1U) << "its speed is still the same in all runs";
  p.flown.wind_spread = {.speed_m_s = 1.5};
  EXPECT_EQ(decide(p, {}).heading(), "Go");
  p.flown.wind_spread = {};
  p.flown.wind.speed_m_s = 0.0;
  EXPECT_EQ(decide(p, {}).heading(), "Go");
}

TEST(Caution, AGoOfARocketWithoutAirframeSaysWhatIsUnknown) {
  Prediction p = all_held();
  p.flown.vehicle.airframe.reset();
  const Decision d = decide(p, {});
  EXPECT_EQ(d.heading(), "Go with caution");
  ASSERT_EQ(d.cautions.size(), 1U);
  EXPECT_NE(d.text.find("[airframe]"), std::string::npos) << d.text;
}

TEST(Caution, AGoNearRollResonanceSaysSoInItsHeadline) {
  Prediction p = all_held();
  p.resonance = RollResonance{.near = 3, .past = 9, .with_canards = 200, .runs = 200};
  const Decision d = decide(p, {});
  EXPECT_TRUE(d.go);
  EXPECT_EQ(d.heading(), "Go with caution");
  EXPECT_TRUE(d.text.starts_with("Go with caution: ")) << d.text;
  ASSERT_EQ(d.cautions.size(), 1U);
  EXPECT_EQ(figures(d.cautions[0]), (Numbers{"25", "12", "200", "200"}));
  EXPECT_TRUE(d.text.ends_with(d.cautions[0] + ".")) << d.text;
  p.resonance->with_canards = 0;
  EXPECT_EQ(decide(p, {}).heading(), "Go");
}

}  // namespace
}  // namespace fantail::predict
