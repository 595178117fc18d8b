// SPDX-License-Identifier: MIT
// The verb `board` and the real bench as two programs on SocketCAN.
#include <filesystem>
#include <tuple>

#include "can/rig.hpp"

namespace fantail::test {
namespace {

const std::string images = std::string{FANTAIL_TEST_SOURCE} + "/build/arm/";

class VirtualBoard : public CanSystem {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(images + "fantail-stm32f405.elf")) {
      GTEST_SKIP() << "no image; ./dev firmware builds it";
    }
    CanSystem::SetUp();
  }
};

Outcome refused(std::vector<std::string> words) {
  words.insert(words.begin(), "board");
  words.insert(words.end(), {"--can", "vcan0"});
  return fantail(words);
}

TEST_F(VirtualBoard, PassesTheSheetOfTheBench) {
  Program board{{"board", "--can", "vcan0"}};
  ASSERT_TRUE(Ear{"vcan0"}.at_rest()) << board.said();
  const Folder folder;
  const Outcome sheet =
      fantail_bench({"limits", "--can", "vcan0", "--vehicle", "tasha3_bench", "--out", folder / "sheet"});
  EXPECT_EQ(sheet.exit_code, 0) << sheet.err;
  EXPECT_PRED2(contains, sheet.out, "PASS");
  board.type("quit");
  EXPECT_EQ(board.outcome().exit_code, 0) << board.outcome().err;
  EXPECT_PRED2(contains, board.outcome().out, " 0 dropped");
}

TEST_F(VirtualBoard, IsArmedByTheBenchAndItsSwitchAndIsSafeAfterItsResetButton) {
  Program board{{"board", "--can", "vcan0"}};
  Ear ear{"vcan0"};
  ASSERT_TRUE(ear.at_rest()) << board.said();
  const auto arm = bench_until({"arm", "--can", "vcan0", "--yes"}, [](const Program& program) {
    return contains(program.said(), "Close the arm switch at the rocket.");
  });
  board.type("switch close");
  EXPECT_EQ(arm->outcome().exit_code, 0) << arm->outcome().err;
  EXPECT_TRUE(ear.reaches(core::Phase::armed));
  board.type("status");
  EXPECT_TRUE(board.says(" s, armed; arm switch closed, abort contact open; crystal runs; pulses 1500.0 "))
      << board.said();
  board.type("reset");
  EXPECT_TRUE(board.says("reset by its button or a probe")) << board.said();
  EXPECT_TRUE(ear.reaches(core::Phase::safe));
}

TEST_F(VirtualBoard, SaysWhatItMeetsAsANewOneAndKeepsOnlyItsFlashWithoutPower) {
  Program board{{"board", "--can", "vcan0", "--empty-flash"}};
  EXPECT_TRUE(board.says("\nreset by power-on\nboard: no fault\nplan: the built-in one; none is stored\n"))
      << board.said();
  ASSERT_TRUE(Ear{"vcan0"}.at_rest());
  ASSERT_EQ(fantail_bench({"plan", "tasha3_launch1", "--can", "vcan0"}).exit_code, 0);
  board.type("power off");
  board.type("status");
  EXPECT_TRUE(board.says("\noff\n")) << board.said();
  board.type("power on");
  EXPECT_TRUE(board.says("reset by power-on\nboard: no fault\nplan: the one in the flash\n")) << board.said();
  board.type("crystal stop");
  EXPECT_TRUE(board.says("board: crystal_failed, crashed; it will not be armed")) << board.said();
}

TEST_F(VirtualBoard, NamesAWordThatIsNoCommandAndGoesOn) {
  Program board{{"board", "--can", "vcan0"}};
  for (const char* line : {"switch shut", "power", "Reset", "power off", "reset", "crystal stop", "status"}) {
    board.type(line);
  }
  EXPECT_TRUE(board.says("\noff\n")) << board.said();
  board.type("quit");
  EXPECT_EQ(board.outcome().exit_code, 0);
  const std::string& said = board.outcome().err;
  for (const char* part : {"\"switch shut\" is not a command; there are:\n  switch close", "\"power\" is not a command",
                           "\"Reset\" is not a command", "  crystal stop    stop the crystal until power off\n"}) {
    EXPECT_PRED2(contains, said, part);
  }
  const std::string off = "the board is off: power on comes first\n";  // said of reset and of crystal stop
  EXPECT_NE(said.find(off), said.rfind(off)) << said;
}

TEST_F(VirtualBoard, RefusesWhatItCannotRun) {
  const Folder folder;
  const std::string text = folder.write("image.elf", "no ELF at all, and long enough for the head of one: 0123456789");
  const std::string faulty = folder.write(
      "faulty.toml",
      content(std::string{FANTAIL_TEST_SOURCE} + "/sim/scenarios/tasha3_launch2.toml") +
          "\n[[faults]]\nkind = \"device\"\ndevice = \"flash\"\nbehaviour = \"dead\"\nfrom_s = 0\nuntil_s = 9\n");
  for (const auto& [words, code, said] : std::vector<std::tuple<std::vector<std::string>, int, std::string>>{
           {{"bench_helthy"}, 66, "unknown scenario \"bench_helthy\""},
           {{faulty}, 78, "faults.device = \"flash\" cannot be run on a virtual board"},
           {{"--image", folder / "none.elf"}, 66, "none.elf: no such file"},
           {{"--image", folder / "."}, 66, ": no regular file"},
           {{"--image", text}, 65, "image.elf: not an ELF file"},
           {{"--image", "/bin/sh"}, 65, "/bin/sh: built for machine"},
           {{"--image", images + "fantail-emulator.elf"}, 65, "fantail-emulator.elf: "}}) {
    const Outcome outcome = refused(words);
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_PRED2(contains, outcome.err, said);
  }
  EXPECT_EQ(fantail({"board", "--can", "vcan9"}).exit_code, 74);
}

}  // namespace
}  // namespace fantail::test
