// SPDX-License-Identifier: MIT

#include "avionics/write_state.hpp"
#include "core/flight_plan_fields.hpp"
#include "flight_memory_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// By the sizes that protocol/state_block.hpp gives: of each gyro the time of its last sample, three rates and how often
// it has said the same; the three differences, of how many samples, since when they disagree, and who is doubted.
TEST(TwoGyrosState, ALawThatFliesOnTwoGyrosRemembers74BytesMore) {
  core::FlightPlan plan = core::default_plan();
  core::Autopilot one{plan};
  plan.sensors.gyros = core::GyroRule::two_agree;
  core::Autopilot two{plan};
  for (const auto extent : {protocol::StateExtent::whole, protocol::StateExtent::in_flight}) {
    EXPECT_EQ(write_state(two, {}, extent), write_state(one, {}, extent) + 2 * (8 + 12 + 4) + 12 + 4 + (1 + 8) + 1);
  }
}

TEST(TwoGyrosState, ALawThatDoubtsBothGyrosIsResumed) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  plan.sensors.gyros = core::GyroRule::two_agree;
  core::Autopilot law{plan};
  Memory memory{};
  Domain domain{memory};
  SetClock clock;
  FlightMemory kept{domain, clock, ResetCause::power_on};
  core::Inputs inputs{};
  inputs.arm_switch_closed = true;
  inputs.accelerometers.fill(
      {.time = {}, .specific_force_m_s2 = {.x = core::standard_gravity_m_s2}, .quality = core::SampleQuality::valid});
  inputs.gyro.quality = core::SampleQuality::valid;
  std::optional<core::GyroVote> vote;
  const auto run = [&](int ticks, float more_rad_s) {
    for (int i = 0; i < ticks; ++i) {
      inputs.time += millisecond;
      clock.shows = inputs.time;
      inputs.gyro.time = inputs.accelerometers[0].time = inputs.accelerometers[1].time = inputs.time;
      inputs.gyro.rate_rad_s.x = i % 2 == 0 ? 0.001F : -0.001F;  // one that repeats itself would be put aside
      inputs.second_gyro = inputs.gyro;
      inputs.second_gyro->rate_rad_s.x += more_rad_s;
      const core::TickRecord record = law.step(inputs);
      vote = record.gyro_vote;
      kept.keep(record, plan_crc, std::nullopt, law);
    }
  };
  run(5'000, 0.0F);
  inputs.arm_command = true;
  run(1, 0.0F);
  inputs.arm_command = false;
  inputs.start_command = true;
  run(1, 0.0F);
  inputs.start_command = false;
  run(40, 5.0F);
  ASSERT_EQ(law.phase(), Phase::controlling);
  ASSERT_EQ(vote, core::GyroVote::disagree);
  core::Inputs first = inputs;
  first.time += 60 * millisecond;
  EXPECT_TRUE(resume(memory, first, plan));
}

}  // namespace
}  // namespace fantail::avionics
