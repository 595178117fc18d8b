// SPDX-License-Identifier: MIT
// A monitor that is given the state of another, as after a reset.

#include <gtest/gtest.h>

#include "core/canard_monitor.hpp"
#include "core/flight_plan_fields.hpp"
#include "state_copy.hpp"

namespace fantail::core {
namespace {

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

}  // namespace
}  // namespace fantail::core
