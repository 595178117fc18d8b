// SPDX-License-Identifier: MIT
// Motors that push twice, and what of the flight is its apogee.

#include "sim/ascent.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

/// A kilogram that loses next to nothing of it.
AscentParameters in_vacuum(std::vector<ThrustPoint> thrust) {
  return {.mass_kg = 1.0, .drag_area_m2 = 0.0, .motor = ThrustCurve{std::move(thrust), 1e-12}};
}

// 30 N on 1 kg in a vacuum, for a second, and from 4 to 6 s again: up by a = 30 - g, in between and after it by -g.
TEST(PausingMotor, HasItsApogeeAtTheHighestPointOfTheWholeFlight) {
  const AscentParameters parameters = in_vacuum(
      {{0.0, 30.0}, {1.0, 30.0}, {1.000001, 0.0}, {4.0, 0.0}, {4.000001, 30.0}, {6.0, 30.0}, {6.000001, 0.0}});
  constexpr double up_m_s2 = 30.0 - gravity_m_s2;
  constexpr double first_m_s = up_m_s2;
  constexpr double relit_m_s = first_m_s - 3.0 * gravity_m_s2;
  constexpr double relit_m = 0.5 * up_m_s2 + 3.0 * first_m_s - 4.5 * gravity_m_s2;
  constexpr double out_m_s = relit_m_s + 2.0 * up_m_s2;
  constexpr double out_m = relit_m + 2.0 * relit_m_s + 2.0 * up_m_s2;
  Ascent ascent{parameters};
  double highest_m = 0.0;
  for (int tick = 0; tick <= 15'000; ++tick) {
    ascent.advance_to(tick * 0.001);
    highest_m = std::max(highest_m, ascent.height_m());
    if (tick == 3900) {
      EXPECT_NEAR(*ascent.events().apogee_s, 1.0 + first_m_s / gravity_m_s2, 2e-3);
    }
  }
  EXPECT_NEAR(highest_m, out_m + 0.5 * out_m_s * out_m_s / gravity_m_s2, 0.01);
  EXPECT_NEAR(*ascent.events().apogee_s, 6.0 + out_m_s / gravity_m_s2, 3e-3);
}

TEST(PausingMotor, ThatComesLessHighTheSecondTimeLeavesTheApogeeWhereItWas) {
  const AscentParameters parameters = in_vacuum(
      {{0.0, 30.0}, {1.0, 30.0}, {1.000001, 0.0}, {4.0, 0.0}, {4.000001, 30.0}, {4.5, 30.0}, {4.500001, 0.0}});
  Ascent ascent{parameters};
  double fastest_later_m_s = 0.0;
  for (int tick = 0; tick <= 15'000; ++tick) {
    ascent.advance_to(tick * 0.001);
    fastest_later_m_s = tick > 4000 ? std::max(fastest_later_m_s, ascent.speed_m_s()) : 0.0;
  }
  EXPECT_GT(fastest_later_m_s, 0.5);
  EXPECT_NEAR(*ascent.events().apogee_s, 1.0 + (30.0 - gravity_m_s2) / gravity_m_s2, 2e-3);
}

TEST(PausingMotor, LeavesARocketThatFellFromBeyondItsGuideOnTheGround) {
  AscentParameters parameters =
      in_vacuum({{0.0, 30.0}, {0.2, 30.0}, {0.200001, 0.0}, {3.0, 0.0}, {3.01, 30.0}, {4.0, 30.0}, {4.01, 0.0}});
  for (const double guide_m : {0.5, 4.0}) {  // the first burn takes it 1.2 m up
    parameters.guide_length_m = guide_m;
    Ascent ascent{parameters};
    for (int tick = 0; tick <= 4000; ++tick) {
      ascent.advance_to(tick * 0.001);
    }
    EXPECT_EQ(ascent.events().landing_s.has_value(), guide_m < 1.0) << guide_m;
    EXPECT_EQ(ascent.height_m() > 5.0, guide_m > 1.0) << guide_m;
  }
}

}  // namespace
}  // namespace fantail::sim
