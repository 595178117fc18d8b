// SPDX-License-Identifier: MIT

#include "avionics/can_frame.hpp"
#include "bench/cycle.hpp"
#include "bench/perform.hpp"
#include "figures.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using bench::Cycle;
using bench::Judgement;

void run(BenchAtWorld& place, Cycle& cycle, const std::function<void(double)>& progress = [](double) {}) {
  link::AvionicsLink link{place.bus()};
  link::Session session = place.open_session(link);
  cycle.tolerances = place.scenario.vehicle.canard_tolerances;
  const auto lap =
      bench::Exercise::limits_together(bench::bounds(link.newest<protocol::LimitReport>()->message, session.trims()));
  bench::perform_laps(cycle, lap, session, link, progress);
  EXPECT_TRUE(session.close());
}

TEST(BenchCycle, AHealthyRocketPassesWithTheSameFiguresInEveryLap) {
  BenchAtWorld place{"bench_healthy"};
  Cycle cycle{.planned_laps = 12};
  double latest_s = 0.0;
  run(place, cycle, [&](double done_s) {
    EXPECT_GE(done_s, latest_s);
    latest_s = done_s;
  });
  ASSERT_EQ(cycle.laps.size(), 12U);
  EXPECT_NEAR(latest_s, 12 * cycle.lap_s, 0.1);
  EXPECT_EQ(bench::judgement(cycle), Judgement::pass) << bench::cycle_text(cycle);
  for (std::size_t canard = 0; canard < 4; ++canard) {
    const bench::Course lag = bench::lag_course(cycle, canard);
    EXPECT_NEAR(*lag.first, *lag.worst, 0.002);
    EXPECT_LT(text::degrees(*bench::tracking_rms_course(cycle, canard).worst),
              text::degrees(*bench::tracking_error_course(cycle, canard).worst));
  }
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(cycle.laps[i].begin_s, static_cast<double>(i) * cycle.lap_s, 0.1 * static_cast<double>(i) + 1e-9);
  }
}

TEST(BenchCycle, ACanardThatFailsLapAfterLapIsNamedAndEndsTheRun) {
  BenchAtWorld place{"bench_canard4_slow"};
  Cycle cycle{.planned_laps = 50};
  run(place, cycle);
  EXPECT_EQ(cycle.laps.size(), bench::most_failing_laps);
  EXPECT_EQ(figures(cycle.ended_because), std::vector<std::string>{"3"});
  EXPECT_EQ(bench::judgement(cycle), Judgement::fail);
  const std::string said = bench::cycle_text(cycle);
  EXPECT_NE(said.find("\nFAIL\n"), std::string::npos) << said;
  EXPECT_TRUE(tells(said, {"3", "3", "0", "4"})) << "3 of 3 laps, from 0 s on, canard 4; " << said;
  EXPECT_TRUE(says(said, bench::cause_text(bench::Cause::slow)) && says(said, "Canard 4")) << said;
  EXPECT_TRUE(std::ranges::none_of(bench::conclusions(cycle), [](const auto& s) { return says(s, "Canard 2"); }));
  EXPECT_GT(*bench::lag_course(cycle, 3).first, 1.5 * *bench::lag_course(cycle, 0).first);
}

TEST(BenchCycle, TheBatteryIsFollowedWhenItIsOnTheBus) {
  BenchAtWorld place{"bench_healthy"};
  hal::sim::CanBus board{place.wire};
  int ticks = 0;
  place.after_tick = [&] {
    if (++ticks % 10 == 0) {
      const auto millivolts = static_cast<std::uint16_t>(12'600 - ticks / 100);
      (void)board.send(avionics::can_frame(encode(protocol::BoardReport{.battery_mv = millivolts})));
    }
  };
  Cycle cycle{.planned_laps = 4};
  run(place, cycle);
  const bench::Course battery = bench::battery_course(cycle);
  ASSERT_TRUE(battery.first);
  EXPECT_GT(*battery.first, *battery.last);
  EXPECT_DOUBLE_EQ(*battery.worst, *battery.last);
  EXPECT_NEAR(*battery.first - *battery.last, 3 * cycle.lap_s / 100.0, 0.01) << "10 mV a second";
}

/// The PC reads nothing for 30 ms in the middle of this second.
void go_deaf_in(BenchAtWorld& place, int second_number) {
  const hal::Microseconds begin = second_number * second;
  place.after_tick = [&place, begin] {
    while (place.now() > begin && place.now() < begin + 30 * millisecond && place.pc_bus.receive()) {
    }
  };
}

TEST(BenchCycle, ALapThatThisPcWasTooSlowForIsLeftOutAndSaid) {
  BenchAtWorld place{"bench_healthy"};
  go_deaf_in(place, 20);
  Cycle cycle{.planned_laps = 20};
  run(place, cycle);
  ASSERT_EQ(cycle.laps.size(), 20U);
  EXPECT_EQ(std::ranges::count_if(cycle.laps, [](const bench::Lap& lap) { return !lap.measured(); }), 1);
  EXPECT_EQ(bench::judgement(cycle), Judgement::pass) << bench::cycle_text(cycle);
  EXPECT_EQ(figures(bench::conclusions(cycle).at(1)), std::vector<std::string>{"1"});
}

TEST(BenchCycle, APcThatIsTooSlowForMoreThanATwentiethVoidsTheRun) {
  BenchAtWorld place{"bench_canard3_reversed"};
  go_deaf_in(place, 10);
  Cycle cycle{.planned_laps = 10};
  EXPECT_THROW(run(place, cycle), bench::Unmeasured);
}

TEST(BenchCycle, WhatWasMeasuredBeforeAnInterruptIsKept) {
  struct Stop {};
  BenchAtWorld place{"bench_healthy"};
  Cycle cycle{.planned_laps = 50};
  EXPECT_THROW(run(place, cycle,
                   [](double done_s) {
                     if (done_s > 12.0) {
                       throw Stop{};
                     }
                   }),
               Stop);
  EXPECT_EQ(cycle.laps.size(), static_cast<std::size_t>(12.0 / cycle.lap_s));
  EXPECT_EQ(bench::judgement(cycle), Judgement::pass);
}

TEST(BenchCycle, WhatWasMeasuredBeforeThePowerWentIsKept) {
  BenchAtWorld place{"bench_healthy"};
  place.after_tick = [&] {
    if (place.now() > 20 * second) {
      place.switch_off();
    }
  };
  Cycle cycle{.planned_laps = 50};
  EXPECT_THROW(run(place, cycle), link::LinkError);
  EXPECT_GE(cycle.laps.size(), 2U);
}

// The steps of docs/can.md, "Arming", frame by frame, without a line of the bench.

using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::SelfTestState;

class ArmByManual : public testing::Test {
 protected:
  ArmByManual() { live(4'000); }

  void live(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      place.wait(millisecond);
      link.listen(place.now());
    }
  }
  ArmReply ask(ArmAction action, std::uint32_t nonce) {
    (void)place.bus().send(
        avionics::can_frame(encode(protocol::ArmRequest{.action = action, .nonce = nonce}, counter)));
    counter = (counter + 1U) & 0x0FU;
    live(110);
    return link.reported<ArmReply>("answer to arming");
  }
  std::uint32_t nonce_after_switch() {
    live(8'000);
    EXPECT_EQ(link.reported<ArmReply>("answer to arming").self_test, SelfTestState::passed);
    place.world->set_arm_switch(true);
    live(100);  // until the contact has settled
    const ArmReply reply = ask(ArmAction::begin, 0xFFFFFFFF);
    EXPECT_TRUE(reply.nonce);
    return reply.nonce.value_or(0);
  }

  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  std::uint8_t counter = 14;
};

TEST_F(ArmByManual, WithAnyNonceWhereNoneIsAskedForTheRocketIsArmed) {
  EXPECT_EQ(ask(ArmAction::self_test, 0x12345678).self_test, SelfTestState::running);
  EXPECT_EQ(ask(ArmAction::self_test, 0).refusal, ArmRefusal::none) << "again while it runs";
  const std::uint32_t first = nonce_after_switch();
  const ArmReply again = ask(ArmAction::begin, 7);
  ASSERT_TRUE(again.nonce);
  EXPECT_NE(*again.nonce, first);
  EXPECT_EQ(ask(ArmAction::confirm, *again.nonce).refusal, ArmRefusal::none);
  EXPECT_EQ(place.record.phase, core::Phase::armed);
  EXPECT_EQ(ask(ArmAction::confirm, *again.nonce).refusal, ArmRefusal::not_safe);
  EXPECT_EQ(place.record.phase, core::Phase::armed);
  place.world->set_arm_switch(false);
  live(100);
  EXPECT_EQ(place.record.phase, core::Phase::safe);
}

TEST_F(ArmByManual, AnOlderNonceIsWrongAndUsesTheNewestUp) {
  (void)ask(ArmAction::self_test, 0);
  const std::uint32_t first = nonce_after_switch();
  const std::uint32_t newest = ask(ArmAction::begin, 0).nonce.value_or(0);
  EXPECT_EQ(ask(ArmAction::confirm, first).refusal, ArmRefusal::wrong_nonce);
  EXPECT_EQ(ask(ArmAction::confirm, newest).refusal, ArmRefusal::no_nonce);
  EXPECT_EQ(place.record.phase, core::Phase::safe);
}

}  // namespace

}  // namespace fantail::sil
