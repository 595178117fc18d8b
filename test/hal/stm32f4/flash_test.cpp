// SPDX-License-Identifier: MIT
#include "hal/stm32f4/flash.hpp"

#include "fake_w25q.hpp"
#include "hal/stm32f4/w25q.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeClock;
using test::FakePort;
using test::FakeSpi;
using test::FakeW25q;
using test::RegisterWorld;

constexpr std::uint32_t bus_hz = 42'000'000;
constexpr std::uint32_t mebibyte = 1U << 20U;

class FlashTest : public testing::Test {
 protected:
  RegisterWorld world;
  FakeClock clock;
  FakePort port{world};
  FakeSpi spi{world, bus_hz};
  FakeW25q device{clock};
  SpiBus bus{spi.block(), bus_hz};

  void SetUp() override { spi.attach(port, 15, device); }
  void TearDown() override {
    for (const std::string& violation : spi.violations) {
      ADD_FAILURE() << violation;
    }
  }

  Flash make() { return Flash{SpiDevice{bus, Pin{port.block(), 15}, w25q::spi}, clock}; }
  Flash started() {
    Flash flash = make();
    flash.start();
    return flash;
  }
  static std::vector<std::byte> counting(std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; ++i) {
      bytes[i] = static_cast<std::byte>(i + 1);
    }
    return bytes;
  }
  static std::vector<std::byte> read(Flash& flash, std::uint32_t address, std::size_t size) {
    std::vector<std::byte> bytes(size);
    EXPECT_EQ(flash.read(address, bytes), FlashResult::ok);
    return bytes;
  }
};

TEST_F(FlashTest, WhatIsProgrammedIsReadWhenTheDeviceIsIdleAgain) {
  Flash flash = started();
  const auto bytes = counting(256);
  ASSERT_EQ(flash.program(0x12300, bytes), FlashResult::ok);
  std::vector<std::byte> out(256);
  EXPECT_TRUE(flash.busy());
  EXPECT_EQ(flash.read(0x12300, out), FlashResult::busy);
  EXPECT_EQ(flash.program(0x12400, bytes), FlashResult::busy);
  EXPECT_EQ(flash.erase_sector(0x12000), FlashResult::busy);
  clock.time += device.program_time;
  EXPECT_FALSE(flash.busy());
  EXPECT_EQ(read(flash, 0x12300, 256), bytes);
  EXPECT_EQ(read(flash, 0x123FF, 2), (std::vector{bytes[255], std::byte{0xFF}}));
  EXPECT_EQ(spi.clock_hz(), 21'000'000U);
  EXPECT_TRUE(flash.faults().none());
}

// So whoever wants to know reads it back: avionics/record_stream.
TEST_F(FlashTest, NeitherStatusNorFaultTellsOfACellThatDidNotTakeItsBit) {
  Flash flash = started();
  auto bytes = counting(256);
  bytes[7] = std::byte{0};
  device.worn = {.address = 0x12307, .mask = std::byte{0x10}};
  ASSERT_EQ(flash.program(0x12300, bytes), FlashResult::ok);
  clock.time += device.program_time;
  EXPECT_FALSE(flash.busy());
  EXPECT_TRUE(flash.faults().none());
  EXPECT_EQ(read(flash, 0x12307, 1)[0], std::byte{0x10});
}

TEST_F(FlashTest, AnEraseTurnsOneSectorToOnes) {
  std::ranges::fill(device.cells, std::byte{0});
  Flash flash = started();
  ASSERT_EQ(flash.erase_sector(0x3000), FlashResult::ok);
  EXPECT_TRUE(flash.busy());
  clock.time += device.erase_time;
  EXPECT_EQ(read(flash, 0x2FFF, 1)[0], std::byte{0});
  EXPECT_EQ(read(flash, 0x3000, 1)[0], std::byte{0xFF});
  EXPECT_EQ(read(flash, 0x3FFF, 2), (std::vector{std::byte{0xFF}, std::byte{0}}));
}

TEST_F(FlashTest, NothingIsBegunOutOfRange) {
  Flash flash = started();
  const auto bytes = counting(256);
  std::vector<std::byte> out(2);
  EXPECT_EQ(flash.program(0x101, bytes), FlashResult::out_of_range);  // across a page
  EXPECT_EQ(flash.program(mebibyte, std::span{bytes}.first(1)), FlashResult::out_of_range);
  EXPECT_EQ(flash.program(0xFFFFFFFF, bytes), FlashResult::out_of_range);
  EXPECT_EQ(flash.erase_sector(0x1001), FlashResult::out_of_range);
  EXPECT_EQ(flash.erase_sector(mebibyte), FlashResult::out_of_range);
  EXPECT_EQ(flash.read(mebibyte - 1, out), FlashResult::out_of_range);
  EXPECT_EQ(flash.program(0x100, {}), FlashResult::ok);
  EXPECT_EQ(device.programs + device.erases, 0);
}

TEST_F(FlashTest, TheSizesOfTheFamilyComeFromTheId) {
  for (std::uint8_t capacity = 0x14; capacity <= 0x18; ++capacity) {
    for (const std::uint8_t type : {std::uint8_t{0x40}, std::uint8_t{0x70}}) {  // W25Q128JV-IQ and -IM
      device.id = {0xEF, type, capacity};
      const Flash flash = started();
      EXPECT_EQ(flash.geometry().size, 1U << capacity);
      EXPECT_EQ(flash.geometry().sector_size, 4096U);
      EXPECT_EQ(flash.geometry().page_size, 256U);
      EXPECT_TRUE(flash.faults().none());
    }
  }
}

TEST_F(FlashTest, AnotherDeviceIsNotUsed) {
  for (const auto& id : std::array<std::array<std::uint8_t, 3>, 5>{
           {{0xEF, 0x40, 0x13}, {0xEF, 0x40, 0x19}, {0xEF, 0x60, 0x18}, {0xC2, 0x20, 0x18}, {0x00, 0x40, 0x18}}}) {
    device.id = id;
    Flash flash = started();
    EXPECT_TRUE(flash.faults().has(BoardFault::flash_wrong_id));
    EXPECT_FALSE(flash.faults().has(BoardFault::flash_silent));
    EXPECT_EQ(flash.geometry().size, 0U);
    std::vector<std::byte> out(1);
    EXPECT_EQ(flash.read(0, out), FlashResult::failed);
    EXPECT_EQ(flash.program(0, out), FlashResult::failed);
    EXPECT_EQ(flash.erase_sector(0), FlashResult::failed);
    EXPECT_FALSE(flash.busy());
  }
}

TEST_F(FlashTest, ADeviceThatIsNotThereIsSilentAndCostsABoundedTime) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    device.stuck_at = level;
    spi.forget_traffic();
    Flash flash = started();
    EXPECT_TRUE(flash.faults().has(BoardFault::flash_silent));
    EXPECT_LE(spi.wire_us(), 150.0);
    std::vector<std::byte> out(1);
    EXPECT_EQ(flash.read(0, out), FlashResult::failed);
  }
}

TEST_F(FlashTest, ADeviceThatFallsSilentFailsAndIsTakenBack) {
  Flash flash = started();
  device.stuck_at = 0xFF;
  std::vector<std::byte> out(1);
  EXPECT_EQ(flash.read(0, out), FlashResult::failed);
  EXPECT_EQ(flash.program(0, out), FlashResult::failed);
  EXPECT_TRUE(flash.faults().has(BoardFault::flash_silent));
  device.stuck_at.reset();
  EXPECT_EQ(flash.read(0, out), FlashResult::ok);
  EXPECT_TRUE(flash.faults().none());
}

TEST_F(FlashTest, ADeviceInPowerDownIsWoken) {
  device.asleep = true;
  Flash flash = started();
  EXPECT_EQ(flash.geometry().size, mebibyte);
  EXPECT_TRUE(flash.faults().none());
}

TEST_F(FlashTest, AProcessorThatIsResetInTheMiddleOfAnEraseComesThrough) {
  std::ranges::fill(device.cells, std::byte{0});
  {
    Flash before = started();
    ASSERT_EQ(before.erase_sector(0), FlashResult::ok);
  }
  clock.time += Microseconds{10'000};
  const auto looks = spi.looks();
  Flash after = started();
  EXPECT_LE(spi.looks() - looks, 100U);  // it did not wait
  EXPECT_EQ(after.geometry().size, 16 * mebibyte);
  EXPECT_TRUE(after.faults().none());
  std::vector<std::byte> out(1);
  EXPECT_EQ(after.read(0, out), FlashResult::busy);
  clock.time += device.erase_time;
  EXPECT_EQ(after.read(0, out), FlashResult::busy);  // and now it is known what it is
  EXPECT_EQ(after.geometry().size, mebibyte);
  EXPECT_EQ(after.read(0, out), FlashResult::ok);
  EXPECT_EQ(out[0], std::byte{0xFF});
}

TEST_F(FlashTest, BusyForLongerThanTheDataSheetAllowsIsAFaultUntilItEnds) {
  Flash flash = started();
  const auto bytes = counting(1);
  for (const Microseconds longest : {Microseconds{3'000}, Microseconds{400'000}}) {
    if (longest == Microseconds{3'000}) {
      ASSERT_EQ(flash.program(0, bytes), FlashResult::ok);
    } else {
      ASSERT_EQ(flash.erase_sector(0), FlashResult::ok);
    }
    device.always_busy = true;
    clock.time += longest;
    EXPECT_TRUE(flash.busy());
    EXPECT_TRUE(flash.faults().none());
    clock.time += Microseconds{1};
    EXPECT_TRUE(flash.busy());
    EXPECT_TRUE(flash.faults().has(BoardFault::flash_stuck));
    EXPECT_EQ(flash.program(0, bytes), FlashResult::busy);
    device.always_busy = false;
    EXPECT_FALSE(flash.busy());
    EXPECT_TRUE(flash.faults().none());
  }
}

TEST_F(FlashTest, AlwaysBusySinceBootIsStuckAfterTheLongestErase) {
  device.always_busy = true;
  Flash flash = started();
  clock.time += Microseconds{400'000};
  EXPECT_TRUE(flash.busy());
  EXPECT_TRUE(flash.faults().none());
  clock.time += Microseconds{1};
  EXPECT_TRUE(flash.busy());
  EXPECT_TRUE(flash.faults().has(BoardFault::flash_stuck));
}

TEST_F(FlashTest, ADeviceThatDoesNotTakeWriteEnableFailsAndNothingIsSent) {
  Flash flash = started();
  device.ignores_write_enable = true;
  EXPECT_EQ(flash.program(0, counting(1)), FlashResult::failed);
  EXPECT_EQ(flash.erase_sector(0), FlashResult::failed);
  EXPECT_EQ(device.programs + device.erases, 0);
}

TEST_F(FlashTest, ProtectionIsClearedAtBootAndNothingElseIsChanged) {
  device.status = {0x7C, 0x42, 0x64};  // all protected, twice over; quad enable, drive strength
  Flash flash = started();
  EXPECT_EQ(device.status, (std::array<std::uint8_t, 3>{0x00, 0x02, 0x60}));
  ASSERT_EQ(flash.program(0, counting(1)), FlashResult::ok);
  EXPECT_EQ(device.programs, 1);
}

TEST_F(FlashTest, WhereProtectionCannotBeClearedADeviceCanOnlyBeRead) {
  device.status = {0x1C, 0, 0};
  device.status_locked = true;
  Flash flash = started();
  EXPECT_EQ(flash.program(0, counting(1)), FlashResult::failed);
  EXPECT_EQ(flash.erase_sector(0), FlashResult::failed);
  EXPECT_EQ(read(flash, 0, 1)[0], std::byte{0xFF});
}

TEST_F(FlashTest, APowerCutInTheMiddleLeavesADeviceThatWorks) {
  const auto bytes = counting(256);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Flash flash = started();
    ASSERT_EQ(flash.program(0x5000, bytes), FlashResult::ok) << "seed " << seed;
    device.cut_power(seed);
    Flash again = started();
    const auto torn = read(again, 0x5000, 256);
    for (std::size_t i = 0; i < torn.size(); ++i) {
      ASSERT_EQ(torn[i] & bytes[i], bytes[i]) << "seed " << seed;  // no bit is gone that was not to go
    }
    ASSERT_EQ(again.erase_sector(0x5000), FlashResult::ok);
    device.cut_power(seed);
    Flash third = started();
    ASSERT_EQ(third.erase_sector(0x5000), FlashResult::ok);
    clock.time += device.erase_time;
    EXPECT_TRUE(std::ranges::all_of(read(third, 0x5000, 256), [](std::byte b) { return b == std::byte{0xFF}; }));
  }
}

TEST_F(FlashTest, ABusThatStopsFails) {
  Flash flash = started();
  spi.stop();
  std::vector<std::byte> out(256);
  EXPECT_EQ(flash.read(0, out), FlashResult::failed);
  EXPECT_EQ(flash.program(0, out), FlashResult::failed);
  EXPECT_FALSE(flash.busy());
  spi.violations.clear();
  spi.go_on();
  EXPECT_EQ(flash.read(0, out), FlashResult::ok);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
