// SPDX-License-Identifier: MIT
#include <bit>

#include "avionics/board_rig.hpp"
#include "avionics/plan_on_bus.hpp"
#include "core/flight_plan_fields.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/plan_block.hpp"
#include "test.hpp"
#include "transfer_rig.hpp"

namespace fantail::avionics {
namespace {

using namespace core::literals;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::PlanReply;
using protocol::SelfTestState;
using protocol::TransferFault;
using protocol::TransferState;

core::FlightPlan plan_with_trim() {
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[1].trim = 4_deg;
  return plan;
}

TransferFault answer_to_begin(BoardRig& rig) {
  rig.pc.say(protocol::PlanBegin{.size = 500, .block_crc = 1});
  rig.tick();
  return rig.pc.heard<PlanReply>()->fault;
}

TEST(NewPlan, IsRefusedWhileANonceWaitsForItsConfirmation) {
  BoardRig rig;
  rig.make_ready();
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(answer_to_begin(rig), TransferFault::not_safe);
}

TEST(NewPlan, IsTheOneThatTheBenchReadsBack) {
  BoardRig rig;
  rig.run(3 * second);
  const auto checksum_read_back = [&rig] {
    rig.pc.say(protocol::LogRequest{
        .action = protocol::LogAction::plan, .tag = 5, .offset = protocol::plan_block_size - 4, .size = 4});
    rig.run(core::Microseconds{30'000});
    const auto& part = rig.pc.heard<protocol::LogData>();
    return part ? static_cast<std::uint32_t>(protocol::get<4>(part->bytes, 0)) : 0U;
  };
  EXPECT_EQ(checksum_read_back(), protocol::plan_crc(core::default_plan()));
  send_plan(rig, plan_with_trim());
  rig.run(second);
  EXPECT_EQ(checksum_read_back(), protocol::plan_crc(plan_with_trim()));
}

TEST(NewPlan, IsRefusedWhileTheSelfTestRuns) {
  BoardRig rig;
  rig.run(3 * second);  // at rest, so it is the self-test that is in the way
  rig.pc.say(ArmAction::self_test);
  rig.run(second);
  EXPECT_EQ(answer_to_begin(rig), TransferFault::not_safe);
}

TEST(NewPlan, ARocketIsNotArmedWhileOneIsBeingWritten) {
  BoardRig rig;
  rig.make_ready();
  rig.flash.set_stays_busy(true);
  send_plan(rig, plan_with_trim());
  ASSERT_EQ(rig.pc.heard<PlanReply>()->state, TransferState::writing);
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_FALSE(rig.pc.heard<ArmReply>()->nonce);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
}

TEST(NewPlan, WantsASelfTestOfItsOwnWithItsOwnTrims) {
  BoardRig rig;
  rig.make_ready();
  send_plan(rig, plan_with_trim());
  rig.run(second);
  ASSERT_EQ(rig.pc.heard<PlanReply>()->state, TransferState::stored);
  rig.run(3 * second);
  rig.pc.say(ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::not_run);
  rig.make_ready();
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::passed);
}

TEST(NewPlan, TheHeartbeatNamesItFromThenOn) {
  BoardRig rig;
  rig.run(3 * second);
  send_plan(rig, plan_with_trim());
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<protocol::HeartbeatReport>()->plan_crc, protocol::plan_crc(plan_with_trim()));
}

// When a plan that came by the bus comes into force.

using namespace core::literals;
using protocol::PlanReply;
using protocol::TransferFault;
using protocol::TransferState;

std::uint32_t in_force(BoardRig& rig) {
  rig.run(200 * millisecond);  // the heartbeat comes ten times a second
  return rig.pc.heard<protocol::HeartbeatReport>()->plan_crc;
}

TEST(NewPlan, IsRefusedToAnArmedRocketAndChangesNothing) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, core::Phase::armed);
  send_plan(rig, plan_with_trim());
  EXPECT_EQ(rig.pc.heard<PlanReply>()->fault, TransferFault::not_safe);
  EXPECT_EQ(in_force(rig), protocol::plan_crc(core::default_plan()));
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  rig.power_cycle();
  EXPECT_EQ(in_force(rig), protocol::plan_crc(core::default_plan()));
}

// What is past its point of no return is written to its end; it waits until it may move the canards.
TEST(NewPlan, OneThatIsWrittenWhileTheRocketIsCarriedIsNotInForceBeforeItRestsAgain) {
  int waited = 0;
  for (const int ticks : {0, 1, 2, 4, 8}) {
    BoardRig rig;
    rig.run(3 * second);
    send_plan(rig, plan_with_trim());
    rig.run(ticks * millisecond);
    const bool begun_before = rig.pc.heard<PlanReply>()->state == TransferState::stored;
    rig.hardware.imu.rate = {500, 0, 0};
    rig.run(300 * millisecond);
    const bool stored_meanwhile = rig.pc.heard<PlanReply>()->state == TransferState::writing;
    if (!begun_before) {
      EXPECT_EQ(in_force(rig), protocol::plan_crc(core::default_plan())) << ticks;
      EXPECT_TRUE(rig.all_pulses_are(0.0)) << ticks;
    }
    rig.hardware.imu.rate = {};
    rig.run(4 * second);
    if (stored_meanwhile) {
      EXPECT_EQ(in_force(rig), protocol::plan_crc(plan_with_trim())) << ticks;
      EXPECT_NEAR(rig.commanded_deg(1), 4.0, 0.01);
      waited += 1;
    }
  }
  EXPECT_GT(waited, 0);
}

// Whole blocks with the right checksum, of a plan that may fly but for one word.

using core::Kept;
using core::PlanField;
using protocol::PlanBlockFault;
using protocol::TransferFault;

constexpr std::size_t words_begin = protocol::plan_block_size - 4 - 4 * core::flight_plan_words;

Bytes with_word(const Bytes& block, std::size_t word, std::uint32_t bits) {
  Bytes changed = block;
  protocol::put<4>(changed, words_begin + 4 * word, bits);
  protocol::put<4>(changed, changed.size() - 4, protocol::plan_block_crc(changed));
  return changed;
}

std::vector<std::uint32_t> bits_of(std::initializer_list<float> numbers) {
  std::vector<std::uint32_t> bits;
  std::ranges::transform(numbers, std::back_inserter(bits), [](float n) { return std::bit_cast<std::uint32_t>(n); });
  return bits;
}

/// A little below the range and a little above it, and what is no number; of whole numbers those that exist.
std::vector<std::uint32_t> forbidden(const PlanField& field) {
  const float least = field.minimum * field.scale;
  const float most = field.maximum * field.scale;
  if (field.kept == Kept::number) {
    const float little = 1e-5F * std::max(std::abs(least), std::abs(most));
    const float infinity = std::numeric_limits<float>::infinity();
    return bits_of({least - little, most + little, -std::numeric_limits<float>::max(),
                    std::numeric_limits<float>::max(), -infinity, infinity, std::numeric_limits<float>::quiet_NaN()});
  }
  // Of a time a microsecond in ten thousand, because floats compare them.
  const float unit = field.is_time() ? 1e6F : 1.0F;
  const auto first = static_cast<std::uint64_t>(std::lround(least * unit));
  const auto last = static_cast<std::uint64_t>(std::lround(most * unit));
  std::vector<std::uint32_t> bits;
  for (const std::uint64_t above : {last + 1 + (field.is_time() ? last / 10'000 : 0), std::uint64_t{0xFFFFFFFF}}) {
    if (above > last && above <= 0xFFFFFFFF) {
      bits.push_back(static_cast<std::uint32_t>(above));
    }
  }
  if (const std::uint64_t step = 1 + (field.is_time() ? first / 10'000 : 0); first >= step) {
    bits.push_back(static_cast<std::uint32_t>(first - step));
  }
  // What would be allowed if the upper bytes of the word were cut off.
  if (field.kept != Kept::number && field.kept != Kept::time && field.kept != Kept::word) {
    bits.push_back(0x10000U + static_cast<std::uint32_t>(first));
  }
  return bits;
}

TEST_F(PlanTransferTest, ABlockWithOneValueOutOfItsRangeIsRefusedByNameAndChangesNothing) {
  const auto fields = core::flight_plan_fields();
  std::size_t word = 0;
  int sent = 0;
  const auto refuse = [&](const Bytes& block, std::size_t field) {
    rig.send(block);
    ASSERT_EQ(rig.fault(), TransferFault::bad_block) << fields[field].key;
    ASSERT_FALSE(rig.taken.has_value()) << fields[field].key;
    ASSERT_EQ(rig.reply->block_fault, PlanBlockFault::refused) << fields[field].key;
    ASSERT_EQ(rig.reply->field, field) << fields[field].key;
    sent += 1;
  };
  for (std::size_t i = 0; i < fields.size(); ++i) {
    core::FlightPlan plan = numbered_plan(8);
    if (fields[i].is_list()) {
      fields[i].set_length(plan, fields[i].slots);  // so that each of them counts
      refuse(with_word(eight, word, static_cast<std::uint32_t>(fields[i].slots) + 1U), i);
      word += 1;
    }
    const Bytes block = block_of(plan);
    for (std::size_t slot = 0; slot < fields[i].slots; ++slot, ++word) {
      const std::vector<std::uint32_t> all = forbidden(fields[i]);
      EXPECT_GE(all.size(), fields[i].kept == Kept::word ? 0U : 1U) << fields[i].key;
      for (const std::uint32_t bits : all) {
        refuse(with_word(block, word, bits), i);
      }
    }
    expect_refused(TransferFault::bad_block);  // and the old one is what the next power-up finds
  }
  EXPECT_EQ(word, core::flight_plan_words);
  EXPECT_GT(sent, 500);
  rig.reply.reset();
  expect_next_one_is_stored();
}

// The other side of it: at either end of its range a value is no fault of its own.
TEST_F(PlanTransferTest, NoFieldIsOutOfRangeAtTheEndsOfItsRange) {
  const auto fields = core::flight_plan_fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    for (const float end : {fields[i].minimum, fields[i].maximum}) {
      core::FlightPlan plan = numbered_plan(8);
      fields[i].set(plan, 0, end);
      const auto reading = protocol::read_plan_block(block_of(plan));
      const bool out_of_range = reading.plan_fault && reading.plan_fault->rule == core::PlanRule::in_range;
      EXPECT_FALSE(out_of_range) << fields[i].key << " " << end;
    }
  }
}

}  // namespace

}  // namespace fantail::avionics
