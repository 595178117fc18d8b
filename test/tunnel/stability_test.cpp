// SPDX-License-Identifier: MIT
#include "tunnel/stability.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures.hpp"
#include "seed.hpp"
#include "sim/random.hpp"
#include "tunnel/swing.hpp"

namespace fantail::tunnel {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

// A push at `push_s`, then c + A exp(-s t) sin(w t) with noise; 100 Hz.
void add_swing(SwingLog& log, double push_s, double end_s, double decay, double frequency, double size, double noise,
               sim::Random& random) {
  for (double t = log.time_s.empty() ? 0.0 : log.time_s.back() + 0.01; t < end_s; t += 0.01) {
    const double after = t - push_s;
    const double swing = after < 0.0 ? 0.0 : size * std::exp(-decay * after) * std::cos(frequency * after);
    log.time_s.push_back(t);
    log.value.push_back(swing + noise * random.gaussian());
    log.angle_rad.push_back(0.0);
  }
}

TEST(Swing, IsFoundWithItsFrequencyDampingAndDecrement) {
  sim::Random random{5, 1};
  SwingLog log;
  add_swing(log, 2.0, 20.0, 0.2, 1.5, 3.0 * degrees, 0.02 * degrees, random);
  const std::vector<SwingStretch> found = find_swings(log);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].begin_s, 2.0, 0.2);
  const SwingResult result = fit_swing(log, found[0]);
  ASSERT_TRUE(result.swing.has_value()) << result.reason;
  EXPECT_NEAR(result.swing->frequency_rad_s.value, 1.5, 0.005);
  EXPECT_NEAR(result.swing->decay_per_s.value, 0.2, 0.005);
  EXPECT_NEAR(result.swing->stiffness_per_s2.value, 1.5 * 1.5 + 0.2 * 0.2, 0.015);
  EXPECT_NEAR(result.swing->damping_ratio.value, 0.2 / std::hypot(0.2, 1.5), 0.003);
  EXPECT_NEAR(result.swing->logarithmic_decrement, 2.0 * std::numbers::pi * 0.2 / 1.5, 0.02);
}

TEST(Swing, EachPushBeginsOne) {
  sim::Random random{6, 1};
  SwingLog log;
  add_swing(log, 2.0, 20.0, 0.2, 1.2, 3.0 * degrees, 0.02 * degrees, random);
  add_swing(log, 25.0, 40.0, 0.25, 1.6, 2.0 * degrees, 0.02 * degrees, random);
  add_swing(log, 45.0, 60.0, 0.3, 2.3, 4.0 * degrees, 0.02 * degrees, random);
  ASSERT_EQ(find_swings(log).size(), 3U);
  EXPECT_NEAR(fit_swing(log, find_swings(log)[2]).swing.value().frequency_rad_s.value, 2.3, 0.01);
}

TEST(Swing, OneThatGrowsIsNamed) {
  sim::Random random{7, 1};
  SwingLog log;
  add_swing(log, 0.0, 20.0, -0.1, 1.5, 0.5 * degrees, 0.01 * degrees, random);
  const SwingResult result = fit_swing(log, {.begin_s = 0.0, .end_s = 20.0});
  EXPECT_TRUE(result.grows);
  EXPECT_FALSE(result.swing.has_value());
}

std::string first_figure(const std::string& sentence) { return figures(sentence).at(0); }

TEST(Swing, OneThatIsTooShortOrLostSaysSo) {
  sim::Random random{8, 1};
  SwingLog log;
  add_swing(log, 0.0, 20.0, 0.2, 1.5, 3.0 * degrees, 0.02 * degrees, random);
  // A period of 1.5 rad/s is 4.2 s.
  EXPECT_EQ(figures(fit_swing(log, {.begin_s = 0.0, .end_s = 2.0}).reason), (Numbers{"2.0", "4.2"}));
  EXPECT_NE(fit_swing(log, {.begin_s = 0.0, .end_s = 0.1}).reason.find("only 11 samples"), std::string::npos);
  SwingLog dead;
  add_swing(dead, 0.0, 20.0, 3.0, 1.5, 0.3 * degrees, 0.1 * degrees, random);
  EXPECT_FALSE(fit_swing(dead, {.begin_s = 0.0, .end_s = 20.0}).swing.has_value());
}

TEST(Swing, NoiseIsNone) {
  sim::Random random{test::seed(17), 1};
  for (int i = 0; i < 50; ++i) {
    SwingLog log;
    add_swing(log, 0.0, 60.0, 0.2, 1.5, 0.0, 0.05 * degrees, random);
    for (const SwingStretch& stretch : find_swings(log)) {
      const SwingResult result = fit_swing(log, stretch);
      EXPECT_FALSE(result.grows);
      EXPECT_FALSE(result.swing);
    }
  }
}

/// The rate of a rocket that is at `angle_deg(t)` until it hangs at its tether, at 40 degrees.
SwingLog leaving(const std::function<double(double)>& angle_deg) {
  SwingLog log;
  for (double t = 0.0; t < 30.0; t += 0.01) {
    const double now = std::min(angle_deg(t), 40.0);
    log.time_s.push_back(t);
    log.angle_rad.push_back(now * degrees);
    log.value.push_back((std::min(angle_deg(t + 0.01), 40.0) - now) / 0.01 * degrees);
  }
  return log;
}

TEST(Swing, ARocketThatLeavesEverFasterIsUnstableAndOneThatWasPushedIsNot) {
  const SwingStretch all{.begin_s = 0.0, .end_s = 30.0};
  const SwingResult unstable = fit_swing(leaving([](double t) { return 0.05 * std::exp(0.8 * t); }), all);
  EXPECT_TRUE(unstable.grows);
  EXPECT_TRUE(says(unstable.reason, "away")) << unstable.reason;
  for (const auto& pushed :
       {std::function<double(double)>{[](double t) { return t < 5.0 ? 0.0 : 20.0 * (t - 5.0); }},
        std::function<double(double)>{[](double t) { return t < 5.0 ? 0.0 : 5.0 * (t - 5.0) * (t - 5.0); }},
        std::function<double(double)>{
            [](double t) { return t < 5.0 ? 0.0 : 40.0 * std::sin(0.8 * std::min(t - 5.0, 1.9)); }}}) {
    const SwingResult result = fit_swing(leaving(pushed), all);
    EXPECT_FALSE(result.grows);
    EXPECT_TRUE(result.is_too_large);
  }
}

// 95 % of the intervals should hold the truth: of 400, 380; 14 are three deviations of that count.
TEST(Swing, ItsIntervalsHoldTheTruthAsOftenAsTheySay) {
  sim::Random random{test::seed(20261123), 1};
  int stiffness = 0;
  int damping = 0;
  constexpr int records = 400;
  for (int i = 0; i < records; ++i) {
    SwingLog log;
    const double frequency = 1.0 + 1.5 * random.uniform();
    const double decay = 0.15 * frequency;
    add_swing(log, 0.0, 15.0, decay, frequency, (1.0 + 3.0 * random.uniform()) * degrees, 0.05 * degrees, random);
    const Swing swing = fit_swing(log, {.begin_s = 0.0, .end_s = 15.0}).swing.value();
    const double truth = frequency * frequency + decay * decay;
    stiffness += std::abs(swing.stiffness_per_s2.value - truth) < reach_95 * swing.stiffness_per_s2.deviation ? 1 : 0;
    damping +=
        std::abs(swing.damping_ratio.value - decay / std::sqrt(truth)) < reach_95 * swing.damping_ratio.deviation;
  }
  std::printf("stiffness %.1f %%, damping ratio %.1f %%\n", 100.0 * stiffness / records, 100.0 * damping / records);
  EXPECT_NEAR(stiffness, 380, 14);
  EXPECT_NEAR(damping, 380, 14);
}

// I_y 0.6 kg m2, CN 10 on a body of 80 mm: a margin of 0.12 m makes 1.165, 1.553 and 2.330 rad/s.
const PitchAirframe airframe{.transverse_inertia_kg_m2 = 0.6,
                             .normal_force_slope_per_rad = 10.0,
                             .cross_section_m2 = std::numbers::pi * 0.04 * 0.04,
                             .diameter_m = 0.08,
                             .mass_kg = 3.99};

StabilitySwing swing_at(double speed_m_s, double margin_m, double held_n_m_per_rad) {
  const double air = 0.5 * 1.2 * speed_m_s * speed_m_s * airframe.cross_section_m2 * 10.0 * margin_m;
  Swing swing{.stiffness_per_s2 = {(air + held_n_m_per_rad) / 0.6, 0.01}};
  return {.speed_m_s = speed_m_s, .result = {.swing = swing}};
}

TEST(Stability, TheSlopeOverTheSquareOfTheSpeedIsTheMarginAndTheInterceptTheStrings) {
  const Stability s =
      examine_stability({swing_at(15, 0.12, 0.2), swing_at(20, 0.12, 0.2), swing_at(30, 0.12, 0.2)}, airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::stable);
  EXPECT_NEAR(s.margin_m.value().value, 0.12, 1e-9);
  EXPECT_NEAR(s.without_wind_n_m_per_rad.value().value, 0.2, 1e-9);
  EXPECT_EQ(first_figure(s.sentence), "120") << s.sentence;
  EXPECT_NE(s.sentence.find("1.5 calibres"), std::string::npos);
}

TEST(Stability, SaysWhetherTheAirWasTooTurbulentForItsIntervalsOrThatNobodyKnows) {
  const auto with_air = [](std::optional<Unsteadiness> slow, std::optional<Unsteadiness> fast) {
    std::vector<StabilitySwing> swings{swing_at(15, 0.12, 0.2), swing_at(20, 0.12, 0.2), swing_at(30, 0.12, 0.2)};
    swings[0].air = slow;
    swings[1].air = slow;
    swings[2].air = fast;
    return examine_stability(std::move(swings), airframe, 1.2).remarks.back();
  };
  const Unsteadiness calm{.share = 0.003, .rounding_share = 0.001};
  const std::string little = with_air(calm, {{.share = 0.009}});
  EXPECT_EQ(first_figure(little), "0.9") << little;
  EXPECT_FALSE(says(little, "rounding") || says(little, "narrow")) << little;
  const std::string rounded =
      with_air({{.share = 0.0, .rounding_share = 0.002}}, {{.share = 0.0, .rounding_share = 0.001}});
  EXPECT_TRUE(first_figure(rounded) == "0.2" && says(rounded, "rounding")) << rounded;
  const std::string much = with_air({{.share = 0.011}}, calm);
  EXPECT_TRUE(first_figure(much) == "1.1" && says(much, "narrow")) << "the intervals are; " << much;
  const std::string unknown = with_air(calm, {});
  EXPECT_TRUE(first_figure(unknown) == "30.0" && says(unknown, "tunnel.csv")) << unknown;
}

// Pins 95 mm in front of the centre of gravity hold the rocket as strings of m g 0.095 would.
TEST(Stability, ARocketThatOnlyItsPinsMakeStableIsNotCalledStable) {
  const double held_n_m_per_rad = 3.99 * 9.80665 * 0.095;
  const Stability s = examine_stability({swing_at(15, 0.075, held_n_m_per_rad), swing_at(20, 0.075, held_n_m_per_rad),
                                         swing_at(30, 0.075, held_n_m_per_rad)},
                                        airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::unsure);
  EXPECT_TRUE(first_figure(s.sentence) == "75" && says(s.sentence, "pins")) << s.sentence;
}

// 5 mm between pins and centre of gravity are 24 % of the stiffness at 15 m/s.
TEST(Stability, OneSpeedProvesNothing) {
  const Stability s = examine_stability({swing_at(15, 0.12, 0.0)}, airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::unsure);
  EXPECT_FALSE(s.margin_m);
  EXPECT_TRUE(says(s.sentence, "one speed")) << s.sentence;
  ASSERT_EQ(s.remarks.size(), 1U);
  const Numbers alone = figures(s.remarks[0]);
  EXPECT_FALSE(std::ranges::search(alone, Numbers{"24", "15.0"}).empty()) << s.remarks[0];
}

// An anemometer that showed zero all along makes no line.
TEST(Stability, SwingsInAirThatStandsStillAreAtNoSpeed) {
  const Stability s =
      examine_stability({swing_at(0, 0.12, 0.2), swing_at(0, 0.12, 0.2), swing_at(0, 0.12, 0.2)}, airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::unsure);
  EXPECT_FALSE(s.margin_m);
  EXPECT_TRUE(says(s.sentence, "one speed")) << s.sentence;
}

// It swings at every speed, and faster the slower the wind is: the strings hold it.
TEST(Stability, ARocketThatOnlyItsStringsHoldIsUnstable) {
  const Stability s =
      examine_stability({swing_at(10, -0.02, 1.0), swing_at(15, -0.02, 1.0), swing_at(20, -0.02, 1.0)}, airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::unstable);
  EXPECT_TRUE(first_figure(s.sentence) == "20" && says(s.sentence, "front")) << s.sentence;
}

TEST(Stability, ASwingThatGrowsIsUnstableWhateverTheOthersSay) {
  std::vector<StabilitySwing> swings{swing_at(15, 0.12, 0.0), swing_at(20, 0.12, 0.0)};
  swings.push_back({.speed_m_s = 30.0,
                    .result = {.stretch = {.begin_s = 12.0, .end_s = 14.0}, .grows = true, .reason = "it grows"}});
  const Stability s = examine_stability(swings, airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::unstable);
  EXPECT_EQ(figures(s.sentence), (Numbers{"30.0", "12.0"})) << s.sentence;
  EXPECT_TRUE(says(s.sentence, swings.back().result.reason)) << s.sentence;
}

TEST(Stability, AMarginThatMayBeEitherWayIsNotJudged) {
  const Stability s = examine_stability({swing_at(15, 0.0005, 0.3), swing_at(20, 0.0005, 0.3)}, airframe, 1.2);
  EXPECT_EQ(s.verdict, StabilityVerdict::unsure);
  EXPECT_TRUE(says(s.sentence, "stable or unstable")) << s.sentence;
}

}  // namespace
}  // namespace fantail::tunnel
