// SPDX-License-Identifier: MIT
#include <csignal>

#include <gmock/gmock.h>
#include <sys/wait.h>

#include "emulator/images.hpp"
#include "input/scenario_file.hpp"
#include "protocol/tick_digest.hpp"
#include "sim/world.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

class EmulatorTrouble : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string objection = objection_to_images(); !objection.empty()) {
      GTEST_SKIP() << objection;
    }
  }

  static hil::EmulatorOptions options() { return {.image = image("fantail-emulator.elf")}; }
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
};

std::string why(const std::function<void()>& act) {
  try {
    act();
  } catch (const hil::TargetError& error) {
    return error.what();
  }
  return "nothing was the matter";
}

TEST_F(EmulatorTrouble, AFlightComputerThatIsKilledEndsTheFlightWithItsReason) {
  auto wire = std::make_unique<hil::Emulator>(options());
  const pid_t process = wire->process();
  hil::Target target{std::move(wire)};
  sim::World world{scenario, sim::World::small_flash, target.maker()};
  const auto fly = [&] {
    for (int tick = 0; tick < 1000; ++tick) {
      if (tick == 500) {
        ::kill(process, SIGKILL);
      }
      world.tick();
      world.advance();
    }
  };
  EXPECT_THAT(why(fly), HasSubstr("ended before the flight did: it was killed by signal 9"));
}

TEST_F(EmulatorTrouble, AFlightComputerThatIsGoneBeforeItIsAskedEndsTheFlightWithItsReason) {
  auto wire = std::make_unique<hil::Emulator>(options());
  const pid_t process = wire->process();
  hil::Target target{std::move(wire)};
  sim::World world{scenario, sim::World::small_flash, target.maker()};
  world.tick();
  world.advance();
  ::kill(process, SIGKILL);
  siginfo_t end{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOWAIT), 0);  // nobody reads the pipe now
  EXPECT_THAT(why([&] { world.tick(); }), HasSubstr("ended before the flight did: it was killed by signal 9"));
}

TEST_F(EmulatorTrouble, AFlightComputerThatSaysNothingIsGivenUp) {
  auto wire = std::make_unique<hil::Emulator>(options());
  const pid_t process = wire->process();
  hil::Target target{std::move(wire), {}, {.send_again = milliseconds{50}, .give_up = milliseconds{500}}};
  sim::World world{scenario, sim::World::small_flash, target.maker()};
  world.tick();
  world.advance();
  ::kill(process, SIGSTOP);
  EXPECT_THAT(why([&] { world.tick(); }), HasSubstr("has sent nothing for 0.5 s"));
}

TEST_F(EmulatorTrouble, TheProcessEndsWithItsOwner) {
  pid_t process = 0;
  {
    const hil::Emulator emulator{options()};
    process = emulator.process();
    ASSERT_EQ(::kill(process, 0), 0);
  }
  EXPECT_EQ(::kill(process, 0), -1);
}

TEST_F(EmulatorTrouble, AnEmulatorThatIsNotInstalledIsNamedWithItsPackage) {
  hil::EmulatorOptions missing = options();
  missing.program = "qemu-system-of-another-world";
  EXPECT_THAT(why([&] { const hil::Emulator emulator{missing}; }), HasSubstr("Debian package qemu-system-arm"));
}

TEST_F(EmulatorTrouble, AFileThatIsNoImageEndsTheEmulatorWithItsOwnWords) {
  hil::EmulatorOptions no_image = options();
  no_image.image = "/etc/passwd";  // a text
  const auto begin = [&] {
    const hil::Target target{
        std::make_unique<hil::Emulator>(no_image), {}, {.send_again = milliseconds{50}, .give_up = milliseconds{500}}};
  };
  EXPECT_THAT(why(begin), testing::Not(HasSubstr("nothing was the matter")));
}

TEST(EmulatorImage, ThatIsMissingIsNamed) {
  try {
    const hil::Emulator emulator{{.image = "/nowhere/fantail-emulator.elf"}};
    ADD_FAILURE() << "it was flown";
  } catch (const text::Error& error) {
    EXPECT_EQ(error.kind(), text::ErrorKind::no_such_input);
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/fantail-emulator.elf: no such file"));
  }
}

/// Loses or damages what passes, as somebody says.
class BadWire final : public hil::Wire {
 public:
  explicit BadWire(std::unique_ptr<hil::Wire> wire) : wire_{std::move(wire)} {}
  void write(std::span<const std::byte> bytes) override {
    written += 1;
    std::vector<std::byte> on_the_way{bytes.begin(), bytes.end()};
    if (damage_question.count(written) != 0) {
      on_the_way[on_the_way.size() / 2] ^= std::byte{0x10};
    }
    if (lose_question.count(written) == 0) {
      wire_->write(on_the_way);
    }
  }
  std::size_t read(std::span<std::byte> out, milliseconds at_most) override {
    const std::size_t size = wire_->read(out, at_most);
    came += size != 0 ? 1 : 0;
    if (damage_all) {
      for (std::size_t at = 8; at < size; at += 8) {  // several frames may come at once
        out[at] ^= std::byte{0x01};
      }
    }
    if (size != 0 && damage_answer.count(came) != 0) {
      out[size / 2] ^= std::byte{0x01};
    }
    return size != 0 && lose_answer.count(came) != 0 ? 0 : size;
  }

  std::set<int> damage_question, lose_question, damage_answer, lose_answer;
  bool damage_all = false;
  int written = 0;
  int came = 0;

 private:
  std::unique_ptr<hil::Wire> wire_;
};

TEST_F(EmulatorTrouble, WhatIsDamagedOrLostOnTheWayIsSentAgainAndTheFlightIsTheSame) {
  auto wire = std::make_unique<BadWire>(std::make_unique<hil::Emulator>(options()));
  wire->damage_question = {50};
  wire->lose_question = {100};
  wire->damage_answer = {150};
  wire->lose_answer = {200};
  hil::Target target{std::move(wire), {}, {.send_again = milliseconds{100}, .give_up = milliseconds{5'000}}};
  sim::World here{scenario};
  sim::World there{scenario, sim::World::small_flash, target.maker()};
  for (int tick = 0; tick < 400; ++tick) {
    ASSERT_EQ(protocol::tick_digest(there.tick()), protocol::tick_digest(here.tick())) << tick;
    here.advance();
    there.advance();
  }
  EXPECT_GE(target.link().asked_again(), 4U);
  EXPECT_GE(target.link().damaged(), 1U);
}

TEST_F(EmulatorTrouble, AWireThatDamagesEverythingIsNamedAsThat) {
  auto wire = std::make_unique<BadWire>(std::make_unique<hil::Emulator>(options()));
  wire->damage_all = true;
  EXPECT_THAT(why([&] {
                const hil::Target target{
                    std::move(wire), {}, {.send_again = milliseconds{50}, .give_up = milliseconds{500}}};
              }),
              HasSubstr("arrive damaged"));
}

}  // namespace
}  // namespace fantail::test
