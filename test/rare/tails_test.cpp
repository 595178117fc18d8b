// SPDX-License-Identifier: MIT
#include "rare/tails.hpp"

#include "test.hpp"

namespace fantail::rare {
namespace {

// From SciPy: the survival function of Student's t, and integrals over one of the two densities.
TEST(TailOfSum, IsThatOfItsOnlyPart) {
  EXPECT_NEAR(tail_of_sum({{.factor = 1.0, .is_student = true}}, 4.0), 0.0017864, 0.03 * 0.0017864);
  EXPECT_NEAR(tail_of_sum({{.factor = 1.0, .is_student = false}}, 4.0), 3.1671e-5, 0.05 * 3.1671e-5);
}

TEST(TailOfSum, OfSeveralIsWhatTheIntegralSays) {
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(tail_of_sum({{half, true}, {half, true}}, 4.0), 0.00113194, 0.03 * 0.00113194);
  EXPECT_NEAR(tail_of_sum({{half, true}, {half, true}}, 4.7534), 0.000464723, 0.03 * 0.000464723);
  EXPECT_NEAR(tail_of_sum({{0.8, true}, {0.6, false}}, 4.0), 0.000902156, 0.03 * 0.000902156);
  EXPECT_NEAR(tail_of_sum({{0.8, false}, {0.6, false}}, 3.0), 0.0013499, 0.05 * 0.0013499);
}

}  // namespace
}  // namespace fantail::rare
