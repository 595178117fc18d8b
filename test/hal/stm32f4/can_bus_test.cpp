// SPDX-License-Identifier: MIT

#include "hal/stm32f4/can_bus.hpp"

#include "can_bus_rig.hpp"
#include "hal/stm32f4/can_bit_timing.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

TEST(CanBus, JoinsTheBusWithItsTimingAndOpensTheTransceiver) {
  CanBusRig rig;
  EXPECT_EQ(rig.bus.state(), CanState::down);
  EXPECT_FALSE(rig.start());
  EXPECT_EQ(rig.model.btr(), 0x033F'0001U);
  EXPECT_FALSE(rig.silent());
  EXPECT_EQ(rig.bus.state(), CanState::error_active);
  EXPECT_EQ(rig.model.mistakes, 0);
}

TEST(CanBus, AClockThatMakesNoMegabitIsAFaultAndTheTransceiverStaysSilent) {
  CanBusRig rig;
  EXPECT_EQ(rig.bus.start(41'500'000, listens_to), BoardFault::can_failed);
  EXPECT_TRUE(rig.silent());
  EXPECT_EQ(rig.bus.state(), CanState::down);
}

TEST(CanBus, AControllerThatDoesNotAnswerIsAFaultAfterABoundedWait) {
  CanBusRig rig;
  rig.model.dead = true;
  EXPECT_EQ(rig.start(), BoardFault::can_failed);
  EXPECT_EQ(rig.model.mistakes, 0) << "its bit timing is left alone";
  EXPECT_LT(rig.world.accesses(), 30'000U);
  EXPECT_TRUE(rig.silent());
  EXPECT_EQ(rig.bus.state(), CanState::down);
  EXPECT_FALSE(rig.bus.send(numbered(1)));
  EXPECT_FALSE(rig.bus.receive());
  EXPECT_EQ(rig.bus.counters().unsent, 1U);
}

TEST(CanBus, RegistersThatReadZeroAsInTheEmulatorAreAFaultAndNotABus) {
  test::RegisterWorld world;
  registers::Can can{};
  registers::Gpio port{};
  registers::Register set_pending{};
  const auto ignore = [](std::uint32_t) {};
  for (registers::Register* place : {&can.mcr, &can.msr, &can.tsr, &can.rf0r, &can.esr, &can.fmr}) {
    world.on_write(*place, ignore);
  }
  CanBus bus{can, Pin{port, 0}, InterruptLine{set_pending, 19}};
  EXPECT_EQ(bus.start(apb1_hz, listens_to), BoardFault::can_failed);
  for (std::uint32_t i = 0; i < 100; ++i) {
    EXPECT_FALSE(bus.send(numbered(i)));
  }
  bus.on_transmit_interrupt();
  bus.on_receive_interrupt();
  bus.on_error_interrupt();
  EXPECT_EQ(bus.state(), CanState::down);
  EXPECT_EQ(bus.counters().unsent, 100U);
}

TEST(CanBus, ABusThatIsStuckIsAFaultAndIsJoinedWhenItIsFree) {
  CanBusRig rig;
  rig.model.stuck_bus = true;
  EXPECT_EQ(rig.start(), BoardFault::can_failed);
  EXPECT_LT(rig.world.accesses(), 30'000U);
  EXPECT_EQ(rig.bus.state(), CanState::down);
  EXPECT_FALSE(rig.bus.send(numbered(1)));
  rig.model.stuck_bus = false;
  for (int look = 0; look < 3; ++look) {
    (void)rig.bus.state();
  }
  EXPECT_EQ(rig.bus.state(), CanState::error_active);
  EXPECT_TRUE(rig.bus.send(numbered(2)));
  rig.model.run(1);
  EXPECT_EQ(rig.model.wire.size(), 1U);
}

TEST(CanBus, SendsEveryKindOfFrameAsItIs) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  const std::vector<CanFrame> frames{
      {.id = 0x7FF, .length = 8, .data = {1, 2, 3, 4, 5, 6, 7, 8}},
      {.id = 0, .length = 0},
      {.id = 0x1FFF'FFFF, .extended = true, .length = 5, .data = {0xFF, 0, 0xFF, 0, 0xFF}},
      {.id = 0x155, .remote = true, .length = 3},
  };
  for (const CanFrame& frame : frames) {
    EXPECT_TRUE(rig.bus.send(frame));
  }
  rig.model.run(10);
  EXPECT_EQ(rig.model.wire, frames);
  EXPECT_EQ(rig.bus.counters().sent, 4U);
  EXPECT_EQ(rig.model.mistakes, 0);
}

TEST(CanBus, AFrameThatNoBusHasIsRefusedAndCounted) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  EXPECT_FALSE(rig.bus.send({.id = 0x800}));
  EXPECT_FALSE(rig.bus.send({.id = 0x2000'0000, .extended = true}));
  EXPECT_FALSE(rig.bus.send({.id = 1, .length = 9}));
  EXPECT_EQ(rig.bus.counters().unsent, 3U);
}

TEST(CanBus, SendsInTheOrderOfTheCallsWhateverTheIdentifiersAre) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  constexpr std::uint32_t count = 67;  // queue and mailboxes
  for (std::uint32_t i = 0; i < count; ++i) {
    EXPECT_TRUE(rig.bus.send(numbered(i, i % 2 == 0 ? 0x700 : 0x100)));
  }
  EXPECT_FALSE(rig.bus.send(numbered(count))) << "full, on a bus that is well: this one is too much";
  rig.model.run(100);
  ASSERT_EQ(rig.model.wire.size(), count);
  for (std::uint32_t i = 0; i < count; ++i) {
    EXPECT_EQ(number_of(rig.model.wire[i]), i);
  }
  EXPECT_EQ(rig.bus.counters().sent, count);
  EXPECT_EQ(rig.bus.counters().unsent, 1U);
}

TEST(CanBus, HearsItsOwnIdentifiersAndNoOthers) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  int heard = 0;
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    const bool wanted = std::ranges::find(listens_to, id) != listens_to.end();
    EXPECT_EQ(rig.model.arrive(numbered(id, id)), wanted) << id;
    if (const auto frame = rig.bus.receive()) {
      EXPECT_EQ(*frame, numbered(id, id));
      heard += 1;
    }
  }
  EXPECT_EQ(heard, 6);
  EXPECT_FALSE(rig.model.arrive({.id = 0x123, .extended = true}));
  EXPECT_FALSE(rig.model.arrive({.id = 0x123U << 18U, .extended = true}));
  EXPECT_FALSE(rig.model.arrive({.id = 0x123, .remote = true}));
  EXPECT_EQ(rig.bus.counters().received, 6U);
}

TEST(CanBus, WithoutIdentifiersItHearsNothingAndWithTooManyItDoesNotStart) {
  CanBusRig rig;
  ASSERT_FALSE(rig.bus.start(apb1_hz, {}));
  EXPECT_FALSE(rig.model.arrive({.id = 0}));
  const std::array<std::uint16_t, CanBus::most_identifiers + 1> too_many{};
  EXPECT_EQ(rig.bus.start(apb1_hz, too_many), BoardFault::can_failed);
}

TEST(CanBus, EveryNumberOfIdentifiersIsHeardWhole) {
  for (std::size_t count = 1; count <= CanBus::most_identifiers; ++count) {
    CanBusRig rig;
    std::array<std::uint16_t, CanBus::most_identifiers> identifiers{};
    for (std::size_t i = 0; i < count; ++i) {
      identifiers[i] = static_cast<std::uint16_t>(0x100 + 3 * i);
    }
    ASSERT_FALSE(rig.bus.start(apb1_hz, std::span{identifiers}.first(count)));
    std::size_t heard = 0;
    for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
      heard += rig.model.arrive(numbered(id, id)) ? 1U : 0U;
      (void)rig.bus.receive();
    }
    EXPECT_EQ(heard, count);
  }
}

TEST(CanBus, ReceivesInOrderWithLengthAndDataAndZeroBeyond) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  for (std::uint8_t length = 0; length <= 8; ++length) {
    CanFrame frame{.id = 0x020, .length = length};
    for (std::size_t i = 0; i < length; ++i) {
      frame.data[i] = static_cast<std::uint8_t>(0xF0U + i);
    }
    ASSERT_TRUE(rig.model.arrive(frame));
    EXPECT_EQ(rig.bus.receive(), frame);
  }
  EXPECT_FALSE(rig.bus.receive());
}

TEST(CanBus, ALengthCodeAboveEightMeansEight) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  CanFrame frame = numbered(5);
  frame.length = 15;
  ASSERT_TRUE(rig.model.arrive(frame));
  EXPECT_EQ(rig.bus.receive(), numbered(5));
}

TEST(CanBus, KeepsTheFramesOfMoreThanATickAndCountsWhatFindsNoRoom) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  for (std::uint32_t i = 0; i < CanBus::receive_queue + 5; ++i) {
    ASSERT_TRUE(rig.model.arrive(numbered(i)));
  }
  for (std::uint32_t i = 0; i < CanBus::receive_queue; ++i) {
    ASSERT_EQ(rig.bus.receive(), numbered(i));
  }
  EXPECT_FALSE(rig.bus.receive());
  EXPECT_EQ(rig.bus.counters().overrun, 5U);
  EXPECT_EQ(rig.bus.counters().received, CanBus::receive_queue);
}

TEST(CanBus, AHandlerThatIsHeldUpLosesTheNewestFramesAndSaysSo) {
  CanBusRig rig;
  ASSERT_FALSE(rig.start());
  rig.model.masked = true;
  for (std::uint32_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(rig.model.arrive(numbered(i)));
  }
  rig.model.masked = false;
  rig.model.serve();
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(rig.bus.receive(), numbered(i));
  }
  EXPECT_FALSE(rig.bus.receive());
  EXPECT_EQ(rig.bus.counters().overrun, 1U) << "one flag for all that were lost";
}

TEST(CanBitTiming, At42MHzABitIs21QuantaOfTwoPeriodsSampledAfter17) {
  const auto timing = can_bit_timing(42'000'000);
  ASSERT_TRUE(timing);
  // RM0090 section 32.9.2: BRP = 2 - 1, TS1 = 16 - 1, TS2 = 4 - 1, SJW = 4 - 1.
  EXPECT_EQ(timing->bits(), 0x033F'0001U);
}

TEST(CanBitTiming, OfTheProcessorsOwnOscillatorABitIsMadeToo) {
  const auto timing = can_bit_timing(16'000'000);
  ASSERT_TRUE(timing);
  EXPECT_EQ(timing->prescaler * (1 + timing->before_sample + timing->after_sample), 16U);
}

TEST(CanBitTiming, EveryClockGivesAFullMegabitAndASamplePointWithinItsLimitsOrNothing) {
  int made = 0;
  for (std::uint32_t clock_hz = 100'000; clock_hz <= 90'000'000; clock_hz += 1'000) {
    const auto timing = can_bit_timing(clock_hz);
    if (!timing) {
      continue;
    }
    made += 1;
    const std::uint32_t quanta = 1 + timing->before_sample + timing->after_sample;
    const double rate = clock_hz / static_cast<double>(timing->prescaler * quanta);
    const double sample = (1.0 + timing->before_sample) / quanta;
    ASSERT_NEAR(rate, 1e6, 1001.0) << clock_hz;
    ASSERT_GE(sample, 0.75) << clock_hz;
    ASSERT_LE(sample, 0.875) << clock_hz;
    // What the fields of BTR hold, and ISO 11898's fewest quanta.
    ASSERT_TRUE(timing->prescaler >= 1 && timing->prescaler <= 1024) << clock_hz;
    ASSERT_TRUE(timing->before_sample >= 1 && timing->before_sample <= 16) << clock_hz;
    ASSERT_TRUE(timing->after_sample >= 1 && timing->after_sample <= 8) << clock_hz;
    ASSERT_TRUE(timing->resynchronises >= 1 && timing->resynchronises <= 4) << clock_hz;
    ASSERT_LE(timing->resynchronises, timing->after_sample) << clock_hz;
    ASSERT_GE(quanta, 8U) << clock_hz;
  }
  EXPECT_GT(made, 0);
}

TEST(CanBitTiming, EveryWholeNumberOfMegahertzFrom8To45ThatHasAFittingDivisorIsUsed) {
  for (std::uint32_t mhz = 8; mhz <= 45; ++mhz) {
    bool possible = false;
    for (std::uint32_t quanta = 8; quanta <= 22; ++quanta) {
      possible = possible || mhz % quanta == 0;
    }
    EXPECT_EQ(can_bit_timing(mhz * 1'000'000).has_value(), possible) << mhz;
  }
}

TEST(CanBitTiming, AClockThatIsTooSlowOrOffIsRefused) {
  EXPECT_FALSE(can_bit_timing(0));
  EXPECT_FALSE(can_bit_timing(4'000'000));
  EXPECT_FALSE(can_bit_timing(16'500'000));
  EXPECT_TRUE(can_bit_timing(42'042'000));   // 0.1 %
  EXPECT_FALSE(can_bit_timing(42'085'000));  // 0.2 %
}

}  // namespace

}  // namespace fantail::hal::stm32f4
