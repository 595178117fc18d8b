// SPDX-License-Identifier: MIT
// Rockets that nobody here has made, each held against a judge that knows nothing but the truth and what was asked.
#include "sil/any_rocket.hpp"

#include <cstdlib>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "fly/fly_scenario.hpp"
#include "report/verdict.hpp"
#include "seed.hpp"
#include "sil/plain_judge.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

int rockets() {
  const char* asked = std::getenv("FANTAIL_FLIGHTS");  // NOLINT(concurrency-mt-unsafe): there is one thread
  return asked != nullptr ? std::atoi(asked) : 150;
}

TEST(VerdictOracle, NoRocketWhateverItIsIsCalledHeldAgainstTheTruth) {
  const std::uint32_t first = test::seed();
  std::map<std::string, int> outcomes;
  int could_be_held = 0;
  for (int i = 0; i < rockets(); ++i) {
    const std::uint32_t seed = first + static_cast<std::uint32_t>(i);
    Draw draw{seed};
    sim::Scenario scenario = any_rocket(draw);
    scenario.seed = seed;
    const flight::Flight flight = fly::fly_scenario(scenario);
    const report::Figures figures = report::figures(flight);
    const report::Verdict verdict = report::verdict(flight, figures);
    const PlainTruth truth = look_plainly(flight.rows, scenario.atmosphere.elevation_m);
    const double limit_deg = text::degrees(scenario.rest_limit_rad);
    const std::string which = fmt::format("rocket of seed {} ({}): {}", seed, i, verdict.text);
    const std::vector<std::string> contradictions = not_held_because(truth, limit_deg);
    ++outcomes[std::string{report::name(verdict.outcome)}];
    could_be_held += contradictions.empty() ? 1 : 0;

    if (verdict.outcome == report::Outcome::held) {
      EXPECT_TRUE(contradictions.empty()) << fmt::format("{}", fmt::join(contradictions, ", ")) << "; " << which;
    }
    if (report::is_steady(verdict.outcome)) {
      const std::vector<std::string> restless = not_steady_because(truth);
      EXPECT_TRUE(restless.empty()) << fmt::format("{}", fmt::join(restless, ", ")) << "; " << which;
    }
    // What the truth says plainly is in the figures, and in the words.
    if (truth.controlled && figures.mean_reference_error_rad) {
      EXPECT_NEAR(text::degrees(*figures.mean_reference_error_rad), truth.mean_deg, 0.01) << which;
    }
    if (truth.top_mach > 0.802) {
      EXPECT_TRUE(verdict.text.starts_with("Outside the model: up to Mach ")) << which;
    }
    if (truth.end_early_s > 0.503 && truth.turned_deg > 10.02) {
      EXPECT_EQ(verdict.outcome, report::Outcome::not_held) << truth.turned_deg << " deg after control; " << which;
    }
  }
  for (const auto& [name, count] : outcomes) {
    fmt::print("{:5} {}\n", count, name);
  }
  fmt::print("{:5} of {} might be called held by the truth alone\n", could_be_held, rockets());
  if (rockets() >= 100) {
    EXPECT_GE(outcomes["held"], rockets() / 50) << "the draw has become one-sided";
    EXPECT_GE(outcomes.size(), 6U) << "the draw has become one-sided";
  }
}

}  // namespace
}  // namespace fantail::sil
