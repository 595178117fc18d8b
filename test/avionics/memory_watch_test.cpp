// SPDX-License-Identifier: MIT

#include "avionics/memory_sum.hpp"
#include "control_memory.hpp"
#include "flying_rig.hpp"
#include "properties.hpp"

namespace fantail::avionics {
namespace {

// Memory that is no longer what was left there. The campaign of random flips is memory_campaign_test.cpp.

using core::Phase;

bool is_damaged(BoardRig& rig) { return rig.console.text.find("memory_damaged") != std::string::npos; }

void flip(std::span<std::byte> memory, std::size_t bit) { memory[bit / 8] ^= std::byte{1} << (bit % 8); }

TEST(MemoryWatch, EveryBitOfThePlanIsMissedWithinFortyMilliseconds) {
  BoardRig rig;
  rig.run(second);
  core::FlightPlan plan = core::default_plan();
  const core::Autopilot law{plan};
  MemoryWatch watch;
  watch.begin(plan);
  for (std::size_t bit = 0; bit < 8 * sizeof plan; ++bit) {
    flip(memory_of(plan), bit);
    int ticks = 0;
    for (; ticks <= 40 && watch.intact(law); ++ticks) {
      watch.look(plan, law);
    }
    EXPECT_LE(ticks, 40) << "bit " << bit;
    flip(memory_of(plan), bit);
    watch.begin(plan);
  }
  for (int i = 0; i < 100; ++i) {
    watch.look(plan, law);
    ASSERT_TRUE(watch.intact(law)) << i;
  }
}

TEST(MemoryWatch, OnThePadADamagedPlanIsReplacedAndTheRocketIsNotArmed) {
  BoardRig rig;
  rig.run(2 * second);
  plan_in(rig.avionics()).canards.each[1].trim = core::Angle::from_degrees(7.0F);
  rig.run(second);
  EXPECT_EQ(plan_in(rig.avionics()).canards.each[1].trim, core::Angle{});
  EXPECT_NE(rig.console.text.find("board: memory_damaged; it will not be armed\n"), std::string::npos)
      << rig.console.text;
  EXPECT_NE(rig.arm().phase, Phase::armed);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(MemoryWatch, InFlightDamageOfTheLawEndsControlAtTrimAndIsNamed) {
  FlyingRig rig;
  rig.disturbance_rad = 0.05;
  rig.launch_to_control();
  rig.fly_for(second);
  ASSERT_FALSE(rig.all_pulses_are(0.0));
  const auto memory = law_in(rig.avionics()).flight_memory();
  flip({const_cast<std::byte*>(memory.data()), memory.size()}, 8 * memory.size() / 2);
  const core::TickRecord& record = rig.fly();
  EXPECT_EQ(record.phase, Phase::finished);
  EXPECT_EQ(record.reason, core::PhaseReason::memory_fault);
  EXPECT_TRUE(rig.all_pulses_are(0.0)) << "at once";
  rig.fly_for(second);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_NE(rig.console.text.find("board: memory_damaged; operation continues\n"), std::string::npos)
      << rig.console.text;
  EXPECT_NE(rig.console.text.find("phase: finished, memory_fault\n"), std::string::npos);
}

TEST(MemoryWatch, InFlightADamagedPlanDoesTheSame) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(second);
  plan_in(rig.avionics()).canards.each[2].pulse_centre_us = 1600.0F;
  rig.fly_for(41 * millisecond);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_TRUE(is_damaged(rig));
}

// Until it is found, ticks come with a second gyro for which the recorder has no room.
TEST(MemoryWatch, APlanThatSuddenlyAsksForTwoGyrosMakesNoTickLargerThanItsPlace) {
  for (int places = 0; places < 15; ++places) {
    FlyingRig rig;
    rig.launch_to_control();
    rig.fly_for(second + places * 40 * millisecond);
    plan_in(rig.avionics()).sensors.gyros = core::GyroRule::two_agree;
    rig.fly_for(second);
    EXPECT_TRUE(rig.all_pulses_are(0.0));
    EXPECT_TRUE(is_damaged(rig));
  }
}

TEST(MemoryWatch, WithNoPlanLeftNobodyKnowsATrimAndTheServosGetNoPulses) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.fly_for(second);
  flip(plan_block_in(rig.avionics()), 300);
  plan_in(rig.avionics()).canards.each[2].trim = core::Angle::from_degrees(1.0F);
  rig.fly_for(41 * millisecond);
  for (int i = 0; i < 100; ++i) {
    for (const auto& pulse : rig.servo.written) {
      EXPECT_FALSE(pulse.has_value());
    }
    rig.fly();
  }
  EXPECT_FALSE(rig.avionics().pulses_at_trim()[0].has_value()) << "nor does a crash";
  EXPECT_TRUE(is_damaged(rig));
}

TEST(MemoryWatch, AFlightWithoutDamageHasNoFault) {
  FlyingRig rig;
  rig.launch_to_control();
  ASSERT_NE(rig.fly_to(Phase::finished, 60 * second)->phase, Phase::controlling);
  EXPECT_FALSE(is_damaged(rig));
}

std::uint32_t word_by_word(const std::vector<std::byte>& memory) {
  std::uint32_t sum = 0;
  for (std::size_t at = 0; at + 4 <= memory.size(); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, &memory[at], 4);
    sum = (sum << 1U | sum >> 31U) ^ word;
  }
  return sum;
}

RC_GTEST_PROP(MemorySum, IsThatOfTheWordsOneByOne, ()) {
  const auto length = *rc::gen::inRange<std::size_t>(0, 1500);
  const auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(length, rc::gen::arbitrary<std::uint8_t>());
  std::vector<std::byte> memory(bytes.size());
  std::memcpy(memory.data(), bytes.data(), bytes.size());
  RC_ASSERT(memory_sum(memory) == word_by_word(memory));
}

TEST(MemorySum, ChangesWithEverySingleBit) {
  std::vector<std::byte> memory(1100, std::byte{0x5A});
  const std::uint32_t before = memory_sum(memory);
  for (std::size_t bit = 0; bit < 8 * memory.size(); ++bit) {
    const std::byte whole = memory[bit / 8];
    memory[bit / 8] ^= std::byte{1} << (bit % 8);
    ASSERT_NE(memory_sum(memory), before) << bit;
    memory[bit / 8] = whole;
  }
}

}  // namespace

}  // namespace fantail::avionics
