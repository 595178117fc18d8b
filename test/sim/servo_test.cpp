// SPDX-License-Identifier: MIT
#include "sim/servo.hpp"

#include "servo_test_rig.hpp"
#include "sim/random.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

TEST(Servo, StepResponseIsTheClosedFormExponentialForAnyStep) {
  for (const double dt_s : {0.0002, 0.001, 0.003, 0.017}) {
    ServoRig rig{ideal(), dt_s};
    while (rig.time_s() < 0.15) {
      const double before_s = rig.time_s();
      rig.servo.step(before_s, dt_s, pulse_us(5.0));
      const double now_s = before_s + dt_s;
      ++rig.tick;
      EXPECT_NEAR(rig.angle_deg(), 5.0 * (1.0 - std::exp(-now_s / 0.020)), 1e-12);
      const double mean = 5.0 - 5.0 * 0.020 / dt_s * (std::exp(-before_s / 0.020) - std::exp(-now_s / 0.020));
      EXPECT_NEAR(rig.servo.mean_angle_rad() / degree, mean, 1e-9);
    }
  }
}

TEST(Servo, ThePulseIsLatchedAtTheNextFrameAndActsAfterTheDelay) {
  ServoParameters p = ideal();
  p.frame_period_s = 1.0 / 333.0;
  p.delay_s = 0.003;
  ServoRig rig{p};
  rig.run(0.004, pulse_us(0.0));
  // Frames begin at 3.003 and 6.006 ms: a pulse that changes at 4 ms acts from 9.006 ms on.
  const double acts_s = 2.0 / 333.0 + 0.003;
  while (rig.time_s() < 0.1) {
    rig.servo.step(rig.time_s(), rig.dt_s, pulse_us(5.0));
    ++rig.tick;
    const double since_s = rig.time_s() - acts_s;
    EXPECT_NEAR(rig.angle_deg(), since_s < 0.0 ? 0.0 : 5.0 * (1.0 - std::exp(-since_s / 0.020)), 1e-12);
  }
}

// The example in servo.hpp, from pulse to shaft.
TEST(Servo, TakesAPulseThroughAllOfItsStages) {
  ServoRig rig{ServoParameters{}, 1e-6};
  rig.run(0.001, pulse_us(0.0));
  rig.run(0.006, pulse_us(20.0));
  EXPECT_EQ(rig.angle_deg(), 0.0);
  const double limited_until_s = 1.0 / 333.0 + 0.003 + 8.0 / 600.0;
  rig.run(limited_until_s, pulse_us(20.0));
  EXPECT_NEAR(rig.angle_deg(), 8.0 - 0.05, 1e-3);
  rig.run(limited_until_s + 0.020, pulse_us(20.0));
  EXPECT_NEAR(rig.angle_deg(), 20.0 - 12.0 / std::exp(1.0) - 0.05, 1e-3);
  rig.run(1.0, pulse_us(20.0));
  EXPECT_NEAR(rig.angle_deg(), 19.95, 1e-9);
}

TEST(Servo, APulseBetweenTwoFramesIsNeverSeen) {
  ServoParameters p = ideal();
  p.frame_period_s = 1.0 / 333.0;
  ServoRig rig{p};
  rig.run(0.004, pulse_us(0.0));
  rig.run(0.006, pulse_us(20.0));
  rig.run(0.1, pulse_us(0.0));
  EXPECT_EQ(rig.angle_deg(), 0.0);
}

TEST(Servo, RunsAtTheRateLimitUntilTheLagRules) {
  ServoParameters p = ideal();
  p.rate_limit_rad_s = 100.0 * degree;
  ServoRig rig{p};
  // 20 deg at 100 deg/s; from 2 deg (rate times lag) before the goal on, the exponential is slower.
  while (rig.time_s() < 0.4) {
    rig.servo.step(rig.time_s(), rig.dt_s, pulse_us(-20.0));
    ++rig.tick;
    const double t = rig.time_s();
    const double expected = t < 0.18 ? 100.0 * t : 20.0 - 2.0 * std::exp(-(t - 0.18) / 0.020);
    EXPECT_NEAR(rig.angle_deg(), -expected, 1e-9);
  }
}

TEST(Servo, StaysAtItsMechanicalStopOnBothSides) {
  ServoParameters p = ideal();
  p.stop_rad = 25.0 * degree;
  p.backlash_rad = 1.0 * degree;
  ServoRig rig{p};
  rig.run(0.5, 2500.0);
  EXPECT_NEAR(rig.angle_deg(), 25.0, 1e-12);
  rig.run(1.0, 500.0);
  EXPECT_NEAR(rig.angle_deg(), -25.0, 1e-12);
}

TEST(Servo, TheShaftFollowsTheGearOnceThePlayIsUsedUp) {
  ServoParameters p = ideal();
  p.backlash_rad = 1.0 * degree;
  ServoRig rig{p};
  const auto settle = [&](double command_deg) {
    rig.run(rig.time_s() + 1.0, pulse_us(command_deg));
    return rig.angle_deg();
  };
  EXPECT_NEAR(settle(0.4), 0.0, 1e-12);  // within the play
  EXPECT_NEAR(settle(5.0), 4.5, 1e-12);
  EXPECT_NEAR(settle(4.2), 4.5, 1e-12);  // the play again
  EXPECT_NEAR(settle(3.0), 3.5, 1e-12);
  EXPECT_NEAR(settle(3.9), 3.5, 1e-12);
  EXPECT_NEAR(settle(5.0), 4.5, 1e-12);
  EXPECT_NEAR(settle(-5.0), -4.5, 1e-12);
}

TEST(Servo, WithoutAPulseItHoldsWhereItIs) {
  ServoRig rig{ideal()};
  rig.run(0.1, std::nullopt);
  EXPECT_EQ(rig.angle_deg(), 0.0);
  rig.run(0.12, pulse_us(5.0));
  const double held_deg = rig.angle_deg();
  EXPECT_NEAR(held_deg, 5.0 * (1.0 - std::exp(-1.0)), 1e-12);
  rig.run(0.5, std::nullopt);
  EXPECT_EQ(rig.angle_deg(), held_deg);
  EXPECT_EQ(rig.servo.mean_angle_rad(), rig.servo.angle_rad());
  rig.run(1.5, pulse_us(5.0));
  EXPECT_NEAR(rig.angle_deg(), 5.0, 1e-12);
}

TEST(Servo, APulseOutsideItsRangeIsIgnored) {
  ServoParameters p = ideal();
  p.stop_rad = 2.0;
  ServoRig rig{p};
  rig.run(1.0, pulse_us(5.0));
  for (const double pulse : {499.9, 2500.1, -1e9, 0.0, std::nan(""), HUGE_VAL}) {
    rig.run(rig.time_s() + 0.1, pulse);
    EXPECT_NEAR(rig.angle_deg(), 5.0, 1e-12) << pulse;
  }
  rig.run(rig.time_s() + 1.0, 500.0);
  EXPECT_NEAR(rig.angle_deg(), -100.0, 1e-9);
  rig.run(rig.time_s() + 1.0, 2500.0);
  EXPECT_NEAR(rig.angle_deg(), 100.0, 1e-9);
}

TEST(Servo, ANegativePulseScaleTurnsTheOtherWay) {
  ServoParameters p = ideal();
  p.pulse_per_degree_us = -8.0;
  p.pulse_centre_us = 1480.0;
  ServoRig rig{p};
  rig.run(1.0, 1520.0);
  EXPECT_NEAR(rig.angle_deg(), -5.0, 1e-12);
}

TEST(Servo, ItsCentreMayBeOffAndTheStopsStayWhereTheyAre) {
  ServoParameters p = ideal();
  p.centre_rad = 1.5 * degree;
  p.stop_rad = 10.0 * degree;
  ServoRig rig{p};
  EXPECT_NEAR(rig.angle_deg(), 1.5, 1e-12);
  rig.run(0.02, pulse_us(5.0));
  EXPECT_NEAR(rig.angle_deg(), 6.5 - 5.0 * std::exp(-1.0), 1e-12);
  rig.run(1.0, pulse_us(9.0));
  EXPECT_NEAR(rig.angle_deg(), 10.0, 1e-12);
  rig.run(2.0, pulse_us(-9.0));
  EXPECT_NEAR(rig.angle_deg(), -7.5, 1e-12);
  rig.servo.fail(ServoFault::reversed);
  rig.run(3.0, pulse_us(-5.0));
  EXPECT_NEAR(rig.angle_deg(), 6.5, 1e-12);
}

/// The whole servo in steps of a microsecond, as plainly as it can be said.
class NaiveServo {
 public:
  explicit NaiveServo(const ServoParameters& parameters) : p_{parameters} {}

  void run(double from_s, double to_s, double pulse) {
    const auto first = std::lround(from_s * 1e6);
    const auto last = std::lround(to_s * 1e6);
    for (long us = first; us < last; ++us) {
      const double t = static_cast<double>(us) * 1e-6;
      if (t >= static_cast<double>(frame_) * p_.frame_period_s - 1e-9) {
        on_the_way_.push_back({t + p_.delay_s, (pulse - p_.pulse_centre_us) / p_.pulse_per_degree_us * degree});
        ++frame_;
      }
      while (!on_the_way_.empty() && on_the_way_.front().first <= t + 1e-9) {
        goal_ = on_the_way_.front().second;
        on_the_way_.pop_front();
      }
      const double rate = std::clamp((goal_ - gear_) / p_.lag_s, -p_.rate_limit_rad_s, p_.rate_limit_rad_s);
      const double half = p_.backlash_rad / 2.0;
      gear_ = std::clamp(gear_ + 1e-6 * rate, -p_.stop_rad - half, p_.stop_rad + half);
      shaft_ = std::clamp(shaft_, gear_ - half, gear_ + half);
    }
  }
  [[nodiscard]] double angle_rad() const { return shaft_; }

 private:
  ServoParameters p_;
  std::deque<std::pair<double, double>> on_the_way_;
  long frame_ = 0;
  double goal_ = 0.0;
  double gear_ = 0.0;
  double shaft_ = 0.0;
};

TEST(Servo, AgreesWithANaiveServoInMicrosecondsUnderRandomCommands) {
  constexpr std::uint64_t seed = 333;
  SCOPED_TRACE(seed);
  Random random{seed, 0};
  for (int round = 0; round < 12; ++round) {
    const ServoParameters p{.lag_s = 0.005 + 0.03 * random.uniform(),
                            .delay_s = round % 3 == 0 ? 0.05 : 0.01 * random.uniform(),
                            .frame_period_s = round % 2 == 0 ? 1.0 / 333.0 : 0.001 + 0.01 * random.uniform(),
                            .rate_limit_rad_s = (100.0 + 900.0 * random.uniform()) * degree,
                            .stop_rad = 15.0 * degree,
                            .backlash_rad = 1.0 * random.uniform() * degree,
                            .pulse_centre_us = 1500.0,
                            .pulse_per_degree_us = 10.0};
    const double dt_s = round % 4 == 3 ? 0.0007 : 0.001;
    ServoRig rig{p, dt_s};
    NaiveServo naive{p};
    double command_deg = 0.0;
    while (rig.time_s() < 0.5) {
      if (random.uniform() < 0.2) {
        command_deg = 40.0 * (random.uniform() - 0.5);
      }
      naive.run(rig.time_s(), rig.time_s() + dt_s, pulse_us(command_deg));
      rig.servo.step(rig.time_s(), dt_s, pulse_us(command_deg));
      ++rig.tick;
      // The naive one errs by a microsecond of its fastest movement at each change, and less by Euler.
      ASSERT_NEAR(rig.angle_deg(), naive.angle_rad() / degree, 4e-3) << round << " at " << rig.time_s();
    }
  }
}

TEST(Servo, TheAngleDoesNotDependOnHowTimeIsCut) {
  ServoRig coarse{{}, 0.012};
  ServoRig fine{{}, 0.0005};
  for (int step = 1; step <= 50; ++step) {
    const double pulse = pulse_us(step % 2 == 0 ? 12.0 : -3.0 * step);
    coarse.run(0.012 * step, pulse);
    fine.run(0.012 * step, pulse);
    EXPECT_NEAR(coarse.angle_deg(), fine.angle_deg(), 1e-9);
  }
}

TEST(Servo, RefusesParametersOutsideTheirRange) {
  const auto refused = [](auto change) {
    ServoParameters p;
    change(p);
    EXPECT_THROW(Servo{p}, std::invalid_argument);
  };
  refused([](ServoParameters& p) { p.lag_s = 0.0; });
  refused([](ServoParameters& p) { p.lag_s = std::nan(""); });
  refused([](ServoParameters& p) { p.delay_s = 0.06; });
  refused([](ServoParameters& p) { p.frame_period_s = 0.0009; });
  refused([](ServoParameters& p) { p.rate_limit_rad_s = 0.0; });
  refused([](ServoParameters& p) { p.stop_rad = 0.0; });
  refused([](ServoParameters& p) { p.backlash_rad = -0.1; });
  refused([](ServoParameters& p) { p.pulse_per_degree_us = 0.0; });
  refused([](ServoParameters& p) { p.centre_rad = 1.01 * p.stop_rad; });
  refused([](ServoParameters& p) { p.centre_rad = std::nan(""); });
}

}  // namespace
}  // namespace fantail::sim
