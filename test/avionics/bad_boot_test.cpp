// SPDX-License-Identifier: MIT
// What the avionics finds at power-up and must not fly with: each has a name on the bus and at the console, the canards
// go to trim and stay there, and nobody arms.

#include "avionics/board_rig.hpp"
#include "plan_store_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::BoardReport;
using protocol::HeartbeatReport;
using protocol::PlanSource;
using protocol::SelfTestFailure;

bool says(const BoardRig& rig, std::string_view words) { return rig.console.text.find(words) != std::string::npos; }

void boot(BoardRig& rig) {
  rig.console.text.clear();
  rig.power_cycle();
}

// The plan slots are the first two sectors of a flash of any size.
void boot_with(BoardRig& rig, const Bytes& cells) {
  std::ranges::copy(std::span{cells}.first(8192), rig.flash.cells().begin());
  boot(rig);
}

// All that a pad crew would try. Every tick is looked at.
void expect_no_arming(BoardRig& rig, SelfTestFailure failure) {
  const auto watch = [&rig](Microseconds duration) {
    for (Microseconds t{}; t < duration; t += millisecond) {
      ASSERT_EQ(rig.tick().phase, Phase::safe);
      for (std::size_t i = 0; i < hal::canards; ++i) {
        ASSERT_TRUE(!rig.servo.written[i] || std::abs(rig.commanded_deg(i)) < 0.01)
            << "at " << rig.hardware.time.count();
      }
    }
  };
  rig.pc.say(ArmAction::self_test);
  watch(13 * second);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, failure);
  rig.hardware.arm_switch_closed = true;
  watch(millisecond);
  rig.pc.say(ArmAction::begin);
  watch(millisecond);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::self_test_not_passed);
  EXPECT_FALSE(rig.pc.heard<ArmReply>()->nonce);
  rig.pc.say(ArmAction::confirm, 0);
  watch(second);
}

TEST(BadBoot, WithoutAnImuTheReportsGoOnTheCanardsStandAtTrimAndNobodyArms) {
  BoardRig rig;
  rig.hardware.imu.status = hal::Status::no_reading;
  boot(rig);
  expect_no_arming(rig, SelfTestFailure::gyro_failed);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  EXPECT_EQ(rig.pc.heard<protocol::HealthReport>()->gyro, core::SensorState::failed);
  const int before = rig.pc.count<protocol::StatusReport>();
  rig.run(second);
  EXPECT_EQ(rig.pc.count<protocol::StatusReport>() - before, 100);
  EXPECT_EQ(rig.watchdog.fed, static_cast<int>(rig.hardware.time / millisecond));
}

TEST(BadBoot, WithoutTheSecondAccelerometerNobodyArms) {
  BoardRig rig;
  rig.hardware.accelerometer.status = hal::Status::no_reading;
  boot(rig);
  expect_no_arming(rig, SelfTestFailure::accelerometer_failed);
}

TEST(BadBoot, WithoutAnyEncoderTheServosAreDrivenToTrimAfterHalfASecondAndNobodyArms) {
  BoardRig rig;
  rig.unplugged = {true, true, true, true};
  boot(rig);
  rig.run(second);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
  expect_no_arming(rig, SelfTestFailure::encoder_silent);
}

TEST(BadBoot, AFlashThatStaysBusyIsNamedAndNobodyArms) {
  BoardRig rig;
  rig.flash.set_stays_busy(true);
  boot(rig);
  rig.run(5 * second);
  EXPECT_TRUE(rig.pc.heard<BoardReport>()->flash_failed);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::flash_unreadable);
  EXPECT_TRUE(says(rig, "plan: the built-in one; the flash cannot be read, and it will not be armed\n"));
  EXPECT_EQ(rig.hardware.shown, hal::Signal::faulty);
  expect_no_arming(rig, SelfTestFailure::flash_failed);
}

TEST(BadBoot, AFlashThatIsBusyForASecondIsWaitedForAndItsPlanIsFlown) {
  BoardRig rig;
  rig.flash.set_stays_busy(true);
  boot_with(rig, flash_with({5}));
  rig.run(second);
  EXPECT_FALSE(says(rig, "plan:"));
  rig.flash.set_stays_busy(false);
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::stored);
  EXPECT_TRUE(says(rig, "plan: the one in the flash\n"));
  EXPECT_FALSE(says(rig, "will not be armed"));
}

// After the plan was read: the boot counter or the flights find out.
TEST(BadBoot, AFlashThatFallsSilentIsNamedAtTheConsoleToo) {
  BoardRig rig;
  boot(rig);
  rig.tick();
  rig.flash.set_answers(false);
  rig.run(5 * second);
  EXPECT_TRUE(rig.pc.heard<BoardReport>()->flash_failed);
  EXPECT_TRUE(says(rig, "flash: does not answer, or does not keep written data; it will not be armed\n"));
  expect_no_arming(rig, SelfTestFailure::flash_failed);
}

TEST(BadBoot, ABrokenPlanInTheFlashIsNamedAndNobodyArms) {
  BoardRig rig;
  Bytes cells = flash_with({5});
  cells[256 + 100] ^= std::byte{0x04};  // one bit of the block
  boot_with(rig, cells);
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::stored_is_broken);
  EXPECT_EQ(rig.pc.heard<HeartbeatReport>()->plan_crc, protocol::plan_crc(core::default_plan()));
  EXPECT_TRUE(says(rig, "the stored one is broken; it will not be armed until a plan is sent\n"));
  EXPECT_EQ(rig.hardware.shown, hal::Signal::faulty);
  expect_no_arming(rig, SelfTestFailure::no_valid_plan);
}

// A block as newer firmware would write it, stored as every plan is.
Bytes flash_with_newer_plan(std::initializer_list<int> before) {
  PlanBoard board{flash_with(before)};
  Bytes block = block_of(numbered_plan(7));
  block[4] = static_cast<std::byte>(protocol::plan_block_version + 1);
  const std::uint32_t crc = protocol::crc32c(std::span{block}.first(block.size() - 4));
  for (std::size_t i = 0; i < 4; ++i) {
    block[block.size() - 4 + i] = static_cast<std::byte>(crc >> (8U * i));
  }
  board.write(block);
  EXPECT_EQ(board.store.write(), PlanWrite::stored);
  return board.cells();
}

TEST(BadBoot, APlanFromANewerVersionHasANameOfItsOwnAndNobodyArms) {
  BoardRig rig;
  boot_with(rig, flash_with_newer_plan({}));
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::stored_is_newer);
  EXPECT_EQ(rig.pc.heard<HeartbeatReport>()->plan_crc, protocol::plan_crc(core::default_plan()));
  EXPECT_TRUE(says(rig, "the stored one is from a newer version of the firmware"));
  EXPECT_EQ(rig.hardware.shown, hal::Signal::faulty);
  expect_no_arming(rig, SelfTestFailure::newer_plan);
}

// The older plan in the other slot is not what the crew loaded last.
TEST(BadBoot, AnOlderPlanIsNotFlownInThePlaceOfOneFromANewerVersion) {
  BoardRig rig;
  boot_with(rig, flash_with_newer_plan({3}));
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::stored_is_newer);
  EXPECT_EQ(rig.pc.heard<HeartbeatReport>()->plan_crc, protocol::plan_crc(core::default_plan()));
  expect_no_arming(rig, SelfTestFailure::newer_plan);
}

TEST(BadBoot, ANewerPlanIsSparedUntilAnotherOneIsWholeInTheFlash) {
  const Bytes block = block_of(numbered_plan(9));
  for (const auto& before : {flash_with_newer_plan({}), flash_with_newer_plan({3}), flash_with_newer_plan({2, 3})}) {
    const int whole = PlanBoard{before}.write(block);
    for (int ticks = 0; ticks < whole - 6; ++ticks) {  // up to the header
      PlanBoard board{before};
      board.write(block, ticks);
      board.flash.cut_power(static_cast<std::uint64_t>(ticks));
      const PlanBoard next{board.cells()};
      ASSERT_TRUE(next.found.newer) << ticks;
      ASSERT_FALSE(next.found.plan.has_value()) << ticks;
    }
    PlanBoard board{before};
    board.write(block);
    EXPECT_EQ((PlanBoard{board.cells()}.number()), 9);
  }
}

TEST(BadBoot, AfterABrownOutInTheMiddleOfAWriteTheOldPlanIsInForceAndTheCauseIsNamed) {
  const Bytes block = block_of(numbered_plan(2));
  const Bytes before = flash_with({1});
  const int whole = PlanBoard{before}.write(block);
  for (int ticks = 1; ticks < whole; ticks += 2) {
    PlanBoard writing{before};
    writing.write(block, ticks);
    writing.flash.cut_power(static_cast<std::uint64_t>(ticks));
    BoardRig rig;
    rig.hardware.board.reset_cause = hal::ResetCause::brown_out;
    boot_with(rig, writing.cells());
    rig.run(second);
    const std::uint32_t crc = rig.pc.heard<HeartbeatReport>()->plan_crc;
    EXPECT_TRUE(crc == protocol::plan_crc(numbered_plan(1)) || crc == protocol::plan_crc(numbered_plan(2))) << ticks;
    EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::stored) << ticks;
    EXPECT_EQ(rig.pc.heard<BoardReport>()->reset_cause, static_cast<int>(hal::ResetCause::brown_out));
    EXPECT_EQ(rig.console.text, "reset by a supply that was too low\nboard: no fault\nplan: the one in the flash\n");
    EXPECT_EQ(rig.run(millisecond)->phase, Phase::safe);
  }
}

TEST(BadBoot, AfterABrownOutInTheMiddleOfTheFirstWriteThereIsNoPlanAndThatHasAName) {
  PlanBoard writing{flash_with({})};
  writing.write(block_of(numbered_plan(2)), 8);
  writing.flash.cut_power(1);
  Bytes cells = writing.cells();
  cells[3] = std::byte{0x5A};  // the header was being written
  BoardRig rig;
  boot_with(rig, cells);
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->plan, PlanSource::stored_is_broken);
  expect_no_arming(rig, SelfTestFailure::no_valid_plan);
}

}  // namespace
}  // namespace fantail::avionics
