// SPDX-License-Identifier: MIT
// A reset in flight, and what lies in the flash: the plan, and the record of the flight.

#include "avionics/plan_store.hpp"
#include "flash_rig.hpp"
#include "flying_rig.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/log_tick.hpp"
#include "protocol/state_block.hpp"
#include "protocol/tick_digest.hpp"
#include "recorder_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using hal::ResetCause;

/// A good plan in the flash, as a bench would have left it.
void store(hal::sim::Flash& flash, const core::FlightPlan& plan) {
  FlashAccess access{flash};
  PlanStore plans{access};
  (void)plans.load({});
  const Bytes block = block_of(plan);
  plans.begin_write(block);
  for (int i = 0; i < 100 && plans.write() == PlanWrite::under_way; ++i) {
    plans.update(i * millisecond);
  }
  ASSERT_EQ(plans.write(), PlanWrite::stored);
}

core::FlightPlan other_plan() {
  core::FlightPlan plan = core::default_plan();
  plan.run.control_time = 7 * second;
  return plan;
}

TEST(ResumePlan, TheFlightGoesOnWithThePlanFromTheFlash) {
  FlyingRig rig;
  store(rig.flash, other_plan());
  rig.power_cycle();
  rig.launch_to_control();
  const Microseconds begin = rig.true_time;
  rig.fly_for(second);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly_for(second)->phase, Phase::controlling);
  rig.disturbance_rad = 0.0;
  ASSERT_EQ(rig.fly_to(Phase::finished, 10 * second)->reason, core::PhaseReason::control_time_over);
  EXPECT_NEAR(static_cast<double>((rig.true_time - begin).count()), 7e6, 11e3);
}

TEST(ResumePlan, AFlashThatSaysAnotherPlanThanTheOneThatFlewMakesTheRocketSafe) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(second);
  store(rig.flash, other_plan());
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly_for(second)->phase, Phase::safe);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_NE(rig.console.text.find("flight: not resumed\n"), std::string::npos);
}

TEST(ResumePlan, APlanThatCannotBeReadAnyMoreMakesTheRocketSafe) {
  FlyingRig rig;
  store(rig.flash, other_plan());
  rig.power_cycle();
  rig.launch_to_control();
  rig.flash.set_answers(false);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly_for(second)->phase, Phase::safe);
}

TEST(ResumePlan, TheBuiltInPlanIsFlownOnThoughTheFlashIsSilent) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.flash.set_answers(false);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly().phase, Phase::controlling);
}

// A program that the reset found half done: 3 ms at worst.
TEST(ResumePlan, AFlashThatIsBusyAfterTheResetIsWaitedForAndTheGapIsBridgedAsFarAsItWas) {
  FlyingRig rig;
  rig.disturbance_rad = 0.02;
  rig.launch_to_control();
  rig.fly_for(second);
  const double off_before = static_cast<double>(rig.fly().motion.roll_angle.radians()) - rig.angle_rad;
  rig.flash.set_stays_busy(true);
  rig.reset(ResetCause::watchdog);
  EXPECT_EQ(rig.fly_for(3 * millisecond)->phase, Phase::safe);
  rig.flash.set_stays_busy(false);
  const core::TickRecord& record = rig.fly();
  EXPECT_EQ(record.phase, Phase::controlling);
  EXPECT_FALSE(record.timing_fault);
  const double off = static_cast<double>(record.motion.roll_angle.radians()) - rig.angle_rad;
  const double gap_s = 0.074;
  EXPECT_NEAR(off, off_before, rig.largest_acceleration * gap_s * gap_s / 4.0 + 0.011 * rig.largest_rate);
}

TEST(ResumePlan, AFlashThatStaysBusyForTooLongMakesTheRocketSafe) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.flash.set_stays_busy(true);
  rig.reset(ResetCause::watchdog);
  rig.fly_for(300 * millisecond);
  rig.flash.set_stays_busy(false);
  EXPECT_EQ(rig.fly_for(second)->phase, Phase::safe);
}

/// The flights that lie in the flash, each replayed from its checkpoints.
struct Replayed {
  int ticks = 0;
  int equal = 0;
  std::optional<Phase> first_phase{};
  std::optional<protocol::LogEvent> first_event_of_phase{};
  core::Microseconds begin{};
};

std::vector<Replayed> replay_flights(hal::sim::Flash& flash, const core::FlightPlan& plan) {
  std::vector<Replayed> flights;
  std::optional<core::Autopilot> law;
  protocol::SampleTimes times{};
  std::optional<protocol::LogHeader> header;
  std::optional<std::uint32_t> flight;
  protocol::LogFrameReader reader{region_of(flash)};
  while (const auto frame = reader.next()) {
    switch (static_cast<protocol::LogRecord>(frame->head.type)) {
      case protocol::LogRecord::header:
        header = protocol::decode_log_header(frame->payload);
        if (flight != header->flight) {
          flight = header->flight;
          flights.push_back({.begin = frame->head.time});
        }
        break;
      case protocol::LogRecord::checkpoint: {
        law.emplace(plan);
        EXPECT_TRUE(protocol::restore_state(*law, frame->payload.subspan(protocol::log_checkpoint_times_size)));
        times = {.imu = core::Microseconds{static_cast<std::int64_t>(protocol::get<8>(frame->payload, 0))},
                 .accelerometer = core::Microseconds{static_cast<std::int64_t>(protocol::get<8>(frame->payload, 8))}};
        break;
      }
      case protocol::LogRecord::tick: {
        const auto tick = protocol::unpack_tick(frame->head.time, frame->payload, times);
        const SampleScales made_scales{
            .imu = {.rate_rad_s = header->rate_scale_rad_s, .specific_force_m_s2 = header->specific_force_scale_m_s2},
            .accelerometer_m_s2 = header->accelerometer_scale_m_s2};
        const core::TickRecord& record = law->step(inputs_of(*tick, made_scales, plan.canards));
        Replayed& now = flights.back();
        now.first_phase = now.first_phase.value_or(record.phase);
        now.ticks += 1;
        now.equal += protocol::tick_digest(record) == tick->digest ? 1 : 0;
        break;
      }
      case protocol::LogRecord::event: {
        const auto event = protocol::unpack_event(frame->head.time, frame->payload);
        if (event->kind == protocol::LogEventKind::phase && !flights.back().first_event_of_phase) {
          flights.back().first_event_of_phase = *event;
        }
        break;
      }
      case protocol::LogRecord::health: break;
    }
  }
  return flights;
}

TEST(ResumePlan, TheRestOfTheFlightIsARecordOfItsOwnThatIsReplayed) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(200 * millisecond);
  rig.reset(ResetCause::watchdog);
  const Microseconds again = rig.hardware.time;
  rig.fly_for(600 * millisecond);
  const auto flights = replay_flights(rig.flash, core::default_plan());
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_GT(flights[0].ticks, 500);
  EXPECT_EQ(flights[0].equal, flights[0].ticks);
  // Power-ups are counted and a blank sector is found first: two sectors and one, 256 bytes a tick, and some.
  EXPECT_LE(flights[1].begin - again, 70 * millisecond);
  EXPECT_GT(flights[1].ticks, 450);
  EXPECT_EQ(flights[1].equal, flights[1].ticks);
  EXPECT_EQ(flights[1].first_phase, Phase::controlling);
  ASSERT_TRUE(flights[1].first_event_of_phase);
  EXPECT_EQ(flights[1].first_event_of_phase->value, static_cast<std::uint8_t>(Phase::controlling));
  EXPECT_EQ(flights[1].first_event_of_phase->detail, static_cast<std::uint8_t>(core::PhaseReason::guide_clear));
}

TEST(ResumePlan, AFlightThatIsNotResumedLeavesItsRecordAlone) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(200 * millisecond);
  const auto before = replay_flights(rig.flash, core::default_plan());
  rig.reset(ResetCause::power_on);
  rig.fly_for(second);
  const auto after = replay_flights(rig.flash, core::default_plan());
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].ticks, before[0].ticks);
}

}  // namespace
}  // namespace fantail::avionics
