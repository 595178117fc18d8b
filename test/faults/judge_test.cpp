// SPDX-License-Identifier: MIT
// The judge against flights made by hand, each of which keeps every rule but one.
#include <string>

#include <gtest/gtest.h>

#include "made_flight.hpp"

namespace fantail::faults {
namespace {

std::string breach_of(const std::function<void(Moment& moment)>& change) {
  return judged(made_flight(change), at_three).breach;
}

bool is_at(const Moment& moment, double time_s) { return std::abs(moment.time_s - time_s) < 1e-6; }

TEST(FaultJudge, AFlightAsTheTwinIsHeldAndBreaksNothing) {
  const Findings findings = judged(made_flight(), at_three);
  EXPECT_EQ(findings.breach, "");
  EXPECT_TRUE(findings.lasted);
  EXPECT_EQ(findings.apart_deg, 0.0);
  EXPECT_EQ(findings.outcome(held), Outcome::holds);
  EXPECT_EQ(findings.outcome(any_of(Outcome::over)), std::nullopt);
  EXPECT_EQ(findings.outcome(any_of(Outcome::no_control)), std::nullopt);
  EXPECT_EQ(findings.outcome(any_of(Outcome::not_armed)), std::nullopt);
}

TEST(FaultJudge, ACommandBeyondItsLimitIsRedForOneMillisecondOnEitherSide) {
  for (const double angle_deg : {9.002, -9.002, 180.0}) {
    const std::string breach = breach_of([&](Moment& moment) {
      if (is_at(moment, 4.0)) {
        moment.commanded_rad[2] = angle_deg * degree;
      }
    });
    EXPECT_NE(breach.find("canard 3 commanded to"), std::string::npos) << angle_deg << ' ' << breach;
  }
  EXPECT_EQ(breach_of([](Moment& moment) {
              if (moment.phase == core::Phase::controlling) {
                moment.commanded_rad[2] = -9.0 * degree;
              }
            }),
            "");
}

TEST(FaultJudge, ACommandThatIsNoNumberIsRed) {
  EXPECT_NE(breach_of([](Moment& moment) {
              if (is_at(moment, 4.0)) {
                moment.commanded_rad[0] = std::nan("");
              }
            }),
            "");
}

TEST(FaultJudge, ACommandOffTrimOutsideControllingIsRed) {
  for (const double time_s : {-1.0, 0.3, 10.5}) {
    const std::string breach = breach_of([&](Moment& moment) {
      if (is_at(moment, time_s)) {
        moment.commanded_rad[1] = 0.01 * degree;
      }
    });
    EXPECT_NE(breach.find("off its trim"), std::string::npos) << time_s;
  }
}

// A self-test and a bench move canards in Safe, on the pad.
TEST(FaultJudge, InSafeACommandOffTrimIsRedAfterIgnitionWhereItMovesAwayFromTrimAndNotOnThePad) {
  EXPECT_EQ(breach_of([](Moment& moment) {
              if (moment.phase == core::Phase::safe) {
                moment.commanded_rad[0] = (moment.time_s + 6.0) * degree;
              }
            }),
            "");
  const auto after_a_reset = [](double slope_deg_s) {
    return [slope_deg_s](Moment& moment) {
      if (moment.time_s > 5.0) {
        moment.phase = core::Phase::safe;
        moment.ticked = moment.time_s > 5.06;
        moment.commanded_rad.fill(std::max(0.0, 3.0 + slope_deg_s * (moment.time_s - 5.0)) * degree);
      }
    };
  };
  EXPECT_EQ(breach_of(after_a_reset(-30.0)), "");
  EXPECT_NE(breach_of(after_a_reset(1.0)).find("Safe"), std::string::npos);
}

TEST(FaultJudge, ATickThatDidNotComeToItsEndIsRedUnlessThereWasNone) {
  const auto missing = [](bool ticked) {
    return breach_of([ticked](Moment& moment) {
      if (is_at(moment, 4.0)) {
        moment.completed = false;
        moment.ticked = ticked;
      }
    });
  };
  EXPECT_NE(missing(true).find("tick"), std::string::npos);
  EXPECT_EQ(missing(false), "");
}

TEST(FaultJudge, DormantIsAtTrimAndMayLeadToControl) {
  const auto dormant = [](double off_trim_deg) {
    return [off_trim_deg](Moment& moment) {
      if (moment.phase == core::Phase::launched && moment.time_s > 0.25) {
        moment.phase = core::Phase::dormant;
        moment.commanded_rad[1] = off_trim_deg * degree;
      }
    };
  };
  EXPECT_EQ(breach_of(dormant(0.0)), "");
  EXPECT_NE(breach_of(dormant(0.01)).find("off its trim in Dormant"), std::string::npos);
}

TEST(FaultJudge, WholeTurnsCountUnlessTheLawCaptures) {
  const std::vector<Moment> turned = made_flight({}, [](Moment& moment) { moment.true_roll_rad -= 358.0 * degree; });
  EXPECT_NEAR(judged(turned, at_three).apart_deg, 358.0, 1e-9);
  Limits limits = made_limits();
  limits.any_turn = true;
  EXPECT_NEAR(judged(turned, at_three, 1.5, limits).apart_deg, 2.0, 1e-9);
}

void expect_no_launch(const std::string& breach) {
  EXPECT_TRUE(breach.find("Controlling") != std::string::npos && breach.find("Launched") != std::string::npos)
      << breach;
}

TEST(FaultJudge, ControllingWithoutLaunchedIsRed) {
  expect_no_launch(breach_of([](Moment& moment) {
    if (moment.phase == core::Phase::launched) {
      moment.phase = core::Phase::armed;
    }
  }));
  expect_no_launch(breach_of([](Moment& moment) {
    if (is_at(moment, 10.5)) {
      moment.phase = core::Phase::controlling;
    }
  }));
}

TEST(FaultJudge, AfterAResetControllingComesFromAFlightThatWasControlledAndFromNoOther) {
  const auto reset_at = [](double time_s) {
    return [time_s](Moment& moment) {
      if (moment.time_s > time_s && moment.time_s < time_s + 0.06) {
        moment.ticked = false;
      } else if (moment.time_s >= time_s + 0.06 && moment.time_s < time_s + 0.07) {
        moment.phase = core::Phase::safe;
        moment.commanded_rad.fill(0.0);
      } else if (moment.time_s >= time_s + 0.07) {
        moment.phase = moment.time_s < control_end_s ? core::Phase::controlling : core::Phase::finished;
      }
    };
  };
  EXPECT_EQ(breach_of(reset_at(5.0)), "");
  EXPECT_EQ(breach_of(reset_at(0.3)), "");
  expect_no_launch(breach_of(reset_at(-0.5)));
}

TEST(FaultJudge, AnotherPhaseAfterFinishedIsRed) {
  const std::string breach = breach_of([](Moment& moment) {
    if (moment.time_s > 10.5) {
      moment.phase = core::Phase::armed;
    }
  });
  EXPECT_NE(breach.find("Finished"), std::string::npos) << breach;
}

TEST(FaultJudge, ARollAngleElevenDegreesFromTheTwinIsNotHeldAndNineIs) {
  const auto apart = [](double by_deg) {
    return judged(made_flight([&](Moment& moment) {
                    if (is_at(moment, 6.0)) {
                      moment.true_roll_rad += by_deg * degree;
                    }
                  }),
                  at_three);
  };
  EXPECT_EQ(apart(-9.0).outcome(held), Outcome::holds);
  EXPECT_EQ(apart(-11.0).outcome(held), std::nullopt);
  EXPECT_NEAR(apart(-11.0).apart_deg, 11.0, 1e-9);
  EXPECT_EQ(apart(-11.0).outcome(any_of(Outcome::holds, Outcome::goes_on)), Outcome::goes_on);
  EXPECT_EQ(apart(61.0).outcome(any_of(Outcome::goes_on)), std::nullopt);
}

TEST(FaultJudge, ARollAngleApartBeforeTheFaultOrOutsideControlDoesNotCount) {
  for (const double time_s : {2.9, 10.5}) {
    const Findings findings = judged(made_flight([&](Moment& moment) {
                                       if (is_at(moment, time_s)) {
                                         moment.true_roll_rad += 100.0 * degree;
                                       }
                                     }),
                                     at_three);
    EXPECT_EQ(findings.outcome(held), Outcome::holds) << time_s;
  }
}

TEST(FaultJudge, RecoveringCountsFromTheSettlingAfterTheFaultOn) {
  const FaultTime half_a_second{.begin_s = 3.0, .end_s = 3.5};
  const auto apart_at = [&](double time_s) {
    return judged(made_flight([&](Moment& moment) {
                    if (is_at(moment, time_s)) {
                      moment.true_roll_rad += 40.0 * degree;
                    }
                  }),
                  half_a_second)
        .outcome(any_of(Outcome::recovers));
  };
  EXPECT_EQ(apart_at(4.9), Outcome::recovers);
  EXPECT_EQ(apart_at(5.1), std::nullopt);
}

TEST(FaultJudge, ControlThatEndsEarlyIsNotHeldAndIsOverWhenTheCanardsAreAtTrimInTime) {
  const auto ends_at = [](double time_s) {
    return judged(made_flight([&](Moment& moment) {
                    if (moment.time_s > time_s && moment.time_s < control_end_s) {
                      moment.phase = core::Phase::finished;
                      moment.commanded_rad.fill(0.0);
                    }
                  }),
                  at_three);
  };
  EXPECT_EQ(ends_at(3.2).outcome(held), std::nullopt);
  EXPECT_EQ(ends_at(3.2).outcome(any_of(Outcome::over)), Outcome::over);
  EXPECT_NEAR(ends_at(3.2).trim_after_s, 0.2, 0.0015);
  EXPECT_EQ(ends_at(3.4).outcome(any_of(Outcome::over)), std::nullopt);
  EXPECT_EQ(ends_at(9.95).outcome(held), Outcome::holds);
}

TEST(FaultJudge, ARocketThatIsNeverArmedAndOneThatIsNeverControlledAreWhatTheyAre) {
  const auto stays_in = [](core::Phase last) {
    return judged(made_flight([&](Moment& moment) {
                    moment.phase = std::min(moment.phase, last);
                    moment.commanded_rad.fill(0.0);
                  }),
                  at_three);
  };
  EXPECT_EQ(stays_in(core::Phase::safe).outcome(any_of(Outcome::not_armed)), Outcome::not_armed);
  EXPECT_EQ(stays_in(core::Phase::armed).outcome(any_of(Outcome::not_armed)), std::nullopt);
  EXPECT_EQ(stays_in(core::Phase::armed).outcome(any_of(Outcome::no_control)), Outcome::no_control);
  EXPECT_EQ(stays_in(core::Phase::armed).outcome(held), std::nullopt);
}

TEST(FaultJudge, ABreachIsRedWhateverTheFlightCameTo) {
  const Findings findings = judged(made_flight([](Moment& moment) {
                                     if (is_at(moment, -1.0)) {
                                       moment.commanded_rad[1] = 1.0 * degree;
                                     }
                                   }),
                                   at_three);
  EXPECT_EQ(findings.outcome(any_of(Outcome::holds, Outcome::anything)), std::nullopt);
}

}  // namespace
}  // namespace fantail::faults
