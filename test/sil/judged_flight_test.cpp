// SPDX-License-Identifier: MIT
// A flight that is judged on the way is judged as the one whose rows were kept.
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/flown_run.hpp"
#include "input/scenario_file.hpp"
#include "report/results.hpp"
#include "seed.hpp"
#include "sil/random_launch.hpp"

namespace fantail::sil {
namespace {

sim::Scenario shipped(const char* name, const std::vector<std::string>& changes = {}) {
  return input::load_scenario(name, input::parse_overrides(changes));
}

/// The verdict, and every figure, note, event and margin of the summary; returns the outcome.
std::string expect_same(const sim::Scenario& scenario, const std::string& which) {
  flight::Flight kept = fly::fly_scenario(scenario);
  report::Figures figures = report::figures(kept);
  figures.side_deflection.reset();
  const report::Verdict verdict = report::verdict(kept, figures);
  const campaign::JudgedFlight judged = campaign::fly_and_judge(scenario);
  EXPECT_TRUE(judged.figures == figures) << which;
  EXPECT_EQ(judged.verdict.outcome, verdict.outcome) << which;
  EXPECT_EQ(judged.verdict.text, verdict.text) << which;
  EXPECT_EQ(judged.verdict.ended_early, verdict.ended_early) << which;
  kept.rows.clear();
  kept.side_moment_m3.reset();  // only rows have a use for it
  EXPECT_EQ(result::json(report::summary(judged.flight, judged.figures, judged.verdict)),
            result::json(report::summary(kept, figures, verdict)))
      << which;
  EXPECT_TRUE(judged.flight.rows.empty()) << which;
  return std::string{report::name(verdict.outcome)};
}

TEST(JudgedFlight, OfAShippedScenarioIsTheOneWhoseRowsAreKept) {
  for (const char* name : {"tasha3_launch1", "tasha3_launch2", "tasha3_launch2_integral", "tunnel_steps",
                           "tunnel_swirl_with", "tunnel_stability", "gimbal", "bench_canard1_stuck"}) {
    expect_same(shipped(name), name);
  }
}

TEST(JudgedFlight, InWindInTheTunnelAndBackOnThePadIsTheSame) {
  const std::vector<std::string> wind{"flight.motion=six_dof", "wind.speed_m_s=6", "wind.turbulence=0.1"};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    sim::Scenario scenario = shipped("tasha3_launch2", wind);
    scenario.seed = seed;
    expect_same(scenario, "in wind, seed " + std::to_string(seed));
  }
  expect_same(shipped("tunnel_steps", {"timing.log_period_s=0.01"}), "every tenth row");
  expect_same(shipped("tasha3_launch2", {"timing.arm_time_s=9"}), "refused to be armed");
  expect_same(shipped("tasha3_launch2", {"body.mass_kg=60"}), "never leaves the pad");
  expect_same(shipped("tasha3_launch2", {"controller.proportional_gain=3", "controller.derivative_gain_s=0.9"}),
              "oscillates");
}

TEST(JudgedFlight, WithResetsIsTheSame) {
  for (const double time_s : {0.1, 0.3, 2.0, 8.0}) {
    for (const sim::Reset& reset : {sim::Reset{}, sim::Reset{.cause = hal::ResetCause::brown_out},
                                    sim::Reset{.gap_s = 5.0}, sim::Reset{.memory = sim::MemoryAfterReset::lost}}) {
      sim::Scenario scenario = shipped("tasha3_launch2");
      scenario.faults.push_back({.device = sim::Device::processor, .how = reset, .from_s = time_s});
      expect_same(scenario, "reset at " + std::to_string(time_s));
    }
  }
}

TEST(JudgedFlight, OfRandomRocketsAndFaultsIsTheSame) {
  const std::uint32_t first = test::seed();
  std::map<std::string, int> outcomes;
  for (std::uint32_t i = 0; i < 60; ++i) {
    Draw draw{first + i};
    sim::Scenario scenario = random_rocket(draw);
    scenario.seed = i;
    const double offset_rad = draw.between(-0.2, 0.2);
    scenario.disturbance = {{.time_s = 0.0, .angle_rad = offset_rad},
                            {.time_s = 1.7, .angle_rad = offset_rad + draw.between(-0.03, 0.03)}};
    for (double more = 0.5; draw.chance(more); more *= 0.5) {
      draw_fault(scenario, draw);
    }
    ++outcomes[expect_same(scenario, "seed " + std::to_string(first + i))];
  }
  EXPECT_GE(outcomes.size(), 3U) << "they have too little in them";
}

}  // namespace
}  // namespace fantail::sil
