// SPDX-License-Identifier: MIT
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
          {"/nowhere/fantail-emulator.elf: no such file", "./dev fly --on emulator builds it"}};
}

TEST(FlyOn, ASerialDeviceThatIsMissingOrNoneIsNamed) {
  Refusal{{}, {"fly", "--on", "serial:/dev/there-is-none"}, 74, {"/dev/there-is-none: there is no such device"}};
  Refusal{{}, {"fly", "--on", "serial:/dev/null"}, 74, {"/dev/null: it is not a serial port"}};
}

}  // namespace
}  // namespace fantail::test
