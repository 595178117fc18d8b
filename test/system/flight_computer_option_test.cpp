// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gtest/gtest.h>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

TEST(FlyOn, APlaceThatDoesNotExistIsRefused) {
  Refusal{
      {}, {"fly", "--on", "moon"}, 64, {"\"moon\" is not a flight computer; allowed: host, emulator, serial:DEVICE"}};
  Refusal{{}, {"fly", "--on", "serial:"}, 64, {"\"serial:\" is not a flight computer"}};
}

TEST(FlyOn, AnImageThatIsMissingIsNamed) {
  Refusal{{},
          {"fly", "--on", "emulator", "--image", "/nowhere/fantail-emulator.elf"},
          66,
          {"/nowhere/fantail-emulator.elf: no such file",
           "it comes with the sources alone: there ./dev fly --on emulator builds build/arm/fantail-emulator.elf"}};
}

// Whether there is one depends on what has been built.
TEST(FlyOn, TheImageIsLookedForWhereTheBuildLeavesIt) {
  const auto image = std::filesystem::path{fantail_path()}.parent_path().parent_path() / "arm/fantail-emulator.elf";
  const Folder folder;
  const Outcome outcome = fantail({"fly", "--on", "emulator", "--out", "flown"}, {.working_folder = folder.path()});
  if (std::filesystem::exists(image)) {
    EXPECT_EQ(outcome.err.find("no such file"), std::string::npos) << outcome.err;
  } else {
    EXPECT_EQ(outcome.exit_code, 66);
    EXPECT_NE(outcome.err.find(image.string() + ": no such file"), std::string::npos) << outcome.err;
  }
}

TEST(FlyOn, AResetIsRefusedWhereNobodyCanResetTheProcessor) {
  Refusal{{{"r.toml",
            "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[[faults]]\nkind = \"reset\"\nfrom_s = 3\n"}},
          {"fly", "r.toml", "--on", "emulator"},
          78,
          {"r: faults.kind = \"reset\" cannot be flown with --on emulator; allowed: --on host"}};
}

TEST(FlyOn, ASerialDeviceThatIsMissingOrNoneIsNamed) {
  Refusal{{}, {"fly", "--on", "serial:/dev/there-is-none"}, 74, {"/dev/there-is-none: there is no such device"}};
  Refusal{{}, {"fly", "--on", "serial:/dev/null"}, 74, {"/dev/null: it is not a serial port"}};
}

}  // namespace
}  // namespace fantail::test
