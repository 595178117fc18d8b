// SPDX-License-Identifier: MIT
// What the judge makes of a roll angle that is not the twin's: flights made by hand.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "made_flight.hpp"

namespace fantail::faults {
namespace {

// The canards of a flight that goes on to 10 s go to trim at 5 s; the twin's roll is 5 degrees.
TEST(FaultJudge, AControlThatEndsForACanardIsSafeUpToWhereItEndedWhateverTheRollDoesThen) {
  const auto ends_at_five = [](double turned_deg_s, double before_deg) {
    return made_flight([=](Moment& moment) {
      if (moment.phase == core::Phase::controlling && moment.time_s > 5.0) {
        moment.phase = core::Phase::finished;
        moment.commanded_rad.fill(0.0);
        moment.true_roll_rad += turned_deg_s * (moment.time_s - 5.0) * degree;
      } else if (moment.phase == core::Phase::controlling && moment.time_s > 3.5) {
        moment.true_roll_rad += before_deg * degree;
      } else if (moment.time_s > 10.0) {
        moment.commanded_rad.fill(0.0);
      }
    });
  };
  const Expected may_end = or_ended(held);
  const Findings spun = judged(ends_at_five(200.0, 20.0), at_three);
  EXPECT_EQ(spun.outcome(held), std::nullopt);
  EXPECT_EQ(spun.outcome(may_end), Outcome::ended);
  EXPECT_NEAR(spun.apart_meanwhile_deg, 20.0, 1e-9);
  EXPECT_EQ(judged(ends_at_five(200.0, 61.0), at_three).outcome(may_end), std::nullopt);
  EXPECT_EQ(
      judged(made_flight({}, [](Moment& moment) { moment.true_roll_rad += moment.time_s > 4.0 ? 20.0 * degree : 0.0; }),
             at_three)
          .outcome(may_end),
      std::nullopt)
      << "it went on to the end, and did not hold";
  EXPECT_EQ(or_ended(any_of(Outcome::over)).allowed, any_of(Outcome::over).allowed) << "after control nothing ends";
}

// Control of the made flight begins at 0.6 s.
TEST(FaultJudge, WhileTheRollIsStillBeingCapturedItIsNotCompared) {
  const auto off_until = [](double end_s) {
    return made_flight({}, [=](Moment& moment) {
      moment.true_roll_rad += moment.time_s > 0.4 && moment.time_s < end_s ? 60.0 * degree : 0.0;
    });
  };
  Limits limits = made_limits();
  limits.capture_s = 1.2;
  constexpr FaultTime before{.begin_s = 0.3, .end_s = 0.303};
  EXPECT_EQ(judged(off_until(1.79), before, 1.5, limits).outcome(held), Outcome::holds);
  EXPECT_EQ(judged(off_until(1.82), before, 1.5, limits).outcome(held), std::nullopt);
  EXPECT_EQ(judged(off_until(1.79), before).outcome(held), std::nullopt);
}

TEST(FaultJudge, ARollThatIsWholeTurnsAwayAndMoreSaysBoth) {
  Limits limits = made_limits();
  limits.any_turn = true;
  const Findings found = judged(
      made_flight({}, [](Moment& moment) { moment.true_roll_rad += moment.time_s > 4.0 ? 750.0 * degree : 0.0; }),
      at_three, 1.5, limits);
  EXPECT_NEAR(found.apart_deg, 30.0, 1e-6);
  EXPECT_NE(found.what_it_was().find("roll 30.0 deg off without whole turns, 750.0 with them"), std::string::npos)
      << found.what_it_was();
}

}  // namespace
}  // namespace fantail::faults
