// SPDX-License-Identifier: MIT
// The bytes that are flashed, in flight.
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include "board_flight.hpp"
#include "input/scenario_file.hpp"
#include "protocol/crc32c.hpp"
#include "resets.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "tick_meter.hpp"

namespace fantail::board {
namespace {

using namespace std::string_literals;
using testing::ContainsRegex;
using testing::HasSubstr;

const std::string image_file = std::string{FANTAIL_TEST_SOURCE} + "/build/arm/fantail-stm32f405.elf";

class FlashedImage : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(image_file)) {
      GTEST_SKIP() << "no image; ./dev firmware builds it";
    }
  }
};

TEST_F(FlashedImage, FliesFromResetToLandingAndItsFlashRepeatsByteForByte) {
  const test::Folder folder;
  const test::Outcome flown =
      test::fantail({"fly", "tasha3_launch2", "--on", "board", "--image", image_file, "--out", "flown"},
                    {.working_folder = folder.path()});
  EXPECT_EQ(flown.exit_code, 0) << flown.err;
  EXPECT_THAT(flown.out, HasSubstr("every output byte as recorded"));
  for (const char* file : {"board_pulses.csv", "board_can.log", "board_console.txt", "report.html", "flight.ftl"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() / "flown" / file), 100U) << file;
  }
  std::ifstream bus{folder.path() / "flown" / "board_can.log"};
  double before_s = 0.0;
  for (std::string line; std::getline(bus, line);) {
    const double time_s = std::stod(line.substr(1));
    ASSERT_GT(time_s - before_s, 47e-6) << line << ": a frame without data takes as long at 1 Mbit/s";
    before_s = time_s;
  }
}

// What its makers may rely on: docs/devices.md.
TEST_F(FlashedImage, HasPulsesAgainWithinTenMillisecondsOfAnyResetAndFortyWithoutCrystal) {
  const Image image{image_file};
  const auto scenario = input::load_scenario("tasha3_launch2", {});
  BoardFlight flight{image, scenario};
  ASSERT_TRUE(flight.fly_to(core::Phase::controlling, 30.0));
  flight.fly_for(0.5);
  for (const ResetCase& each : all_resets(image)) {
    const Aftermath after = what_if(flight, std::string{each.name}, 1e-3, 0.1, each.happens);
    ASSERT_TRUE(after.is_there) << each.name;
    EXPECT_EQ(after.restarts, 1) << each.name;
    EXPECT_GT(after.boot_ms, 5.0) << each.name;
    EXPECT_LT(after.boot_ms, each.name == "crystal stops" ? 40.0 : 10.0) << each.name;
    EXPECT_GE(after.narrowest_us, 1'390.0) << each.name << ": 9 deg, and what its own oscillator is off";
    EXPECT_LE(after.widest_us, 1'610.0) << each.name;
    EXPECT_EQ(after.control_after_ms >= 0.0, each.flies_on) << each.name;
  }
  EXPECT_TRUE(flight.board().violations().empty()) << flight.board().violations().front();
}

TEST_F(FlashedImage, BeginsItsPulsesAtTheSameInstantOfATickBehindItsCommandsBeforeAndAfterAnyReset) {
  const Image image{image_file};
  const auto scenario = input::load_scenario("tasha3_launch2", {});
  std::optional<TickMeter> meter;
  BoardFlight flight{image, scenario};
  meter.emplace(image, flight.board());
  ASSERT_TRUE(flight.fly_to(core::Phase::controlling, 30.0));
  const auto begins_s = [&] {
    flight.fly_for(0.1);
    return std::fmod(flight.board().chip.pulses().back().begin_s - meter->began_s() + 0.1, 1e-3);
  };
  meter->forget();
  EXPECT_NEAR(begins_s(), 0.5e-3, 20e-6);
  EXPECT_LT(meter->last_written_s(), 0.3e-3);
  for (const ResetCase& each : all_resets(image)) {
    if (each.flies_on) {
      flight.board().run_until(flight.board().now_s() + 0.37e-3);
      each.happens(flight.board());
      EXPECT_NEAR(begins_s(), 0.5e-3, 20e-6) << each.name;
    }
  }
}

TEST_F(FlashedImage, WithoutTheAddressSpaceThatTheEmulatorWantsItSaysSo) {
  const test::Folder folder;
  const test::Outcome outcome = test::fantail({"fly", "tasha3_launch2", "--on", "board", "--image", image_file},
                                              {.working_folder = folder.path(), .prepare = [] {
                                                 const rlimit small{.rlim_cur = 700U << 20U, .rlim_max = 700U << 20U};
                                                 ::setrlimit(RLIMIT_AS, &small);
                                               }});
  EXPECT_EQ(outcome.exit_code, 74) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("the emulator wants 1 GiB of address space, of which it uses little: "));
}

// The random numbers come from elsewhere then: 0x50060800 becomes an address where nothing is.
TEST_F(FlashedImage, OneThatReachesForAnAddressWithoutADeviceIsNamedWithAddressAndPlace) {
  std::ifstream file{image_file, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t place = bytes.find("\x00\x08\x06\x50"s);
  ASSERT_NE(place, std::string::npos);
  bytes[place + 2] = '\x16';
  const test::Folder folder;
  const test::Outcome outcome =
      test::fantail({"fly", "tasha3_launch2", "--on", "board", "--image", folder.write("image.elf", bytes)},
                    {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 65) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("an access to 0x5016080"));
  EXPECT_THAT(outcome.err, HasSubstr("hal::stm32f4::Entropy"));
}

// The chirp, of which nobody knows before control, loads from an address where nothing is; sealed again.
TEST_F(FlashedImage, OneThatCrashesInFlightHasFailedAndTheFirstThatWasWrongIsNamed) {
  const Image image{image_file};
  std::vector<std::byte> flash = image.flash();
  std::ifstream file{image_file, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  const auto put = [&](std::uint32_t address, const std::string& word) {
    const auto* const old = reinterpret_cast<const char*>(flash.data()) + (address - Image::flash_begin - 12);
    const std::size_t place = bytes.find(std::string{old, 16});
    ASSERT_NE(place, std::string::npos);
    bytes.replace(place + 12, word.size(), word);
    std::memcpy(flash.data() + (address - Image::flash_begin), word.data(), word.size());
  };
  const auto chirp = image.address_of("_ZN7fantail4core5Chirp6updateENSt6chrono8durationIxSt5ratioILx1ELx1000000EEEE");
  const auto seal = image.address_of("image_crc");
  ASSERT_TRUE(chirp && seal);
  put(*chirp, "\x4F\xF0\xC0\x40\x00\x68"s);  // mov r0, #0x60000000; ldr r0, [r0]
  const std::uint32_t crc = protocol::crc32c(std::span{flash}.first(*seal - Image::flash_begin));
  put(*seal, std::string{reinterpret_cast<const char*>(&crc), sizeof crc});
  const test::Folder folder;
  const test::Outcome outcome = test::fantail(
      {"fly", "tasha3_launch2", "--on", "board", "--image", folder.write("image.elf", bytes), "--out", "flown"},
      {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 74) << outcome.out;
  EXPECT_THAT(outcome.err, ContainsRegex("not all was well on the board: .* s: an access to 0x60000000"));
  EXPECT_THAT(outcome.out, HasSubstr("Not all was well on the board, by the time since its power-up: "));
  EXPECT_THAT(outcome.out, HasSubstr("The processor was reset (software): no tick is on record from "));
  std::ifstream complaints{folder.path() / "flown" / "board_complaints.txt"};
  const std::string all{std::istreambuf_iterator<char>{complaints}, {}};
  EXPECT_THAT(all, HasSubstr(" s: a reset: software\n"));
  EXPECT_THAT(all, HasSubstr("an access to 0x60000000, where nothing is"));
}

// What a gyro has missed is made up for in the tick of its return.
TEST_F(FlashedImage, SensorsThatAreDeadInTheWorldDoNotAnswerOnTheBoardAndNoTickIsLateWhenTheyReturn) {
  const Image image{image_file};
  const test::Folder folder;
  std::ifstream shipped{std::string{FANTAIL_TEST_SOURCE} + "/sim/scenarios/tasha3_launch2.toml"};
  std::string scenario{std::istreambuf_iterator<char>{shipped}, {}};
  for (const auto* device : {"imu", "accelerometer"}) {
    scenario += fmt::format(
        "\n[[faults]]\nkind = \"device\"\ndevice = \"{}\"\nbehaviour = \"dead\"\nfrom_s = 1\nuntil_s = 1.85\n", device);
  }
  const std::vector<std::string> changes{"motion.longest_gyro_gap_s=1"};
  const auto faulty = input::load_scenario(folder.write("faulty.toml", scenario), input::parse_overrides(changes));
  BoardFlight flight{image, faulty};
  const TickMeter meter{image, flight.board()};
  ASSERT_TRUE(flight.fly_to(core::Phase::controlling, 30.0));
  flight.fly_for(1.2);
  EXPECT_THAT(flight.faults(), HasSubstr("imu_silent"));
  EXPECT_THAT(flight.faults(), HasSubstr("accelerometer_silent"));
  flight.fly_for(0.8);
  EXPECT_EQ(flight.record().phase, core::Phase::controlling);
  EXPECT_LT(meter.longest_s(), 0.8e-3);
}

TEST_F(FlashedImage, FaultsThatAVirtualBoardCannotHaveAreRefused) {
  const test::Folder folder;
  std::ifstream shipped{std::string{FANTAIL_TEST_SOURCE} + "/sim/scenarios/tasha3_launch2.toml"};
  const std::string scenario{std::istreambuf_iterator<char>{shipped}, {}};
  for (const auto* fault : {"device = \"flash\"\nbehaviour = \"dead\"", "device = \"supply\"\nbehaviour = \"sagging\"",
                            "device = \"imu\"\nbehaviour = \"delayed\"\ndelay_s = 0.05"}) {
    const std::string name = folder.write(
        "faulty.toml", scenario + "\n[[faults]]\nkind = \"device\"\nfrom_s = 1\nuntil_s = 9\n" + fault + "\n");
    const test::Outcome outcome = test::fantail({"fly", name, "--on", "board", "--image", image_file});
    EXPECT_EQ(outcome.exit_code, 78) << fault << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("--on board"));
  }
}

TEST_F(FlashedImage, OneThatNeverComesToItsFirstTickIsNamedWithThePlaceWhereItIs) {
  const test::Folder folder;
  const test::Outcome outcome = test::fantail({"fly", "tasha3_launch2", "--on", "board", "--image",
                                               std::string{FANTAIL_TEST_SOURCE} + "/build/arm/fantail-count.elf"},
                                              {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 65) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("fantail-count.elf: "));
}

}  // namespace
}  // namespace fantail::board
