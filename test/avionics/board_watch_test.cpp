// SPDX-License-Identifier: MIT
#include "avionics/board_watch.hpp"

#include "avionics/board_rig.hpp"
#include "avionics/flying_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using hal::BoardFault;
using hal::Signal;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::BoardReport;
using protocol::SelfTestFailure;
using protocol::SelfTestState;

bool says(const BoardRig& rig, std::string_view words) { return rig.console.text.find(words) != std::string::npos; }

void boot_with(BoardRig& rig, std::initializer_list<BoardFault> faults) {
  rig.hardware.board.faults = {};
  for (const BoardFault fault : faults) {
    rig.hardware.board.faults.add(fault);
  }
  rig.console.text.clear();
  rig.power_cycle();
}

class EachBoardFault : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] static BoardFault fault() { return static_cast<BoardFault>(GetParam()); }
};

TEST_P(EachBoardFault, KeepsTheRocketFromBeingArmedAndHasItsNameOnBusAndConsole) {
  BoardRig rig;
  boot_with(rig, {fault()});
  rig.pc.say(ArmAction::self_test);
  for (Microseconds t{}; t < 8 * second; t += millisecond) {
    ASSERT_EQ(rig.tick().phase, Phase::safe);
    ASSERT_TRUE(rig.all_pulses_are(0.0));
  }
  EXPECT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::failed);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, SelfTestFailure::board_fault);
  rig.hardware.arm_switch_closed = true;
  rig.tick();
  rig.pc.say(ArmAction::begin);
  EXPECT_EQ(rig.tick().phase, Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::board_fault);
  EXPECT_FALSE(rig.pc.heard<ArmReply>()->nonce);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 1U << GetParam());
  EXPECT_TRUE(says(rig, "board: " + std::string{name(fault())} + "; it will not be armed\n")) << rig.console.text;
  EXPECT_EQ(rig.hardware.shown, Signal::faulty);
}

INSTANTIATE_TEST_SUITE_P(Faults, EachBoardFault, testing::Range(std::size_t{0}, hal::board_faults),
                         [](const auto& test) { return std::string{name(static_cast<BoardFault>(test.param))}; });

TEST(BoardWatch, TheFirstTickTellsWhyTheProcessorBeganEveryFaultAndThePlan) {
  BoardRig rig;
  rig.hardware.board.reset_cause = hal::ResetCause::watchdog;
  boot_with(rig, {BoardFault::flash_silent, BoardFault::imu_silent});
  rig.tick();
  EXPECT_EQ(rig.console.text,
            "reset by the watchdog\n"
            "board: imu_silent, flash_silent; it will not be armed\n"
            "plan: the built-in one; none is stored\n");
  EXPECT_EQ(rig.pc.heard<BoardReport>()->reset_cause, static_cast<int>(hal::ResetCause::watchdog));
}

TEST(BoardWatch, EveryCauseOfAResetHasWordsOfItsOwn) {
  std::set<std::string> words;
  for (std::size_t i = 0; i < hal::reset_causes; ++i) {
    BoardRig rig;
    rig.hardware.board.reset_cause = static_cast<hal::ResetCause>(i);
    boot_with(rig, {});
    rig.tick();
    words.insert(rig.console.text.substr(0, rig.console.text.find('\n')));
    EXPECT_EQ(rig.pc.heard<BoardReport>()->reset_cause, i);
  }
  EXPECT_EQ(words.size(), hal::reset_causes);
}

TEST(BoardWatch, ASoundBoardIsReportedOnceASecondAndNamedOnce) {
  BoardRig rig;
  rig.tick();
  const std::string text = rig.console.text;
  const int before = rig.pc.count<BoardReport>();
  rig.run(10 * second);
  EXPECT_EQ(rig.pc.count<BoardReport>() - before, 10);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 0U);
  EXPECT_EQ(rig.console.text, text);
}

TEST(BoardWatch, AFaultIsReportedInTheTickInWhichItCame) {
  BoardRig rig;
  rig.run(second + 500 * millisecond);
  rig.console.text.clear();
  rig.hardware.board.faults.add(BoardFault::flash_stuck);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 1U << static_cast<unsigned>(BoardFault::flash_stuck));
  EXPECT_EQ(rig.console.text, "board: flash_stuck; it will not be armed\n");
}

TEST(BoardWatch, ASupplyThatSinksInFlightIsToldAndTheFlightGoesOn) {
  FlyingRig rig;
  rig.launch_to_control();
  rig.hardware.board.faults.add(BoardFault::supply_low);
  EXPECT_EQ(rig.fly_for(second)->phase, Phase::controlling);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 1U << static_cast<unsigned>(BoardFault::supply_low));
  EXPECT_TRUE(says(rig, "board: supply_low; operation continues\n")) << rig.console.text;
}

// A plug that makes contact every other millisecond must fill neither bus nor console.
TEST(BoardWatch, AFaultThatComesAndGoesIsToldTenTimesASecondAtMost) {
  BoardRig rig;
  rig.run(second);
  const int before = rig.pc.count<BoardReport>();
  for (int i = 0; i < 10'000; ++i) {
    rig.hardware.board.faults = {};
    if (i % 2 == 0) {
      rig.hardware.board.faults.add(BoardFault::imu_silent);
    }
    rig.tick();
  }
  EXPECT_LE(rig.pc.count<BoardReport>() - before, 100 + 10);
  EXPECT_GT(rig.pc.count<BoardReport>() - before, 50);
}

TEST(BoardWatch, BatteryAndOverrunsAreReported) {
  BoardRig rig;
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->battery_mv, std::nullopt);
  rig.hardware.board.battery_mv = 7912;
  rig.hardware.board.overruns = 7;
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->battery_mv, 7912);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->overruns, 7);
  rig.hardware.board.overruns = 100'000;
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->overruns, 255) << "it saturates";
}

TEST(BoardWatch, TicksThatASlowPcLeavesOutAreReportedAndAreNoFault) {
  BoardRig rig;
  rig.hardware.board.overruns = 7;
  rig.hardware.board.ticks_left_out = 100;
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->overruns, 107);
  rig.hardware.board.ticks_left_out = 0xFFFF'FFFF;
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->overruns, 255) << "it saturates";
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 0U);
  EXPECT_EQ(rig.arm().phase, Phase::armed);
}

TEST(BoardWatch, AFaultInTheMiddleOfASelfTestEndsItAndTheCanardsGoToTrim) {
  BoardRig rig;
  rig.pc.say(ArmAction::self_test);
  rig.run(4 * second);
  ASSERT_EQ(rig.pc.heard<ArmReply>()->self_test, SelfTestState::running);
  rig.hardware.board.faults.add(BoardFault::encoder_silent);
  rig.run(500 * millisecond);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->failure, SelfTestFailure::board_fault);
  EXPECT_TRUE(rig.all_pulses_are(0.0));
}

TEST(BoardWatch, AFaultBetweenTheTwoStepsOfTheCommandRefusesTheSecond) {
  BoardRig rig;
  const std::uint32_t nonce = rig.begin_arming().value();
  rig.hardware.board.faults.add(BoardFault::battery_unmeasured);
  rig.tick();
  rig.pc.say(ArmAction::confirm, nonce);
  EXPECT_EQ(rig.run(100 * millisecond)->phase, Phase::safe);
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::board_fault);
}

TEST(BoardWatch, AFaultOfAnArmedRocketIsToldAndDoesNotDisarmIt) {
  BoardRig rig;
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  rig.console.text.clear();
  rig.hardware.board.faults.add(BoardFault::accelerometer_silent);
  EXPECT_EQ(rig.run(second)->phase, Phase::armed);
  EXPECT_EQ(rig.console.text, "board: accelerometer_silent; operation continues\n");
  EXPECT_EQ(rig.hardware.shown, Signal::armed);
}

// 6 ticks that come 5 ms after the one before: 4 are missing each time.
TEST(BoardWatch, ALoopThatMissesMoreTicksThanThePlanAllowsKeepsTheRocketFromBeingArmed) {
  core::FlightPlan plan = core::default_plan();
  plan.run.overrun_limit = 23;
  BoardRig rig{plan};
  const auto be_late = [&rig](int times) {
    for (int i = 0; i < times; ++i) {
      rig.hardware.time += 4 * millisecond;
      rig.run(100 * millisecond);
    }
    rig.run(second);
  };
  rig.tick();
  be_late(5);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->overruns, 20);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 0U);
  be_late(1);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->overruns, 24);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 1U << static_cast<unsigned>(BoardFault::loop_overrun));
  EXPECT_FALSE(rig.begin_arming());
  EXPECT_EQ(rig.pc.heard<ArmReply>()->refusal, ArmRefusal::board_fault);
}

TEST(BoardWatch, TheBoardsOwnCountOfOverrunsCountsToo) {
  BoardRig rig;
  rig.hardware.board.overruns = core::default_plan().run.overrun_limit;
  rig.tick();
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 0U);
  rig.hardware.board.overruns += 1U;
  rig.run(second);
  EXPECT_EQ(rig.pc.heard<BoardReport>()->faults, 1U << static_cast<unsigned>(BoardFault::loop_overrun));
}

TEST(BoardWatch, LampAndBuzzerShowWhatItDoes) {
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  plan.run.control_time = second;
  BoardRig rig{plan};
  rig.tick();
  EXPECT_EQ(rig.hardware.shown, Signal::safe);
  rig.pc.say(ArmAction::self_test);
  rig.run(second);
  EXPECT_EQ(rig.hardware.shown, Signal::self_test);
  rig.run(8 * second);
  EXPECT_EQ(rig.hardware.shown, Signal::safe);
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  EXPECT_EQ(rig.hardware.shown, Signal::armed);
  rig.pc.say(ArmAction::start, rig.armed_with);
  ASSERT_EQ(rig.tick().phase, Phase::controlling);
  EXPECT_EQ(rig.hardware.shown, Signal::flying);
  ASSERT_EQ(rig.run(2 * second)->phase, Phase::finished);
  EXPECT_EQ(rig.hardware.shown, Signal::finished);
}

TEST(BoardWatch, ALaunchedRocketFlies) {
  EXPECT_EQ(signal_of(Phase::launched, core::PhaseReason::launch_detected, false, true), Signal::flying);
}

TEST(BoardWatch, AnArmedRocketThatMustRestFirstShowsThatItIsNotReady) {
  using enum core::PhaseReason;
  for (const core::PhaseReason reason :
       {moved_without_launch, guide_not_cleared_in_time, gyro_failed_before_control, timing_fault_before_control}) {
    EXPECT_EQ(signal_of(Phase::armed, reason, false, true), Signal::armed_not_ready);
  }
  for (const core::PhaseReason reason : {armed_by_switch_and_command, rested}) {
    EXPECT_EQ(signal_of(Phase::armed, reason, false, true), Signal::armed);
  }
}

}  // namespace
}  // namespace fantail::avionics
