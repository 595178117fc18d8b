// SPDX-License-Identifier: MIT
#include "protocol/state_block.hpp"

#include "chaos.hpp"
#include "core/autopilot.hpp"
#include "core/canard_sharing.hpp"
#include "properties.hpp"
#include "protocol/tick_digest.hpp"
#include "seed.hpp"

namespace fantail::protocol {
namespace {

using core::Autopilot;

std::vector<std::byte> state_of(Autopilot& autopilot) {
  StateWriter measure{{}};
  autopilot.visit_state(measure);
  std::vector<std::byte> bytes(measure.size());
  StateWriter writer{bytes};
  autopilot.visit_state(writer);
  return bytes;
}

bool restore(Autopilot& autopilot, std::span<const std::byte> state) {
  StateReader reader{state};
  autopilot.visit_state(reader);
  return reader.ok();
}

// Whatever has come before, whichever plan: what goes on from a state is what would have gone on without it.
RC_GTEST_PROP(StateBlock, ALawThatIsGivenTheStateOfAnotherGoesOnAsTheOtherDoes, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  const core::FlightPlan plan = core::random_plan(random);
  Autopilot flown{plan};
  core::Chaos chaos{random};
  for (int ticks = random.whole(0, 12'000); ticks > 0; --ticks) {
    flown.step(chaos.next());
  }
  Autopilot replayed{plan};
  RC_ASSERT(restore(replayed, state_of(flown)));
  RC_ASSERT(state_of(replayed) == state_of(flown));
  for (int ticks = 0; ticks < 1'000; ++ticks) {
    const core::Inputs inputs = chaos.next();
    RC_ASSERT(tick_digest(flown.step(inputs)) == tick_digest(replayed.step(inputs)));
  }
  RC_ASSERT(state_of(replayed) == state_of(flown));
}

// In a long flight with a broken canard the others have taken over for good: that state must come back after a reset.
TEST(StateBlock, AShareThatIsTakenOverWholeComesBackAndNothingBeyondItDoes) {
  core::CanardVerdicts verdicts{};
  core::CanardContributions contributions{};
  contributions.fill(core::Angle{});
  verdicts[0] = core::CanardVerdict::stalled;
  contributions[0] = core::Angle::from_degrees(-6.0F);
  const auto limit = core::Angle::from_degrees(9.0F);
  core::CanardSharing sharing{limit};
  for (int ticks = 0; ticks < 1'000; ++ticks) {
    sharing.update(verdicts, contributions);
  }
  std::array<std::byte, 64> room{};
  StateWriter writer{room};
  sharing.visit_state(writer);
  const std::span<std::byte> state{room.data(), writer.size()};
  core::CanardSharing taken_back{limit};
  StateReader reader{state};
  taken_back.visit_state(reader);
  ASSERT_TRUE(reader.ok());
  taken_back.update(verdicts, contributions);
  EXPECT_EQ(taken_back.asked_of_each(core::Angle{}), sharing.asked_of_each(core::Angle{}));
  state[0] = static_cast<std::byte>(std::to_integer<int>(state[0]) + 1);
  StateReader beyond{state};
  taken_back.visit_state(beyond);
  EXPECT_FALSE(beyond.ok());
}

TEST(StateBlock, WrittenInPartsOfAnySizeItIsTheWholeAndNothingBeside) {
  core::RandomStream random{test::seed(4)};
  Autopilot flown{core::random_plan(random)};
  core::Chaos chaos{random};
  for (int ticks = 0; ticks < 3'000; ++ticks) {
    flown.step(chaos.next());
  }
  const std::vector<std::byte> whole = state_of(flown);
  for (std::size_t part = 1; part < whole.size() + 2; part += 1 + part / 8) {
    std::vector<std::byte> bytes(whole.size());
    for (std::size_t begin = 0; begin < whole.size(); begin += part) {
      std::vector<std::byte> piece(whole.size(), std::byte{0x5A});
      StateWriter writer{piece, StateExtent::whole, {.begin = begin, .size = part}};
      flown.visit_state(writer);
      EXPECT_EQ(writer.size(), whole.size());
      // A value belongs to the part in which it begins.
      const auto untouched = [](std::byte byte) { return byte == std::byte{0x5A}; };
      EXPECT_TRUE(std::all_of(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(begin), untouched));
      StateWriter again{bytes, StateExtent::whole, {.begin = begin, .size = part}};
      flown.visit_state(again);
    }
    ASSERT_EQ(bytes, whole) << part;
  }
}

// What the pad window had gathered is not in it: a law that lands on the pad again has to see rest anew.
TEST(StateBlock, InFlightTwoFifthsOfTheStateAreEnough) {
  core::RandomStream random{test::seed(3)};
  core::FlightPlan plan = core::random_plan(random);
  plan.run.start = core::Start::tunnel;
  Autopilot flown{plan};
  core::Inputs inputs{};
  inputs.arm_switch_closed = true;
  inputs.gyro.quality = core::SampleQuality::valid;
  inputs.accelerometers.fill(
      {.specific_force_m_s2 = {.x = core::standard_gravity_m_s2}, .quality = core::SampleQuality::valid});
  const auto tick = [&inputs](Autopilot& law) { return tick_digest(law.step(inputs)); };
  for (int i = 0; i < 60'000 && flown.phase() != core::Phase::controlling; ++i) {
    inputs.time += core::Microseconds{1'000};
    inputs.gyro.time = inputs.accelerometers[0].time = inputs.accelerometers[1].time = inputs.time;
    inputs.arm_command = inputs.start_command = i > 5'000;
    (void)tick(flown);
  }
  ASSERT_EQ(flown.phase(), core::Phase::controlling);
  std::vector<std::byte> bytes(2000);
  StateWriter writer{bytes, StateExtent::in_flight};
  flown.visit_state(writer);
  EXPECT_LT(writer.size(), state_of(flown).size() / 2);
  bytes.resize(writer.size());
  Autopilot resumed{plan};
  StateReader reader{bytes, StateExtent::in_flight};
  resumed.visit_state(reader);
  ASSERT_TRUE(reader.ok());
  inputs.arm_command = inputs.start_command = false;
  for (int i = 0; i < 2'000; ++i) {
    inputs.time += core::Microseconds{1'000};
    inputs.gyro.time = inputs.accelerometers[0].time = inputs.accelerometers[1].time = inputs.time;
    inputs.gyro.rate_rad_s.x = 0.01F * static_cast<float>(i % 100);
    ASSERT_EQ(tick(resumed), tick(flown)) << i;
  }
}

// Whatever else the plan says. A gate, capture and a barometer have memories of their own, which a plan without them
// does not keep.
TEST(StateBlock, EveryStateOfAsManyGyrosWithoutGateCaptureAndBarometerHasOneSizeAndOneLayout) {
  core::RandomStream random{test::seed(1)};
  std::array<std::uint32_t, 2> hashes{};
  for (const core::GyroRule rule : {core::GyroRule::one, core::GyroRule::two_agree}) {
    core::FlightPlan plan = core::default_plan();
    plan.sensors.gyros = rule;
    Autopilot fresh{plan};
    plan = core::random_plan(random);
    plan.sensors.gyros = rule;
    plan.sensors.barometer = core::BarometerUse::none;
    plan.dormancy = core::default_plan().dormancy;
    plan.controller.entry = core::ControlEntry::as_published;
    Autopilot other{plan};
    core::Chaos chaos{random};
    for (int tick = 0; tick < 5'000; ++tick) {
      other.step(chaos.next());
    }
    EXPECT_EQ(state_of(fresh).size(), state_of(other).size());
    StateLayout of_fresh;
    StateLayout of_other;
    fresh.visit_state(of_fresh);
    other.visit_state(of_other);
    EXPECT_EQ(of_fresh.hash(), of_other.hash());
    hashes[static_cast<std::size_t>(rule)] = of_fresh.hash();
  }
  EXPECT_NE(hashes[0], hashes[1]);
}

/// Stands for a law that has one value of each kind.
struct Part {
  float number = 0.0F;
  std::optional<core::Microseconds> time;
  std::array<bool, 2> flags{};
  core::Phase phase = core::Phase::safe;

  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(number, time, flags);
    visit.below(core::phases, phase);
  }
};

TEST(StateBlock, LiesThereAsItsDocumentationSays) {
  Part part{.number = 1.0F, .time = core::Microseconds{0x0102}, .flags = {true, false}, .phase = core::Phase::armed};
  std::array<std::byte, 16> bytes{};
  StateWriter writer{bytes};
  part.visit_state(writer);
  constexpr std::array<std::uint8_t, 16> expected{0, 0, 0x80, 0x3F, 1, 2, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1};
  EXPECT_EQ(writer.size(), expected.size());
  EXPECT_TRUE(std::ranges::equal(bytes, expected, {}, [](std::byte b) { return std::to_integer<std::uint8_t>(b); }));
}

TEST(StateBlock, ALayoutChangesWithEveryValue) {
  StateLayout two_flags;
  bool flag = false;
  two_flags(flag, flag);
  StateLayout one_flag;
  one_flag(flag);
  StateLayout number;
  float value = 0.0F;
  number(value);
  StateLayout below_three;
  StateLayout below_four;
  std::uint8_t choice = 0;
  below_three.below(3, choice);
  below_four.below(4, choice);
  std::vector<std::uint32_t> hashes{StateLayout{}.hash(), one_flag.hash(),    two_flags.hash(),
                                    number.hash(),        below_three.hash(), below_four.hash()};
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

// A log may say anything. One byte at a time is put to every value: whatever is accepted can be flown with.
TEST(StateBlock, NoStateThatIsAcceptedLeadsBeyondAnArray) {
  core::RandomStream random{test::seed(2)};
  const core::FlightPlan plan = core::default_plan();
  Autopilot flown{plan};
  core::Chaos chaos{random};
  for (int tick = 0; tick < 3'000; ++tick) {
    flown.step(chaos.next());
  }
  const std::vector<std::byte> sound = state_of(flown);
  std::size_t refused = 0;
  for (std::size_t at = 0; at < sound.size(); ++at) {
    for (const unsigned value : {0x00U, 0x01U, 0x02U, 0x24U, 0x7FU, 0x80U, 0xC0U, 0xFFU}) {
      std::vector<std::byte> spoilt = sound;
      spoilt[at] = static_cast<std::byte>(value);
      Autopilot autopilot{plan};
      if (!restore(autopilot, spoilt)) {
        refused += 1;
        continue;
      }
      for (int tick = 0; tick < 3; ++tick) {
        autopilot.step(chaos.next());
      }
    }
  }
  EXPECT_GT(refused, 0U);
}

TEST(StateBlock, AStateInFlightIsRestoredByItsSize) {
  core::Autopilot law{core::default_plan()};
  for (const StateExtent extent : {StateExtent::whole, StateExtent::in_flight}) {
    StateWriter measure{{}, extent};
    law.visit_state(measure);
    std::vector<std::byte> state(measure.size());
    StateWriter writer{state, extent};
    law.visit_state(writer);
    core::Autopilot other{core::default_plan()};
    EXPECT_TRUE(restore_state(other, state));
    state.pop_back();
    EXPECT_FALSE(restore_state(other, state));
  }
}

TEST(StateBlock, AStateOfAnotherSizeIsRefused) {
  Autopilot autopilot{core::default_plan()};
  std::vector<std::byte> state = state_of(autopilot);
  EXPECT_TRUE(restore(autopilot, state));
  EXPECT_FALSE(restore(autopilot, std::span{state}.first(state.size() - 1)));
  state.push_back(std::byte{0});
  EXPECT_FALSE(restore(autopilot, state));
}

TEST(StateBlock, ANumberThatIsNoneAFlagThatIsNeitherAndAnEnumerationBeyondItsEndAreRefused) {
  const auto accepts = [](std::size_t at, std::uint8_t value) {
    Part part;
    std::array<std::byte, 16> bytes{};
    StateWriter writer{bytes};
    part.visit_state(writer);
    bytes[at] = std::byte{value};
    StateReader reader{bytes};
    part.visit_state(reader);
    return reader.ok();
  };
  EXPECT_TRUE(accepts(3, 0x3F));
  EXPECT_FALSE(accepts(3, 0x7F));   // 1.7e38
  EXPECT_TRUE(accepts(4, 1));       // the time is there
  EXPECT_FALSE(accepts(4, 2));      // neither there nor not there
  EXPECT_FALSE(accepts(12, 0x7F));  // 290 000 years
  EXPECT_TRUE(accepts(15, 5));
  EXPECT_FALSE(accepts(15, 6));  // there are six phases
}

TEST(StateBlock, WhatFindsNoRoomIsCountedAndNotWritten) {
  Part part{.number = 1.0F, .time = {}, .flags = {}, .phase = {}};
  std::array<std::byte, 8> room{};
  StateWriter writer{std::span{room}.first(6)};
  part.visit_state(writer);
  EXPECT_EQ(writer.size(), 16U);
  EXPECT_EQ(room[6], std::byte{0});
}

}  // namespace
}  // namespace fantail::protocol
