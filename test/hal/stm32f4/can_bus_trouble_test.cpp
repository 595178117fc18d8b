// SPDX-License-Identifier: MIT
// A bus on which something is wrong.

#include "can_bus_rig.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

TEST(CanBusTrouble, AloneItGoesPassiveTakesFramesForEverAndNeverWaits) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  rig.model.heard = false;
  std::uint32_t taken = 0;
  constexpr std::uint32_t frames = 1000;
  for (std::uint32_t i = 0; i < frames; ++i) {
    const std::uint64_t before = rig.world.accesses();
    taken += rig.bus.send(numbered(i)) ? 1U : 0U;
    EXPECT_LT(rig.world.accesses() - before, 80U) << "the handler that it calls included";
    rig.model.run(2);
  }
  EXPECT_EQ(rig.bus.state(), CanState::error_passive);
  EXPECT_EQ(taken, frames);
  const CanCounters counters = rig.bus.counters();
  EXPECT_EQ(counters.sent, 0U);
  EXPECT_GT(counters.unsent, frames - 68) << "all but what still waits";
  EXPECT_EQ(rig.model.mistakes, 0);
}

TEST(CanBusTrouble, WhoAppearsOnTheBusHearsNothingOlderThanOneQueue) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  rig.model.heard = false;
  std::uint32_t number = 0;
  for (; number < 5000; ++number) {
    (void)rig.bus.send(numbered(number));
    (void)rig.model.slot();
  }
  rig.model.heard = true;
  rig.model.run(100);
  ASSERT_FALSE(rig.model.wire.empty());
  EXPECT_GE(number_of(rig.model.wire.front()), number - CanBus::transmit_queue - 3);
  EXPECT_EQ(number_of(rig.model.wire.back()), number - 1);
}

TEST(CanBusTrouble, AFullQueueOnABusThatWorksThrowsNothingAway) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  for (std::uint32_t i = 0; i < 200; ++i) {
    (void)rig.bus.send(numbered(i));
  }
  rig.model.run(100);
  EXPECT_EQ(rig.model.wire.size(), 67U);
  EXPECT_EQ(number_of(rig.model.wire.back()), 66U);
}

TEST(CanBusTrouble, TheStateFollowsTheErrorCounters) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  const auto state_at = [&rig](std::uint32_t transmit, std::uint32_t receive) {
    rig.model.set_errors(transmit, receive);
    return rig.bus.state();
  };
  EXPECT_EQ(state_at(95, 95), CanState::error_active);
  EXPECT_EQ(state_at(96, 0), CanState::error_warning);
  EXPECT_EQ(state_at(0, 96), CanState::error_warning);
  EXPECT_EQ(state_at(128, 0), CanState::error_passive);
  EXPECT_EQ(state_at(0, 128), CanState::error_passive);
  rig.model.go_bus_off();
  EXPECT_EQ(rig.bus.state(), CanState::bus_off);
}

TEST(CanBusTrouble, EveryErrorFrameIsCountedOneATickAtMost) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  for (std::uint32_t code = 1; code <= 6; ++code) {
    rig.model.disturb(code);
    (void)rig.bus.receive();
  }
  EXPECT_EQ(rig.bus.counters().errors, 6U);
  const int before = rig.model.interrupts;
  for (int i = 0; i < 1000; ++i) {
    rig.model.disturb(2);
  }
  EXPECT_EQ(rig.bus.counters().errors, 7U);
  EXPECT_EQ(rig.model.interrupts - before, 1) << "a storm of errors is not one of interrupts";
}

TEST(CanBusTrouble, AnErrorIsCountedThoughTheNextFrameWentWell) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  ASSERT_TRUE(rig.bus.send(numbered(1)));
  rig.model.disturb(1);
  rig.model.run(1);  // clears LEC
  EXPECT_EQ(rig.bus.counters().errors, 1U);
}

TEST(CanBusTrouble, BusOffIsCountedThrowsAwayWhatWaitsAndEndsByItself) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  for (std::uint32_t i = 0; i < 10; ++i) {
    ASSERT_TRUE(rig.bus.send(numbered(i)));
  }
  rig.model.go_bus_off();
  EXPECT_EQ(rig.bus.times_bus_off(), 1U);
  EXPECT_EQ(rig.bus.counters().unsent, 10U);
  EXPECT_EQ(rig.model.pending_mailboxes(), 0);
  EXPECT_FALSE(rig.bus.send(numbered(10)));
  rig.model.recessive(127);
  EXPECT_EQ(rig.bus.state(), CanState::bus_off);
  rig.model.recessive(1);
  EXPECT_EQ(rig.bus.state(), CanState::error_active);
  ASSERT_TRUE(rig.bus.send(numbered(11)));
  rig.model.run(10);
  ASSERT_EQ(rig.model.wire.size(), 1U);
  EXPECT_EQ(number_of(rig.model.wire[0]), 11U);
  rig.model.go_bus_off();
  EXPECT_EQ(rig.bus.times_bus_off(), 2U);
}

TEST(CanBusTrouble, AFrameThatIsSentInTheMomentOfBusOffIsNotKeptForLater) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  rig.model.masked = true;
  ASSERT_TRUE(rig.bus.send(numbered(1)));
  rig.model.go_bus_off();
  rig.model.masked = false;
  rig.model.serve();
  rig.model.recessive(128);
  rig.model.run(5);
  EXPECT_TRUE(rig.model.wire.empty());
  EXPECT_EQ(rig.bus.counters().unsent, 1U);
}

// What the bus does comes at any access to a register, in the loop and in the handlers: no frame is lost without being
// counted, none comes twice, and those of one identifier stay in order.
TEST(CanBusTrouble, WheneverTheBusActsEveryFrameIsAccountedFor) {
  std::mt19937 random{fantail::test::seed()};
  const auto chance = [&random](unsigned one_in) { return random() % one_in == 0; };
  for (int run = 0; run < 20; ++run) {
    CanBusRig rig;
    ASSERT_FALSE(rig.start());
    std::uint32_t arrived = 0;
    rig.model.meanwhile = [&] {
      if (chance(3)) {
        (void)rig.model.slot();
      }
      if (chance(6)) {
        arrived += rig.model.arrive(numbered(arrived)) ? 1U : 0U;
      }
      if (chance(300)) {
        rig.model.heard = !rig.model.heard;
      }
      if (chance(2000)) {
        rig.model.go_bus_off();
      }
      rig.model.recessive(chance(50) ? 128 : 0);
    };
    constexpr std::uint32_t calls = 3000;
    std::uint32_t got = 0;
    std::optional<std::uint32_t> newest;
    for (std::uint32_t i = 0; i < calls; ++i) {
      (void)rig.bus.send(numbered(i, 0x100 + i % 5));
      while (const auto frame = rig.bus.receive()) {
        EXPECT_TRUE(!newest || number_of(*frame) > *newest);
        newest = number_of(*frame);
        got += 1;
      }
    }
    rig.model.meanwhile = {};
    rig.model.heard = true;
    rig.model.recessive(128);
    rig.model.run(100);
    while (rig.bus.receive()) {
      got += 1;
    }
    const CanCounters counters = rig.bus.counters();
    EXPECT_EQ(counters.sent + counters.unsent, calls);
    EXPECT_EQ(counters.sent, rig.model.wire.size());
    EXPECT_EQ(counters.received, got);
    EXPECT_LE(got + counters.overrun, arrived);
    std::map<std::uint32_t, std::uint32_t> last;
    for (const CanFrame& frame : rig.model.wire) {
      const auto before = last.find(frame.id);
      EXPECT_TRUE(before == last.end() || before->second < number_of(frame)) << "an older frame came behind a newer";
      last[frame.id] = number_of(frame);
    }
    EXPECT_GT(rig.model.wire.size(), calls / 10);
    EXPECT_EQ(rig.model.mistakes, 0);
  }
}

}  // namespace
}  // namespace fantail::hal::stm32f4
