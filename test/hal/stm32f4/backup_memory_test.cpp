// SPDX-License-Identifier: MIT
#include "hal/stm32f4/backup_memory.hpp"

#include <array>

#include <gtest/gtest.h>

#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::RegisterWorld;

TEST(TheBackupMemory, IsTheMemoryItWasGivenOnceItsDomainMayBeWritten) {
  registers::Rcc rcc{};
  registers::Pwr pwr{};
  registers::Rtc rtc{};
  std::array<std::byte, 4096> cells{};
  BackupMemory memory{rcc, pwr, rtc, cells};
  EXPECT_EQ(RegisterWorld::peek(rcc.apb1enr), 1U << 28U);
  EXPECT_EQ(RegisterWorld::peek(pwr.cr), 1U << 8U);
  EXPECT_EQ(RegisterWorld::peek(rcc.ahb1enr), 1U << 18U);
  EXPECT_EQ(memory.bytes().data(), cells.data());
  EXPECT_EQ(memory.bytes().size(), 4096U);
}

TEST(TheBackupMemory, OpensTheDomainOnlyWhenThePowerControlHasItsClock) {
  RegisterWorld world;
  registers::Rcc rcc{};
  registers::Pwr pwr{};
  registers::Rtc rtc{};
  world.on_write(pwr.cr, [&](std::uint32_t value) {
    if ((RegisterWorld::peek(rcc.apb1enr) >> 28U & 1U) != 0) {
      RegisterWorld::poke(pwr.cr, value);
    }
  });
  const BackupMemory memory{rcc, pwr, rtc, {}};
  EXPECT_EQ(RegisterWorld::peek(pwr.cr), 1U << 8U);
}

TEST(TheBackupMemory, IsNoneWhereItsDomainStaysClosed) {
  RegisterWorld world;
  registers::Rcc rcc{};
  registers::Pwr pwr{};
  registers::Rtc rtc{};
  world.on_write(pwr.cr, [](std::uint32_t) {});  // as in the emulator
  std::array<std::byte, 4096> cells{};
  BackupMemory memory{rcc, pwr, rtc, cells};
  EXPECT_TRUE(memory.bytes().empty());
}

}  // namespace
}  // namespace fantail::hal::stm32f4
