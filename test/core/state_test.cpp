// SPDX-License-Identifier: MIT
#include <bit>

#include "core/autopilot.hpp"
#include "core/canard_mixer.hpp"
#include "core/canard_monitor.hpp"
#include "core/flight_phase.hpp"
#include "core/flight_plan.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/inputs.hpp"
#include "core/motion_estimator.hpp"
#include "core/tick_record.hpp"
#include "phase_sequence.hpp"
#include "state_copy.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

// A mixer whose memory is not what it left there: a flipped bit, or a state that came back after a reset.

using namespace literals;

constexpr Microseconds tick{1000};
const EncoderAngles at_zero{Angle{}, Angle{}, Angle{}, Angle{}};

// Puts every canard that is in its first motion somewhere else.
class MoveTo {
 public:
  explicit MoveTo(Angle place) : place_{place} {}
  template <typename... T>
  void operator()(T&... values) const {
    (each(values), ...);
  }

 private:
  template <typename T, std::size_t n>
  void each(std::array<T, n>& values) const {
    for (T& value : values) {
      value.visit_state(*this);
    }
  }
  void each(std::optional<Angle>& position) const { position = place_; }
  template <typename T>
  void each(T& /*other*/) const {}

  Angle place_;
};

class MovedTo : public testing::TestWithParam<float> {};

TEST_P(MovedTo, NoPositionInTheFirstMotionIsCommandedBeyondTheLimit) {
  CanardMixer mixer{default_plan().canards, 9_deg};
  CanardCommands commands;
  mixer.mix(Microseconds{0}, 9_deg, std::nullopt, at_zero, commands);
  mixer.mix(tick, 9_deg, std::nullopt, at_zero, commands);
  ASSERT_TRUE(commands[0].limited) << "it is not in its first motion";
  const MoveTo move{Angle::from_radians(GetParam())};
  mixer.visit_state(move);
  for (int i = 2; i < 2000; ++i) {
    mixer.mix(i * tick, Angle{}, std::nullopt, at_zero, commands);
    for (std::size_t c = 0; c < canard_count; ++c) {
      ASSERT_LE(std::abs(commands[c].angle.degrees()), 9.0F) << "canard " << c << " at " << i;
    }
  }
  EXPECT_EQ(commands[0].angle, 0_deg);
}

INSTANTIATE_TEST_SUITE_P(Radians, MovedTo,
                         testing::Values(0.2F, -0.2F, 1e30F, -std::numeric_limits<float>::max(),
                                         std::numeric_limits<float>::infinity(),
                                         std::numeric_limits<float>::quiet_NaN()));

// A monitor that is given the state of another, as after a reset.

using namespace literals;

// A canard that has moved a little and is not yet stalled, one that disagrees, one that lags behind its command, and
// one whose encoder has been silent for a while: each is to be judged later by what was remembered of it.
TEST(CanardMonitor, OneThatIsGivenTheStateOfAnotherGoesOnAsTheOtherDoes) {
  const FlightPlan plan = default_plan();
  CanardMonitor monitor{plan.monitor, plan.canards};
  CanardCommands commands{};
  EncoderAngles encoders{};
  encoders.fill(Angle{});
  for (CanardCommand& command : commands) {
    command.driven = true;
  }
  Microseconds time{1'000};
  const auto judged_by = [&](CanardMonitor& judge) { return judge.update(time, commands, encoders); };
  judged_by(monitor);
  encoders[1] = 2_deg;
  for (int i = 0; i < 180; ++i) {
    commands[2].angle = i < 170 ? Angle{} : 8_deg;
    encoders[0] = i < 130 ? Angle{} : i < 140 ? 10_deg : 11_deg;
    encoders[3] = i < 170 ? std::optional{Angle{}} : std::nullopt;
    time += Microseconds{1'000};
    judged_by(monitor);
  }
  ASSERT_EQ(monitor.verdicts(), (CanardVerdicts{CanardVerdict::healthy, CanardVerdict::disagreeing}));
  CanardMonitor given{plan.monitor, plan.canards};
  copy_state(monitor, given);
  EXPECT_EQ(given.verdicts(), monitor.verdicts());
  bool slipped = false;
  bool dead = false;
  bool stalled = false;
  for (int i = 0; i < 300; ++i) {
    encoders[1] = Angle{};
    time += Microseconds{1'000};
    ASSERT_EQ(judged_by(given), judged_by(monitor)) << i;
    slipped = slipped || monitor.verdicts()[0] == CanardVerdict::slipping;
    stalled = stalled || monitor.verdicts()[2] == CanardVerdict::stalled;
    dead = dead || monitor.verdicts()[3] == CanardVerdict::dead;
  }
  EXPECT_TRUE(slipped && stalled && dead);
}

// What stands in the structures that are passed about before anybody has written into them: nothing is asked for,
// nothing has been measured, and nothing has happened.

TEST(InitialValues, OfInputsAskForNothing) {
  const Inputs inputs;
  EXPECT_FALSE(inputs.arm_switch_closed);
  EXPECT_FALSE(inputs.arm_command);
  EXPECT_FALSE(inputs.start_command);
  EXPECT_FALSE(inputs.abort);
  EXPECT_FALSE(inputs.canard_request);
  EXPECT_FALSE(inputs.second_gyro);
  EXPECT_EQ(inputs.gyro.quality, SampleQuality::absent);
  for (const AccelerometerSample& sample : inputs.accelerometers) {
    EXPECT_EQ(sample.quality, SampleQuality::absent);
  }
  for (const auto& encoder : inputs.encoders) {
    EXPECT_FALSE(encoder);
  }
}

TEST(InitialValues, OfAVectorAreZero) {
  const Vector3 vector;
  EXPECT_EQ(vector.x, 0.0F);
  EXPECT_EQ(vector.y, 0.0F);
  EXPECT_EQ(vector.z, 0.0F);
}

TEST(InitialValues, OfAMotionAreThoseOfRestWithoutASensor) {
  const Motion motion;
  EXPECT_EQ(motion.roll_angle, Angle{});
  EXPECT_EQ(motion.roll_rate_rad_s, 0.0F);
  EXPECT_EQ(motion.height_m, 0.0F);
  EXPECT_EQ(motion.distance_along_guide_m, 0.0F);
  EXPECT_EQ(motion.speed_m_s, 0.0F);
  EXPECT_EQ(motion.vertical_speed_m_s, 0.0F);
  EXPECT_EQ(motion.tilt, Angle{});
  EXPECT_FALSE(motion.tilt_from_guide);
  EXPECT_EQ(motion.gyro, SensorState::failed);
  EXPECT_EQ(motion.accelerometer, SensorState::failed);
  EXPECT_FALSE(motion.rate_is_lower_bound);
  EXPECT_FALSE(motion.roll_is_bridged);
  EXPECT_FALSE(motion.speed_is_lower_bound);
}

TEST(InitialValues, OfARecordHaveNeitherAFaultNorAMissedTickNorALimit) {
  const TickRecord record;
  EXPECT_EQ(record.command_status, CommandStatus::outside_control);
  EXPECT_FALSE(record.timing_fault);
  EXPECT_EQ(record.overruns, 0U);
  EXPECT_FALSE(record.saturated);
  EXPECT_FALSE(record.gyro_vote);
  EXPECT_FALSE(record.canard_angle);
}

// A rocket with four canards, and two accelerometers.
TEST(Limits, ThereAreFourCanardsAndTwoAccelerometers) {
  EXPECT_EQ(canard_count, 4U);
  EXPECT_EQ(Inputs{}.accelerometers.size(), 2U);
}

// As the manual says of a plan.
TEST(Limits, APlanHasRoomForSixRowsOfGainsAndEightStepsAndNoCanardGoesBeyondTwentyDegrees) {
  EXPECT_EQ(most_schedule_rows, 6U);
  EXPECT_EQ(most_reference_steps, 8U);
  EXPECT_NEAR(hard_canard_limit.radians(), 0.3490658504F, 1e-7F);
}

// 1000 g and 16 turns a second, rounded; the standard's gravity.
TEST(Limits, TheLargestThatIsAMeasurementIsThatOfAnySensorThatFitsARocket) {
  EXPECT_EQ(largest_specific_force_m_s2, 10'000.0F);
  EXPECT_EQ(largest_rate_rad_s, 100.0F);
  EXPECT_EQ(standard_gravity_m_s2, 9.80665F);
}

// The phases of a law whose memory is not what it left there.

/// The times that a log would hold.
struct Times {
  std::vector<Microseconds> found;
  template <typename... T>
  void operator()(T&... values) {
    (each(values), ...);
  }
  template <typename T>
  void below(std::size_t /*limit*/, T& /*value*/) {}

 private:
  void each(const Microseconds& time) { found.push_back(time); }
  template <typename T>
  void each(const T& /*other*/) {}
};

TEST(FlightPhase, DamagedMemoryEndsAFlightAndNothingElse) {
  Sequence sequence;
  FlightPhase safe = sequence.phases();
  safe.give_up(ms(1));
  EXPECT_EQ(safe.phase(), Phase::safe);
  FlightPhase armed = sequence.arm().phases();
  armed.give_up(ms(1));
  EXPECT_EQ(armed.phase(), Phase::armed);
  EXPECT_EQ(armed.reason(), PhaseReason::armed_by_switch_and_command);
  FlightPhase launched = sequence.launch().phases();
  launched.give_up(ms(1));
  EXPECT_EQ(launched.phase(), Phase::finished);
  EXPECT_EQ(launched.reason(), PhaseReason::memory_fault);
  Times since;
  launched.visit_state(since);
  EXPECT_EQ(since.found, std::vector{ms(1)});
  launched.give_up(ms(2));
  EXPECT_EQ(launched.reason(), PhaseReason::memory_fault);
}

// What is watched of a law in flight (avionics/memory_watch.hpp) goes up to what the pad taught, the zero of the gyro
// and the direction of gravity with the flag that they are known, and no further: behind it lies what changes on the
// pad only.
TEST(AutopilotMemory, OfAFlightEndsWithTheAverageOfThePad) {
  Autopilot law{default_plan()};
  Inputs inputs;
  const std::array<float, 6> pad{0x1p-7F, -0x1p-8F, 0x1p-9F, 9.75F, 0.5F, -0.25F};
  for (int i = 0; i < 4'000; ++i) {
    inputs.time += Microseconds{1'000};
    inputs.gyro = {.time = inputs.time, .rate_rad_s = {pad[0], pad[1], pad[2]}, .quality = SampleQuality::valid};
    inputs.accelerometers.fill(
        {.time = inputs.time, .specific_force_m_s2 = {pad[3], pad[4], pad[5]}, .quality = SampleQuality::valid});
    law.step(inputs);
  }
  const std::span<const std::byte> memory = law.flight_memory();
  constexpr std::size_t average_size = sizeof pad + 4;  // with the flag, in a word
  ASSERT_GT(memory.size(), average_size);
  ASSERT_LT(memory.size(), sizeof law);
  std::array<float, 6> last{};
  std::memcpy(last.data(), memory.last(average_size).data(), sizeof last);
  EXPECT_EQ(last, pad);
}

}  // namespace

}  // namespace fantail::core
