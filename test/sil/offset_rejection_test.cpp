// SPDX-License-Identifier: MIT
// The second launch, with its fin offset of -4.9 degrees, flown with each mode of the law (docs/control.md).
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

constexpr double offset_deg = -4.9;

flight::Flight fly(const std::string& scenario, const std::vector<std::string>& changes = {}) {
  return fly::fly_scenario(input::load_scenario(scenario, input::parse_overrides(changes)));
}

const std::vector<std::string> observed{"offset.rejection=observer", "roll_model.roll_inertia_kg_m2=0.00393",
                                        "roll_model.reference_area_m2=5.0265e-5", "roll_model.damping_m2=23",
                                        "roll_model.torque_m=9"};

struct Seen {
  double mean_error_deg;  ///< of phi - R, outside of the first second after control start and after each step
  double angle_deg;       ///< mean of 7.5 to 9 s after lift-off, behind step and chirp
  double estimate_deg;    ///< likewise
};

Seen look(const flight::Flight& flight) {
  double error = 0.0;
  double errors = 0.0;
  double angle = 0.0;
  double estimate = 0.0;
  double rest = 0.0;
  double reference_rad = std::nan("");
  double counts_from_s = 0.0;
  for (const flight::Row& row : flight.rows) {
    if (row.phase != core::Phase::controlling) {
      continue;
    }
    if (row.reference_rad != reference_rad) {
      reference_rad = row.reference_rad;
      counts_from_s = row.time_s + 1.0;
    }
    if (row.time_s >= counts_from_s) {
      error += text::degrees(std::abs(row.roll_angle_rad - row.reference_rad));
      errors += 1.0;
    }
    if (row.time_s >= 7.7 && row.time_s < 9.0) {
      angle += text::degrees(row.roll_angle_rad);
      estimate += text::degrees(row.offset_estimate_rad);
      rest += 1.0;
    }
  }
  return {.mean_error_deg = error / errors, .angle_deg = angle / rest, .estimate_deg = estimate / rest};
}

TEST(OffsetRejection, AsPublishedTheLoopRestsBesideItsReferenceByOffsetOverGain) {
  const Seen seen = look(fly("tasha3_launch2"));
  EXPECT_NEAR(seen.angle_deg, -20.0 + offset_deg / 0.5, 0.2);
  EXPECT_GT(seen.mean_error_deg, 9.0);
  EXPECT_EQ(seen.estimate_deg, 0.0);
}

TEST(OffsetRejection, WithTheIntegralTheShippedPlanRestsAtItsReference) {
  const Seen seen = look(fly("tasha3_launch2_integral"));
  EXPECT_NEAR(seen.angle_deg, -20.0, 0.2);
  EXPECT_LT(seen.mean_error_deg, 1.0);
  EXPECT_NEAR(seen.estimate_deg, offset_deg, 0.1);
}

TEST(OffsetRejection, WithTheObserverTheLoopRestsAtItsReferenceToo) {
  const Seen seen = look(fly("tasha3_launch2", observed));
  EXPECT_NEAR(seen.angle_deg, -20.0, 0.2);
  EXPECT_LT(seen.mean_error_deg, 1.0);
  EXPECT_NEAR(seen.estimate_deg, offset_deg, 0.1);
}

TEST(OffsetRejection, AScheduleAloneMovesTheRestByItsFactor) {
  const Seen seen = look(fly("tasha3_launch2", {"gain_schedule.speeds_m_s=[20]", "gain_schedule.factors=[2]"}));
  EXPECT_NEAR(seen.angle_deg, -20.0 + offset_deg / (2.0 * 0.5), 0.2);
}

TEST(OffsetRejection, BesideAScheduleTheIntegralRestsAtItsReferenceAllTheSame) {
  const Seen seen = look(
      fly("tasha3_launch2_integral", {"gain_schedule.speeds_m_s=[20,40,80]", "gain_schedule.factors=[1.5,1.2,0.7]"}));
  EXPECT_NEAR(seen.angle_deg, -20.0, 0.2);
  EXPECT_NEAR(seen.estimate_deg, offset_deg, 0.1);
}

}  // namespace
}  // namespace fantail::sil
