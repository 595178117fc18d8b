// SPDX-License-Identifier: MIT
#include "paper/tunnel_step.hpp"

#include "input/scenario_file.hpp"
#include "test.hpp"

namespace fantail::paper {
namespace {

sim::Scenario tunnel() { return input::load_scenario("tunnel_steps", {}); }

TEST(ReadBack, FollowsThePrintedNumbersWhateverTheyAre) {
  PublishedStep row = published_steps().front();
  row.alpha_m2 += 4.0;
  row.beta_m -= 1.5;
  row.disturbance_begin_deg += 1.0;
  const ReadBack ours = read_back(row, tunnel());
  EXPECT_EQ(ours.found.model.alpha_m2, row.alpha_m2);
  EXPECT_EQ(ours.found.model.beta_m, row.beta_m);
  const Claim claim = compare(row, ours);
  EXPECT_TRUE(claim.agrees) << claim.ours;
  EXPECT_EQ(claim.kind, Kind::read_back);
  EXPECT_FALSE(counts_as_reproduced(claim.kind));
}

TEST(ReadBack, OffTheGridTheSearchCannotFindItAgain) {
  PublishedStep row = published_steps().front();
  row.beta_m += 0.2;
  EXPECT_FALSE(compare(row, read_back(row, tunnel())).agrees);
}

// A second-order step whose overshoot is known in closed form, far from the limit: x'' + a x' + g kd x' + g kp x = 0.
TEST(StepShape, OfASmallStepIsThatOfASecondOrderSystem) {
  const sim::Scenario scenario = tunnel();
  const TunnelStep small{.alpha_m2 = 19.4, .beta_m = 9.6, .from_deg = 0.0, .to_deg = 2.0};
  const sim::RollPlant plant{.inertia_kg_m2 = scenario.vehicle.roll_plant.inertia_kg_m2,
                             .reference_area_m2 = scenario.vehicle.roll_plant.reference_area_m2,
                             .damping_m2 = small.alpha_m2,
                             .torque_m = small.beta_m};
  const double a = plant.damping_rate_per_s(scenario.tunnel.density_kg_m3, 22.0);
  const double g = plant.authority_per_s2(scenario.tunnel.density_kg_m3, 22.0);
  const double omega = std::sqrt(0.5 * g);
  const double zeta = (a + 0.05 * g) / (2.0 * omega);
  ASSERT_LT(zeta, 1.0);
  const double overshoot_deg = 2.0 * std::exp(-3.14159265358979 * zeta / std::sqrt(1.0 - zeta * zeta));
  EXPECT_NEAR(shape_of(fly_step(small, scenario)).overshoot_deg, overshoot_deg, 0.002);
}

}  // namespace
}  // namespace fantail::paper
