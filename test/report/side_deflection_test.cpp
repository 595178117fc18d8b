// SPDX-License-Identifier: MIT
#include <array>

#include <gtest/gtest.h>

#include "report/figures.hpp"
#include "synthetic_flight.hpp"

namespace fantail::report {
namespace {

SideDeflection of(flight::Flight& flight, const std::array<double, 4>& shafts_deg) {
  for (flight::Row& row : flight.rows) {
    for (std::size_t i = 0; i < shafts_deg.size(); ++i) {
      row.encoders_rad[i] = text::radians(shafts_deg[i]);
    }
    row.truth->speed_m_s = 60.0;
  }
  return figures(flight).side_deflection.value();
}

double largest_deg(const std::array<double, 4>& shafts_deg) {
  SyntheticFlight synthetic;
  return text::degrees(of(synthetic.flight, shafts_deg).largest_rad);
}

TEST(SideDeflection, OfFourThatTurnAlikeIsNone) { EXPECT_NEAR(largest_deg({5, 5, 5, 5}), 0.0, 1e-9); }

// Three at 6 and one at 0: the pair without a fault cancels, the other leaves 6.
TEST(SideDeflection, OfOneThatStandsStillIsThatOfItsPartner) {
  EXPECT_NEAR(largest_deg({0, 6, 6, 6}), 6.0, 1e-9);
  EXPECT_NEAR(largest_deg({6, 6, 6, 0}), 6.0, 1e-9);
}

TEST(SideDeflection, OfNeighboursAddsAsVectorsAndOfOppositeOnesAsNumbers) {
  EXPECT_NEAR(largest_deg({0, 0, 3, 4}), 5.0, 1e-9);
  EXPECT_NEAR(largest_deg({-4, 2, 6, 2}), 10.0, 1e-9);
}

TEST(SideDeflection, CountsFromTheTrimInTheSenseOfRoll) {
  SyntheticFlight synthetic;
  synthetic.flight.plan.canards.each[2].direction = core::Direction::reversed;
  synthetic.flight.plan.canards.each[2].trim = core::Angle::from_degrees(1.0F);
  EXPECT_NEAR(text::degrees(of(synthetic.flight, {5, 5, -4, 5}).largest_rad), 0.0, 1e-5);
}

// 1/2 rho v^2 = 2205 Pa at 60 m/s; 2e-4 m3 a radian; 6 degrees.
TEST(SideDeflection, HasAMomentWhereTheVehicleSaysWhereItsCanardsAre) {
  SyntheticFlight synthetic;
  EXPECT_FALSE(of(synthetic.flight, {0, 6, 6, 6}).largest_moment_n_m);
  synthetic.flight.side_moment_m3 = 2e-4;
  EXPECT_NEAR(of(synthetic.flight, {0, 6, 6, 6}).largest_moment_n_m.value(), 2205.0 * 2e-4 * text::radians(6.0), 1e-6);
}

TEST(SideDeflection, IsNotKnownWithoutAllFourEncoders) {
  SyntheticFlight synthetic;
  of(synthetic.flight, {0, 6, 6, 6});
  for (flight::Row& row : synthetic.flight.rows) {
    row.encoders_rad[3].reset();
  }
  EXPECT_FALSE(figures(synthetic.flight).side_deflection);
}

}  // namespace
}  // namespace fantail::report
