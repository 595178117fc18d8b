// SPDX-License-Identifier: MIT
// Random rockets, faults, plans and gains: each verdict is held against the truth columns, looked at by code that
// shares nothing with the report.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "report/verdict.hpp"
#include "seed.hpp"
#include "sil/random_launch.hpp"
#include "sil/truth_oracle.hpp"

namespace fantail::sil {
namespace {

using report::Outcome;

constexpr double degree = 3.14159265358979323846 / 180.0;

/// The IMU of a rocket with good fins dies late: control is cut short and little comes of it.
void draw_a_quiet_end(sim::Scenario& scenario, Draw& draw) {
  scenario.faults.push_back(
      {.device = sim::Device::imu, .how = sim::Behaviour::hangs, .from_s = draw.between(5.0, 9.0), .until_s = 40.0});
}

sim::Scenario random_launch(std::uint32_t seed) {
  Draw draw{seed};
  sim::Scenario scenario = random_rocket(draw);
  scenario.seed = seed;
  const bool ends_quietly = draw.chance(0.05);
  const double largest_offset_rad = (ends_quietly ? 0.5 : 12.0) * degree;
  const double offset_rad = draw.between(-largest_offset_rad, largest_offset_rad);
  scenario.disturbance = {{.time_s = 0.0, .angle_rad = offset_rad},
                          {.time_s = 1.7, .angle_rad = offset_rad + draw.between(-2.0, 2.0) * degree}};
  if (ends_quietly) {
    scenario.disturbance[1].angle_rad = offset_rad;
    draw_a_quiet_end(scenario, draw);
    return scenario;
  }
  for (double more = 0.5; draw.chance(more); more *= 0.5) {
    draw_fault(scenario, draw);
  }
  return scenario;
}

// ./dev soak asks for 50 000.
int flights() {
  const char* asked = std::getenv("FANTAIL_FLIGHTS");  // NOLINT(concurrency-mt-unsafe): there is one thread
  return asked != nullptr ? std::atoi(asked) : 200;
}

TEST(VerdictOracle, NoRandomFlightIsCalledWhatItWasNot) {
  const std::uint32_t first = test::seed();
  std::map<std::string, int> outcomes;
  for (int i = 0; i < flights(); ++i) {
    const std::uint32_t seed = first + static_cast<std::uint32_t>(i);
    const sim::Scenario scenario = random_launch(seed);
    const flight::Flight flight = fly::fly_scenario(scenario);
    const report::Verdict verdict = report::verdict(flight, report::figures(flight));
    const Oracle truth = look(flight);
    const std::string which = fmt::format("flight of seed {} ({}): {}", seed, i, verdict.text);
    ++outcomes[std::string{report::name(verdict.outcome)}];

    ASSERT_EQ(verdict.outcome == Outcome::no_control, !truth.controlled) << which;
    if (report::is_steady(verdict.outcome) || verdict.outcome == Outcome::oscillates) {
      EXPECT_TRUE(truth.steady()) << truth.largest_error_deg << ' ' << truth.end_before_apogee_s << ' ' << which;
    }
    if (verdict.outcome == Outcome::cut_short) {
      EXPECT_FALSE(truth.lasted(early_s - rounding_s)) << which;
      EXPECT_LE(truth.turned_after_deg, promised_deg + rounding_deg) << which;
    }
    if (verdict.outcome == Outcome::not_judged) {
      EXPECT_LT(truth.judged_s, least_judged_s + rounding_s) << which;
    }
    if (verdict.outcome == Outcome::not_held) {
      const bool spun = flight.unmeasured.spin_from_s.has_value();
      const bool left_later =
          !truth.lasted(early_s - rounding_s) && truth.turned_after_deg > promised_deg - rounding_deg;
      const bool overpowered = verdict.text.find("beyond what they can balance") != std::string::npos;
      EXPECT_TRUE(truth.largest_error_deg > promised_deg - rounding_deg || left_later || spun || overpowered) << which;
      if (overpowered) {
        constexpr double play_deg = 0.1;
        EXPECT_GT(truth.unbalanced_deg, -play_deg) << which;
      }
    }
  }
  for (const auto& [name, count] : outcomes) {
    fmt::print("{:5} {}\n", count, name);
  }
  if (flights() >= 200) {  // of all six the rarest is one in fifty
    EXPECT_GE(outcomes.size(), 5U) << "the draw has become one-sided";
  }
}

}  // namespace
}  // namespace fantail::sil
