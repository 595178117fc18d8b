// SPDX-License-Identifier: MIT
#include "predict/roll_resonance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "stability/pitch_frequency.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using stability::near_resonance;
using text::degrees;
using text::fixed;

/// Over the air speed, of a steady roll.
double roll_rate_1_m(const TunnelStep& airframe, double fin_angle_rad) {
  return airframe.torque_m * fin_angle_rad / airframe.damping_m2;
}

}  // namespace

std::optional<RollResonance> roll_resonance(const sim::Scenario& scenario, const std::vector<Run>& runs,
                                            double canard_reach_rad) {
  if (!scenario.vehicle.airframe || runs.empty()) {
    return std::nullopt;
  }
  const auto frequency = stability::pitch_frequency(*scenario.vehicle.airframe, scenario.atmosphere.density_kg_m3(0.0));
  if (!frequency) {
    return std::nullopt;
  }
  RollResonance found{
      .least_frequency_1_m = frequency->least_1_m, .most_frequency_1_m = frequency->most_1_m, .runs = runs.size()};
  std::vector<double> at_least;
  std::vector<double> in_the_middle;
  std::vector<double> at_most;
  for (const Run& run : runs) {
    const double rate_1_m_rad = roll_rate_1_m(run.airframe, 1.0);
    at_least.push_back(found.least_frequency_1_m / rate_1_m_rad);
    in_the_middle.push_back(0.5 * (frequency->least_1_m + frequency->most_1_m) / rate_1_m_rad);
    at_most.push_back(found.most_frequency_1_m / rate_1_m_rad);
    const double offset_rad = std::abs(run.airframe.offset_end_rad);  // the one that stays
    const double free = roll_rate_1_m(run.airframe, offset_rad);
    const double driven = roll_rate_1_m(run.airframe, offset_rad + canard_reach_rad);
    const bool comes_near = free > (1.0 - near_resonance) * found.least_frequency_1_m;
    const bool is_past = free > (1.0 + near_resonance) * found.most_frequency_1_m;
    found.near += comes_near && !is_past ? 1 : 0;
    found.past += is_past ? 1 : 0;
    found.with_canards += driven > (1.0 - near_resonance) * found.least_frequency_1_m ? 1 : 0;
  }
  const campaign::Quantiles middle = campaign::quantiles(std::move(in_the_middle));
  found.resonant_rad = {.mean = middle.mean,
                        .p5 = campaign::quantiles(std::move(at_least)).p5,
                        .p50 = middle.p50,
                        .p95 = campaign::quantiles(std::move(at_most)).p95};
  return found;
}

std::string warning(const RollResonance& r, double canard_reach_rad) {
  if (r.with_canards == 0) {
    return {};
  }
  const auto of_runs = [&r](std::size_t count) { return fmt::format("{} of {}", count, text::counted(r.runs, "run")); };
  const campaign::Quantiles& angle = r.resonant_rad;
  return fmt::format(
      "Roll resonance: a fin or canard angle of {} degrees ({} to {}) makes the roll rate equal to the pitch "
      "frequency. That holds at any speed (frequency / speed {} to {} rad/m from lift-off to burn-out). Without "
      "control, the fin offset would keep {} near that rate and spin {} through it. With the canards at {} degrees in "
      "the sense of the offset, {} come near it. There, small misalignments multiply the angle of attack, and the roll "
      "may lock in (Hoult and Tran, Sounding Rocket Fin Design to Mitigate Roll Lock-In). The simulated roll includes "
      "neither this nor the angle of attack.",
      fixed(degrees(angle.p50), 1), fixed(degrees(angle.p5), 1), fixed(degrees(angle.p95), 1),
      fixed(r.least_frequency_1_m, 3), fixed(r.most_frequency_1_m, 3), of_runs(r.near), of_runs(r.past),
      fixed(degrees(canard_reach_rad), 1), of_runs(r.with_canards));
}

std::string caution(const RollResonance& r) {
  return fmt::format(
      "roll resonance, a roll rate within {} % of the pitch frequency, is reached in {} of {} without control. "
      "With the canards at their limit, {} reach it. Straighter fins and a smaller canard limit keep the roll rate "
      "farther from it. fantail campaign hardover flies a failed canard",
      fixed(100.0 * near_resonance, 0), r.near + r.past, text::counted(r.runs, "run"), r.with_canards);
}

std::string in_short(const RollResonance& r, double canard_reach_rad) {
  return fmt::format(
      "Roll resonance, a roll rate within {} % of the pitch frequency: {} of {} reach it without control. {} reach it "
      "with the canards at {} degrees in the sense of the fin offset, as after a failure. Straighter fins and a "
      "smaller canard limit keep the roll rate farther from it. fantail campaign hardover flies a failed canard.",
      fixed(100.0 * near_resonance, 0), r.near + r.past, text::counted(r.runs, "run"), r.with_canards,
      fixed(degrees(canard_reach_rad), 1));
}

}  // namespace fantail::predict
