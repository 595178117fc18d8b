// SPDX-License-Identifier: MIT
#include "core/canard_mixer.hpp"

#include <bit>

#include "core/flight_plan_fields.hpp"
#include "plan_generator.hpp"
#include "properties.hpp"

namespace fantail::core {
namespace {

using namespace literals;
using Request = std::array<Angle, canard_count>;

constexpr Microseconds tick{1000};
const EncoderAngles at_zero{Angle{}, Angle{}, Angle{}, Angle{}};
const EncoderAngles silent{};

Angle not_a_number() { return Angle::from_radians(std::numeric_limits<float>::quiet_NaN()); }

CanardCommands mixed(CanardMixer& mixer, Microseconds time, Angle roll_command, const std::optional<Request>& request,
                     const EncoderAngles& encoders) {
  CanardCommands commands;
  mixer.mix(time, roll_command, request, encoders, commands);
  return commands;
}

// A mixer whose first motions are over: each canard has reached trim, a second after power-up.
struct WarmMixer {
  WarmMixer(const CanardsPlan& canards, Angle plan_limit) : mixer{canards, plan_limit} {
    for (; time < Microseconds{1'000'000}; time += tick) {
      mixed(mixer, time, Angle{}, std::nullopt, at_zero);
    }
  }
  CanardCommands mix(Angle roll_command, const std::optional<Request>& request = std::nullopt) {
    time += tick;
    return mixed(mixer, time, roll_command, request, at_zero);
  }
  CanardMixer mixer;
  Microseconds time{};
};

TEST(CanardMixer, ARollCommandTurnsEveryCanardTheWayThatRollsPositively) {
  CanardsPlan plan = default_plan().canards;
  plan.each[1].direction = Direction::reversed;
  WarmMixer warm{plan, 9_deg};
  const CanardCommands commands = warm.mix(4_deg);
  EXPECT_EQ(commands[0].angle, 4_deg);
  EXPECT_EQ(commands[1].angle, -4_deg);
  EXPECT_EQ(commands[2].angle, 4_deg);
  EXPECT_FALSE(commands[0].limited);
}

TEST(CanardMixer, TrimIsAShaftAngleAndKeepsItsSignOnAReversedCanard) {
  CanardsPlan plan = default_plan().canards;
  plan.each[0].trim = 2_deg;
  plan.each[1].trim = 2_deg;
  plan.each[1].direction = Direction::reversed;
  WarmMixer warm{plan, 9_deg};
  const CanardCommands commands = warm.mix(3_deg);
  EXPECT_FLOAT_EQ(commands[0].angle.degrees(), 5.0F);
  EXPECT_FLOAT_EQ(commands[1].angle.degrees(), -1.0F);
  EXPECT_EQ(warm.mix(0_deg)[1].angle, 2_deg);
}

TEST(CanardMixer, EachCanardIsClampedAgainAfterSignAndTrim) {
  CanardsPlan plan = default_plan().canards;
  plan.each[0].trim = 2_deg;
  plan.each[1].trim = -2_deg;
  plan.each[2].direction = Direction::reversed;
  plan.each[2].trim = -2_deg;
  WarmMixer warm{plan, 6_deg};
  const CanardCommands commands = warm.mix(6_deg);
  EXPECT_EQ(commands[0].angle, 6_deg);
  EXPECT_TRUE(commands[0].limited);
  EXPECT_FLOAT_EQ(commands[1].angle.degrees(), 4.0F);
  EXPECT_FALSE(commands[1].limited);
  EXPECT_EQ(commands[2].angle, -6_deg);
  EXPECT_TRUE(commands[2].limited);
}

TEST(CanardMixer, TheSmallestOfPlanLimitHardLimitAndMechanicalStopHolds) {
  CanardsPlan plan = default_plan().canards;
  plan.each[1].mechanical_stop = 5_deg;
  const CanardMixer plan_limited{plan, 9_deg};
  EXPECT_EQ(plan_limited.limit(0), 9_deg);
  EXPECT_EQ(plan_limited.limit(1), 5_deg);
  plan.each[0].mechanical_stop = 45_deg;
  const CanardMixer hard_limited{plan, 30_deg};
  EXPECT_EQ(hard_limited.limit(0), hard_canard_limit);
  EXPECT_EQ(hard_limited.limit(1), 5_deg);
  WarmMixer warm{plan, 30_deg};
  EXPECT_EQ(warm.mix(40_deg)[0].angle, 20_deg);
  EXPECT_EQ(warm.mix(-40_deg)[1].angle, -5_deg);
}

TEST(CanardMixer, PulseFollowsTheCalibrationOfEachServo) {
  CanardsPlan plan = default_plan().canards;
  plan.each[1].pulse_centre_us = 1520.0F;
  plan.each[1].pulse_per_radian_us = Angle::from_radians(-8.0F).degrees();  // -8 us a degree
  WarmMixer warm{plan, 9_deg};
  const CanardCommands commands = warm.mix(6_deg);
  EXPECT_NEAR(commands[0].pulse_us, 1560.0F, 0.001F);
  EXPECT_NEAR(commands[1].pulse_us, 1472.0F, 0.001F);
}

TEST(CanardMixer, ACommandThatIsNotFiniteMeansTrim) {
  CanardsPlan plan = default_plan().canards;
  plan.each[2].trim = 1_deg;
  WarmMixer warm{plan, 9_deg};
  warm.mix(5_deg);
  for (const float bad : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::quiet_NaN()}) {
    const CanardCommands commands = warm.mix(Angle::from_radians(bad));
    EXPECT_EQ(commands[0].angle, 0_deg);
    EXPECT_EQ(commands[2].angle, 1_deg);
  }
}

TEST(CanardMixer, ARequestReplacesTheMixedAnglesAndPassesTheSameClamp) {
  WarmMixer warm{default_plan().canards, 9_deg};
  const CanardCommands commands = warm.mix(5_deg, Request{1_deg, -30_deg, not_a_number(), 9_deg});
  EXPECT_EQ(commands[0].angle, 1_deg);
  EXPECT_EQ(commands[1].angle, -9_deg);
  EXPECT_TRUE(commands[1].limited);
  EXPECT_EQ(commands[2].angle, 0_deg);
  EXPECT_EQ(commands[3].angle, 9_deg);
}

TEST(CanardMixer, FirstMotionStartsAtTheEncoderAndKeepsItsRate) {
  const CanardsPlan plan = default_plan().canards;  // 30 deg/s
  CanardMixer mixer{plan, 9_deg};
  const EncoderAngles found{6_deg, -6_deg, 0_deg, 30_deg};
  std::array<float, canard_count> last{6.0F, -6.0F, 0.0F, 9.0F};  // the fourth may only be driven inside its limit
  for (std::int64_t i = 0; i <= 400; ++i) {
    const CanardCommands commands = mixed(mixer, i * tick, Angle{}, std::nullopt, found);
    for (std::size_t c = 0; c < canard_count; ++c) {
      ASSERT_TRUE(commands[c].driven);
      ASSERT_LE(std::abs(commands[c].angle.degrees() - last[c]), 0.03F + 1e-5F) << "canard " << c << " at " << i;
      last[c] = commands[c].angle.degrees();
    }
    if (i == 100) {
      EXPECT_NEAR(last[0], 3.0F, 1e-3F);
      EXPECT_TRUE(commands[0].limited);
    }
  }
  for (const float angle : last) {
    EXPECT_EQ(angle, 0.0F);
  }
  EXPECT_EQ(mixed(mixer, Microseconds{401'000}, 9_deg, std::nullopt, found)[0].angle, 9_deg)
      << "only the first motion is slow";
}

TEST(CanardMixer, ACanardThatStandsWhereItShouldHasNoFirstMotion) {
  CanardMixer mixer{default_plan().canards, 9_deg};
  EXPECT_FALSE(mixed(mixer, Microseconds{}, Angle{}, std::nullopt, at_zero)[0].limited);
  EXPECT_EQ(mixed(mixer, tick, 9_deg, std::nullopt, at_zero)[0].angle, 9_deg);
}

TEST(CanardMixer, OfWhatStoodInTheCommandsNothingIsLeft) {
  CanardMixer mixer{default_plan().canards, 9_deg};
  CanardCommands commands;
  commands.fill({.angle = 5_deg, .pulse_us = 1500.0F, .driven = true, .limited = true});
  mixer.mix(Microseconds{}, Angle{}, std::nullopt, silent, commands);
  for (const CanardCommand& command : commands) {
    EXPECT_TRUE(command.angle == Angle{} && command.pulse_us == 0.0F && !command.driven && !command.limited);
  }
}

TEST(CanardMixer, ASilentEncoderKeepsItsCanardOffForHalfASecondOnly) {
  CanardMixer mixer{default_plan().canards, 9_deg};
  EncoderAngles encoders = at_zero;
  encoders[1].reset();
  encoders[2] = not_a_number();
  for (std::int64_t i = 0; i < 500; ++i) {
    const CanardCommands commands = mixed(mixer, i * tick, Angle{}, std::nullopt, encoders);
    ASSERT_TRUE(commands[0].driven);
    ASSERT_FALSE(commands[1].driven) << i;
    ASSERT_FALSE(commands[2].driven) << i;
  }
  const CanardCommands commands = mixed(mixer, Microseconds{500'000}, 5_deg, std::nullopt, encoders);
  EXPECT_TRUE(commands[1].driven);
  EXPECT_EQ(commands[1].angle, 5_deg);
  EXPECT_EQ(commands[2].angle, 5_deg);
}

TEST(CanardMixer, PatienceWithASilentEncoderIsCountedFromPowerUpWhateverTheClockReads) {
  const Microseconds power_up{3'600'000'000};
  CanardMixer mixer{default_plan().canards, 9_deg};
  EXPECT_FALSE(mixed(mixer, power_up, Angle{}, std::nullopt, silent)[0].driven);
  EXPECT_FALSE(mixed(mixer, power_up + Microseconds{499'999}, Angle{}, std::nullopt, silent)[0].driven);
  EXPECT_TRUE(mixed(mixer, power_up + Microseconds{500'000}, Angle{}, std::nullopt, silent)[0].driven);
}

TEST(CanardMixer, AClockThatRunsBackwardsDuringTheFirstMotionMovesNothing) {
  CanardMixer mixer{default_plan().canards, 9_deg};
  const EncoderAngles found{5_deg, 5_deg, 5_deg, 5_deg};
  mixed(mixer, Microseconds{10'000'000}, Angle{}, std::nullopt, found);
  for (const std::int64_t time : {9'999'000, 1000, 0}) {
    EXPECT_EQ(mixed(mixer, Microseconds{time}, Angle{}, std::nullopt, found)[0].angle, 5_deg) << time;
  }
}

TEST(CanardMixer, CanardAngleIsTheMeanRollAngleOfTheEncodersThatCanBeRead) {
  CanardsPlan plan = default_plan().canards;
  plan.each[1].direction = Direction::reversed;
  plan.each[2].trim = 1_deg;
  const CanardMixer mixer{plan, 9_deg};
  EXPECT_NEAR(mixer.canard_angle({4_deg, -6_deg, 9_deg, 2_deg})->degrees(), 5.0F, 1e-5F);
  EXPECT_NEAR(mixer.canard_angle({4_deg, -6_deg, std::nullopt, not_a_number()})->degrees(), 5.0F, 1e-5F);
  EXPECT_NEAR(mixer.canard_angle({std::nullopt, -6_deg, std::nullopt, std::nullopt})->degrees(), 6.0F, 1e-5F);
  EXPECT_FALSE(mixer.canard_angle(silent).has_value());
}

TEST(CanardMixer, WhatItCommandsIsWhatItReadsBack) {
  CanardsPlan plan = default_plan().canards;
  plan.each[0].direction = Direction::reversed;
  plan.each[0].trim = -2_deg;
  plan.each[3].trim = 3_deg;
  WarmMixer warm{plan, 20_deg};
  EncoderAngles encoders;
  const CanardCommands commands = warm.mix(7_deg);
  for (std::size_t i = 0; i < canard_count; ++i) {
    encoders[i] = commands[i].angle;
  }
  EXPECT_NEAR(warm.mixer.canard_angle(encoders)->degrees(), 7.0F, 1e-5F);
}

Angle any_angle() { return Angle::from_radians(std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>())); }

TEST(CanardMixer, WhatACanardAddsToTheRollIsItsAngleFromTrimInItsSenseUpToTwoDegreesBeyondItsStop) {
  CanardsPlan plan = default_plan().canards;
  plan.each[1].direction = Direction::reversed;
  plan.each[1].trim = 1_deg;
  plan.each[1].mechanical_stop = 15_deg;
  const CanardMixer mixer{plan, 9_deg};
  const auto added = mixer.contribution(1, 5_deg);
  ASSERT_TRUE(added);
  EXPECT_NEAR(added->degrees(), -4.0F, 1e-4F);
  EXPECT_TRUE(mixer.contribution(1, Angle::from_degrees(16.99F)));
  EXPECT_TRUE(mixer.contribution(1, Angle::from_degrees(-16.99F)));
  EXPECT_FALSE(mixer.contribution(1, Angle::from_degrees(17.01F)));
  EXPECT_FALSE(mixer.contribution(1, Angle::from_degrees(-17.01F)));
  EXPECT_TRUE(mixer.contribution(1, 15_deg + 2_deg));
  EXPECT_FALSE(mixer.contribution(1, std::nullopt));
  EXPECT_FALSE(mixer.contribution(1, not_a_number()));
}

TEST(CanardMixer, MovesAsPlannedAsLongAsNothingOfThePlanThatMovesACanardIsAnother) {
  const CanardsPlan plan = default_plan().canards;
  const CanardMixer mixer{plan, 9_deg};
  EXPECT_TRUE(mixer.moves_as_planned(2, plan, 9_deg));
  EXPECT_FALSE(mixer.moves_as_planned(2, plan, 8_deg)) << "the limit";
  const auto with = [&](auto change) {
    CanardsPlan other = plan;
    change(other.each[2]);
    EXPECT_TRUE(mixer.moves_as_planned(1, other, 9_deg)) << "of its neighbour nothing has changed";
    return mixer.moves_as_planned(2, other, 9_deg);
  };
  EXPECT_FALSE(with([](CanardPlan& of) {
    of.direction = of.direction == Direction::normal ? Direction::reversed : Direction::normal;
  }));
  EXPECT_FALSE(with([](CanardPlan& of) { of.trim = of.trim + 1_deg; }));
  EXPECT_FALSE(with([](CanardPlan& of) { of.mechanical_stop = of.mechanical_stop + 1_deg; }));
  EXPECT_FALSE(with([](CanardPlan& of) { of.pulse_centre_us += 1.0F; }));
  EXPECT_FALSE(with([](CanardPlan& of) { of.pulse_per_radian_us += 1.0F; }));
}

RC_GTEST_PROP(CanardMixer, NoPlanAndNoInputBringsACanardBeyondItsLimits, ()) {
  const FlightPlan plan = arbitrary_plan();
  CanardMixer mixer{plan.canards, plan.controller.canard_limit};
  for (int tick_number = 0; tick_number < 30; ++tick_number) {
    EncoderAngles encoders;
    Request request;
    for (std::size_t i = 0; i < canard_count; ++i) {
      encoders[i] = *rc::gen::arbitrary<bool>() ? std::optional{any_angle()} : std::nullopt;
      request[i] = any_angle();
    }
    const Microseconds time{*rc::gen::inRange<std::int64_t>(-1'000'000'000, 1'000'000'000)};
    const CanardCommands commands =
        mixed(mixer, time, any_angle(), *rc::gen::arbitrary<bool>() ? std::optional{request} : std::nullopt, encoders);
    for (std::size_t i = 0; i < canard_count; ++i) {
      const Angle reached = abs(commands[i].angle);
      RC_ASSERT(reached <= hard_canard_limit);
      RC_ASSERT(reached <= plan.controller.canard_limit);
      RC_ASSERT(reached <= plan.canards.each[i].mechanical_stop);
      RC_ASSERT(!commands[i].driven || (commands[i].pulse_us > 0.0F && commands[i].pulse_us < 4000.0F));
    }
  }
}

}  // namespace
}  // namespace fantail::core
