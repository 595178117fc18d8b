// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "allowed_canards.hpp"
#include "plan_generator.hpp"

namespace fantail::core {
namespace {

RC_GTEST_PROP(ProofRanges, NoPlanThatMayFlyIsOutsideOfWhatTheProofsOfTheMixerLookAt, ()) {
  const FlightPlan plan = arbitrary_plan();
  RC_ASSERT(proof::is_allowed(plan.canards, plan.controller.canard_limit));
}

TEST(ProofRanges, TheirPredicateIsFalseForWhatNoPlanMayHave) {
  const FlightPlan plan = default_plan();
  const Angle limit = plan.controller.canard_limit;
  EXPECT_TRUE(proof::is_allowed(plan.canards, limit));
  EXPECT_FALSE(proof::is_allowed(plan.canards, Angle{}));
  EXPECT_FALSE(proof::is_allowed(plan.canards, Angle::from_degrees(46.0F)));
  CanardsPlan canards = plan.canards;
  canards.each[3].trim = -limit;
  EXPECT_FALSE(proof::is_allowed(canards, limit));
}

}  // namespace
}  // namespace fantail::core
