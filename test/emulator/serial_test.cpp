// SPDX-License-Identifier: MIT
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "emulator/images.hpp"
#include "hil/wire.hpp"
#include "input/scenario_file.hpp"
#include "protocol/tick_digest.hpp"
#include "sim/world.hpp"

namespace fantail::test {
namespace {

using testing::HasSubstr;

/// The board's own image for a serial line, on an emulated board whose serial port is a terminal of this PC.
class EmulatedBoard {
 public:
  EmulatedBoard() {
    int out[2];
    EXPECT_EQ(::pipe(out), 0);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(out[1], STDOUT_FILENO);
      ::dup2(out[1], STDERR_FILENO);
      ::close(out[0]);
      const std::string elf = image("fantail-hil.elf").string();
      ::execlp("qemu-system-arm", "qemu-system-arm", "-nodefaults", "-no-user-config", "-display", "none", "-M",
               "netduinoplus2", "-serial", "pty", "-kernel", elf.c_str(), nullptr);
      ::_exit(1);
    }
    ::close(out[1]);
    std::FILE* said = ::fdopen(out[0], "r");
    char line[256] = "";
    char name[128] = "";
    while (device.empty() && std::fgets(line, sizeof line, said) != nullptr) {
      if (std::sscanf(line, "char device redirected to %127s", name) == 1) {
        device = name;
      }
    }
    std::fclose(said);
  }
  ~EmulatedBoard() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;

  std::string device;

 private:
  pid_t process_ = -1;
};

TEST(Serial, TheBoardAtTheEndOfASerialLineFliesAsTheHostDoesAndCanBeFlownAgain) {
  if (const std::string objection = objection_to_images(); !objection.empty()) {
    GTEST_SKIP() << objection;
  }
  const EmulatedBoard board;
  ASSERT_FALSE(board.device.empty());
  const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  for (int flight = 0; flight < 2; ++flight) {
    hil::Target target{std::make_unique<hil::SerialPort>(board.device)};
    EXPECT_EQ(target.identity().image, "fantail-hil");
    sim::World here{scenario};
    sim::World there{scenario, sim::World::small_flash, target.maker()};
    for (int tick = 0; tick < 150; ++tick) {
      ASSERT_EQ(protocol::tick_digest(there.tick()), protocol::tick_digest(here.tick())) << tick;
      here.advance();
      there.advance();
    }
    EXPECT_EQ(target.link().damaged(), 0U);
    EXPECT_GT(target.times().tick, 0U);
  }
}

std::string why_not(const std::string& device) {
  try {
    const hil::SerialPort port{device};
  } catch (const hil::TargetError& error) {
    return error.what();
  }
  return "it was opened";
}

TEST(Serial, ADeviceThatIsMissingIsNoPortOrIsInUseIsNamed) {
  EXPECT_THAT(why_not("/dev/there-is-no-such-device"), HasSubstr("there is no such device"));
  EXPECT_THAT(why_not("/dev/null"), HasSubstr("/dev/null: it is not a serial port"));
  int master = -1;
  int slave = -1;
  char name[128] = "";
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  {
    const hil::SerialPort first{name};
    EXPECT_THAT(why_not(name), HasSubstr("another program is using it"));
  }
  EXPECT_EQ(why_not(name), "it was opened");
  ::close(slave);
  ::close(master);
}

TEST(Serial, ALineOnWhichNobodyAnswersIsGivenUp) {
  int master = -1;
  int slave = -1;
  char name[128] = "";
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  const auto begin = [&] {
    const hil::Target target{std::make_unique<hil::SerialPort>(name),
                             {},
                             {.send_again = std::chrono::milliseconds{20}, .give_up = std::chrono::milliseconds{100}}};
  };
  try {
    begin();
    ADD_FAILURE() << "somebody answered";
  } catch (const hil::TargetError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has sent nothing for 0.1 s"));
  }
  ::close(slave);
  ::close(master);
}

}  // namespace
}  // namespace fantail::test
