// SPDX-License-Identifier: MIT
#include "core/canard_monitor.hpp"

#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr std::int64_t tick_us = 1000;

// Four servos as first-order lags behind their commands, and the monitor that watches them.
class Bench {
 public:
  explicit Bench(const FlightPlan& plan = default_plan()) : monitor_{plan.monitor, plan.canards} {}

  double servo_lag_s = 0.020;
  std::array<double, canard_count> shaft_deg{};
  std::function<void(EncoderAngles&)> spoil = [](EncoderAngles&) {};

  const std::array<CanardVerdict, canard_count>& step(const std::array<double, canard_count>& command_deg) {
    CanardCommands commands;
    EncoderAngles encoders;
    for (std::size_t i = 0; i < canard_count; ++i) {
      shaft_deg[i] += (1.0 - std::exp(-1e-3 / servo_lag_s)) * (command_deg[i] - shaft_deg[i]);
      commands[i] = {.angle = Angle::from_degrees(static_cast<float>(command_deg[i])), .driven = driven};
      encoders[i] = Angle::from_degrees(static_cast<float>(shaft_deg[i]));
    }
    spoil(encoders);
    time_us += tick_us;
    return monitor_.update(Microseconds{time_us}, commands, encoders);
  }
  const std::array<CanardVerdict, canard_count>& step_all(double command_deg) {
    return step({command_deg, command_deg, command_deg, command_deg});
  }
  double time_s() const { return static_cast<double>(time_us) * 1e-6; }

  bool driven = true;
  std::int64_t time_us = 0;

 private:
  CanardMonitor monitor_;
};

using Verdicts = std::array<CanardVerdict, canard_count>;

Verdicts verdicts_with(std::size_t canard, CanardVerdict verdict) {
  Verdicts verdicts{};
  verdicts[canard] = verdict;
  return verdicts;
}

double saturated_product_chirp_deg(double t) {
  return std::clamp(12.0 * std::sin(2.0 * std::numbers::pi * (2.0 * t - 10.0) * t), -9.0, 9.0);
}

// As the self-test and a bench do it: the others stand still, and none of them disagrees with anybody.
TEST(CanardMonitor, OneCanardThatIsMovedAloneIsNoFaultOfAny) {
  Bench bench;
  while (bench.time_s() < 4.0) {
    const double command_deg = bench.time_s() < 1.0 ? 0.0 : bench.time_s() < 2.0 ? 9.0 : -9.0;
    ASSERT_EQ(bench.step({0.0, command_deg, 0.0, 0.0}), Verdicts{}) << bench.time_s();
  }
}

TEST(CanardMonitor, HealthyCanardsNeverReportAtFullExcitation) {
  for (const double servo_lag_s : {0.010, 0.020, 0.030}) {
    Bench bench;
    bench.servo_lag_s = servo_lag_s;
    while (bench.time_s() < 10.0) {
      ASSERT_EQ(bench.step_all(saturated_product_chirp_deg(bench.time_s())), Verdicts{})
          << "lag " << servo_lag_s << " at " << bench.time_s();
    }
  }
}

// Nor when all depart alike, as seen in the sense of each.
TEST(CanardMonitor, HealthyReversedAndTrimmedCanardsNeverReport) {
  for (const std::size_t reversed : {0U, 1U}) {  // and the one opposite
    FlightPlan plan = default_plan();
    plan.canards.each[reversed].direction = plan.canards.each[reversed + 2].direction = Direction::reversed;
    plan.canards.each[2].trim = 4_deg;
    plan.canards.each[3].trim = -3_deg;
    Bench bench{plan};
    bench.spoil = [&](EncoderAngles& encoders) {
      for (std::size_t i = 0; bench.time_s() > 5.0 && i < canard_count; ++i) {
        encoders[i] = *encoders[i] + (plan.canards.each[i].direction == Direction::reversed ? -2_deg : 2_deg);
      }
    };
    while (bench.time_s() < 10.0) {
      const double even = saturated_product_chirp_deg(bench.time_s()) * (reversed == 0 ? -1.0 : 1.0);
      ASSERT_EQ(bench.step({even, -even, even + 4.0, -even - 3.0}), Verdicts{}) << bench.time_s();
    }
  }
}

TEST(CanardMonitor, ACanardThatDoesNotMoveIsStalledAfterTheHold) {
  Bench bench;
  bench.spoil = [](EncoderAngles& encoders) { encoders[2] = Angle{}; };
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(bench.step_all(0.0), Verdicts{});
  }
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(bench.step_all(8.0), Verdicts{}) << i;
  }
  for (int i = 0; i < 100; ++i) {
    bench.step_all(8.0);
  }
  EXPECT_EQ(bench.step_all(8.0), verdicts_with(2, CanardVerdict::stalled));
}

TEST(CanardMonitor, ACanardThatMovesToTheWrongPlaceIsSlippingWhicheverWayItMoves) {
  for (const double command_deg : {9.0, -9.0}) {
    Bench bench;
    bench.step_all(0.0);
    bench.spoil = [&bench](EncoderAngles& encoders) {
      encoders[1] = Angle::from_degrees(static_cast<float>(0.3 * bench.shaft_deg[1] * (1.0 + 0.2 * bench.time_s())));
    };
    for (int i = 0; i < 400; ++i) {
      bench.step_all(command_deg);
    }
    EXPECT_EQ(bench.step_all(command_deg), verdicts_with(1, CanardVerdict::slipping));
  }
}

TEST(CanardMonitor, ACanardStuckNearTheMiddleOfAFastExcitationIsReported) {
  for (const double frequency_hz : {1.0, 3.0, 6.0, 10.0}) {
    Bench bench;
    bench.spoil = [](EncoderAngles& encoders) { encoders[0] = Angle{}; };
    bool reported = false;
    while (bench.time_s() < 2.0) {
      const double roll = 9.0 * std::sin(2.0 * std::numbers::pi * frequency_hz * bench.time_s());
      const Verdicts& verdicts = bench.step_all(roll);
      reported = reported || verdicts[0] != CanardVerdict::healthy;
      for (std::size_t i = 1; i < canard_count; ++i) {
        ASSERT_EQ(verdicts[i], CanardVerdict::healthy) << "canard " << i << " at " << frequency_hz << " Hz";
      }
    }
    EXPECT_TRUE(reported) << frequency_hz << " Hz";
  }
}

TEST(CanardMonitor, ACanardAwayFromTheOthersIsDisagreeingAndItsNeighboursAreNot) {
  Bench bench;
  bench.spoil = [&bench](EncoderAngles& encoders) {
    encoders[3] = Angle::from_degrees(static_cast<float>(bench.shaft_deg[3] + 2.0));
  };
  for (int i = 0; i < 300; ++i) {
    bench.step_all(4.0);
  }
  EXPECT_EQ(bench.step_all(4.0), verdicts_with(3, CanardVerdict::disagreeing));
}

// The middle of the other three is each time one of the other two.
TEST(CanardMonitor, OfTwoAgainstTwoAllDisagree) {
  Bench bench;
  bench.spoil = [&bench](EncoderAngles& encoders) {
    for (std::size_t i = 0; i < canard_count; ++i) {
      const double off_deg = (i < 2 ? 0.0 : 2.0) + 0.1 * static_cast<double>(i);
      encoders[i] =
          Angle::from_degrees(static_cast<float>(bench.shaft_deg[i] + (bench.time_s() > 0.5 ? off_deg : 0.0)));
    }
  };
  for (int i = 0; i < 700; ++i) {
    bench.step_all(0.0);
  }
  Verdicts all;
  all.fill(CanardVerdict::disagreeing);
  EXPECT_EQ(bench.step_all(0.0), all);
}

TEST(CanardMonitor, AVerdictStaysUntilTheDifferenceHasBeenGoneForHalfTheHold) {
  Bench bench;
  bool apart = true;
  bench.spoil = [&](EncoderAngles& encoders) { encoders[3] = apart ? Angle{} + 2_deg : Angle{}; };
  apart = false;
  bench.step_all(0.0);
  apart = true;
  for (int i = 0; i < 200; ++i) {
    bench.step_all(0.0);
  }
  apart = false;
  for (int i = 0; i < 49; ++i) {
    ASSERT_EQ(bench.step_all(0.0), verdicts_with(3, CanardVerdict::disagreeing)) << i;
  }
  EXPECT_EQ(bench.step_all(0.0), Verdicts{});
}

TEST(CanardMonitor, WithOneEncoderDeadTheOtherThreeStillWatchEachOther) {
  Bench bench;
  bench.spoil = [&bench](EncoderAngles& encoders) {
    encoders[0].reset();
    encoders[3] = Angle::from_degrees(static_cast<float>(bench.shaft_deg[3] + 2.0));
  };
  for (int i = 0; i < 300; ++i) {
    bench.step_all(4.0);
  }
  Verdicts expected = verdicts_with(3, CanardVerdict::disagreeing);
  expected[0] = CanardVerdict::dead;
  EXPECT_EQ(bench.step_all(4.0), expected);
}

TEST(CanardMonitor, WithTwoEncodersDeadNobodyCanSayWhichOfTheOthersIsRight) {
  Bench bench;
  bench.spoil = [&bench](EncoderAngles& encoders) {
    encoders[0].reset();
    encoders[1].reset();
    encoders[3] = Angle::from_degrees(static_cast<float>(bench.shaft_deg[3] + 2.0));
  };
  for (int i = 0; i < 300; ++i) {
    bench.step_all(4.0);
  }
  EXPECT_EQ(bench.step_all(4.0),
            (Verdicts{CanardVerdict::dead, CanardVerdict::dead, CanardVerdict::healthy, CanardVerdict::healthy}));
}

TEST(CanardMonitor, AnEncoderIsDeadWhenItHasBeenSilentForTheTimeoutAndAloneInThat) {
  Bench bench;
  bench.step_all(3.0);
  for (const std::optional<Angle>& nothing :
       {std::optional<Angle>{}, std::optional{Angle::from_radians(std::numeric_limits<float>::quiet_NaN())}}) {
    bench.spoil = [&](EncoderAngles& encoders) { encoders[1] = nothing; };
    for (int i = 0; i < 20; ++i) {  // the first silent tick starts the 20 ms
      ASSERT_EQ(bench.step_all(3.0), Verdicts{}) << i;
    }
    for (int i = 0; i < 100; ++i) {
      ASSERT_EQ(bench.step_all(3.0), verdicts_with(1, CanardVerdict::dead)) << i;
    }
    bench.spoil = [](EncoderAngles&) {};
    ASSERT_EQ(bench.step_all(3.0), Verdicts{});
  }
}

TEST(CanardMonitor, AHealthyCanardWhoseEncoderComesBackIsHealthy) {
  FlightPlan plan = default_plan();
  plan.monitor.servo_lag = Microseconds{200'000};
  plan.monitor.hold = Microseconds{10'000};
  Bench bench{plan};
  bench.servo_lag_s = 0.2;
  const auto silent = [](EncoderAngles& encoders) { encoders[1].reset(); };
  bench.step_all(0.0);
  bench.spoil = silent;
  while (bench.time_s() < 1.0) {
    bench.step_all(9.0);
  }
  bench.spoil = [](EncoderAngles&) {};
  while (bench.time_s() < 2.0) {
    ASSERT_EQ(bench.step_all(9.0), Verdicts{}) << bench.time_s();
  }
}

TEST(CanardMonitor, ACanardThatIsNotDrivenIsNotJudged) {
  Bench bench;
  bench.driven = false;
  bench.spoil = [](EncoderAngles& encoders) { encoders[0] = 20_deg; };
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(bench.step_all(-9.0), Verdicts{});
  }
  bench.driven = true;  // and starts with a clean slate
  for (int i = 0; i < 90; ++i) {
    ASSERT_EQ(bench.step_all(-9.0), Verdicts{}) << i;
  }
}

}  // namespace
}  // namespace fantail::core
