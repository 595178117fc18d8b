// SPDX-License-Identifier: MIT
#include "hal/stm32f4/spi_bus.hpp"

#include "fake_spi.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakePort;
using test::FakeSpi;
using test::RegisterWorld;
using test::SpiSlave;

/// Answers each byte with its complement, and remembers all it was told.
class Echo final : public SpiSlave {
 public:
  Echo(std::uint8_t mode, std::uint32_t most_hz, std::uint32_t select_ns = 0)
      : mode_{mode}, most_hz_{most_hz}, select_ns_{select_ns} {}
  [[nodiscard]] Needs needs() const override {
    return {.modes = {mode_}, .most_hz = most_hz_, .select_ns = select_ns_};
  }
  void selected() override { frames.emplace_back(); }
  std::uint8_t exchange(std::uint8_t out) override {
    frames.back().push_back(out);
    return static_cast<std::uint8_t>(~out);
  }
  void deselected() override { released += 1; }

  std::vector<std::vector<std::uint8_t>> frames{};
  int released = 0;

 private:
  std::uint8_t mode_;
  std::uint32_t most_hz_;
  std::uint32_t select_ns_;
};

constexpr std::uint32_t bus_hz = 42'000'000;

class SpiBusTest : public testing::Test {
 protected:
  RegisterWorld world;
  FakePort port{world};
  FakeSpi spi{world, bus_hz};
  SpiBus bus{spi.block(), bus_hz};

  void TearDown() override {
    for (const std::string& violation : spi.violations) {
      ADD_FAILURE() << violation;
    }
  }
};

constexpr std::array out{std::byte{0x12}, std::byte{0x00}, std::byte{0xFF}};

TEST_F(SpiBusTest, SendsAndReceivesAtOnce) {
  Echo echo{0, 21'000'000};
  spi.attach(port, 4, echo);
  SpiDevice device{bus, Pin{port.block(), 4}, {.mode = SpiMode::mode_0, .most_hz = 24'000'000}};
  std::array<std::byte, 3> in{};
  ASSERT_TRUE(device.transfer(out, in));
  EXPECT_EQ(echo.frames, (std::vector<std::vector<std::uint8_t>>{{0x12, 0x00, 0xFF}}));
  EXPECT_EQ(in, (std::array{std::byte{0xED}, std::byte{0xFF}, std::byte{0x00}}));
  EXPECT_EQ(echo.released, 1);
}

TEST_F(SpiBusTest, SegmentsShareOneChipSelectAndTheShorterSideIsPadded) {
  Echo echo{0, 21'000'000};
  spi.attach(port, 4, echo);
  SpiDevice device{bus, Pin{port.block(), 4}, {.most_hz = 21'000'000}};
  std::array<std::byte, 2> in{};
  ASSERT_TRUE(device.transfer({{.out = out}, {.in = in}}));
  EXPECT_EQ(echo.frames, (std::vector<std::vector<std::uint8_t>>{{0x12, 0x00, 0xFF, 0x00, 0x00}}));
  EXPECT_EQ(in, (std::array{std::byte{0xFF}, std::byte{0xFF}}));
  EXPECT_EQ(echo.released, 1);
}

TEST_F(SpiBusTest, DevicesOfDifferentModesAndSpeedsShareABus) {
  Echo slow{1, 10'000'000, 350};
  Echo fast{3, 21'000'000};
  spi.attach(port, 4, slow);
  spi.attach(port, 15, fast);
  SpiDevice slow_device{bus, Pin{port.block(), 4}, {.mode = SpiMode::mode_1, .most_hz = 10'000'000, .select_ns = 350}};
  SpiDevice fast_device{bus, Pin{port.block(), 15}, {.mode = SpiMode::mode_3, .most_hz = 133'000'000}};
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(slow_device.transfer(out, {}));
    EXPECT_EQ(spi.clock_hz(), 5'250'000U);  // 42 MHz by 4 would be 10.5
    ASSERT_TRUE(fast_device.transfer(out, {}));
    EXPECT_EQ(spi.clock_hz(), 21'000'000U);
  }
  EXPECT_EQ(slow.frames.size(), 3U);
  EXPECT_EQ(fast.frames.size(), 3U);
}

TEST(SpiBus, TakesTheFastestClockThatIsNotAboveTheDevices) {
  struct Case {
    std::uint32_t bus_hz;
    std::uint32_t most_hz;
    std::uint32_t clock_hz;
  };
  registers::Spi block{};
  // RM0090 section 28.5.1: dividers of 2, 4, 8 ... 256. 16 MHz is what is left when the crystal fails.
  for (const Case& c : {Case{84'000'000, 24'000'000, 21'000'000}, Case{42'000'000, 24'000'000, 21'000'000},
                        Case{42'000'000, 10'000'000, 5'250'000}, Case{16'000'000, 24'000'000, 8'000'000},
                        Case{16'000'000, 10'000'000, 8'000'000}, Case{16'000'000, 4'000'000, 4'000'000},
                        Case{84'000'000, 3'999'999, 2'625'000}, Case{84'000'000, 1, 328'125}}) {
    EXPECT_EQ((SpiBus{block, c.bus_hz}.clock_hz({.most_hz = c.most_hz})), c.clock_hz) << c.bus_hz << " " << c.most_hz;
  }
}

TEST_F(SpiBusTest, ABlockThatStopsCostsABoundedTimeAndWorksAgainWhenItGoesOn) {
  Echo echo{0, 10'000'000};
  spi.attach(port, 4, echo);
  SpiDevice device{bus, Pin{port.block(), 4}, {.most_hz = 10'000'000}};
  ASSERT_TRUE(device.transfer(out, {}));
  spi.stop();
  const std::uint64_t before = spi.looks();
  EXPECT_FALSE(device.transfer(out, {}));
  // One look is at least one cycle of the 42 MHz bus, and of those a byte takes 64 at a divider of 8.
  EXPECT_LE(spi.looks() - before, 1000U);
  EXPECT_EQ(echo.released, 2);  // deselected all the same
  spi.violations.clear();       // to give up a byte that never ends is all that is left
  spi.go_on();
  std::array<std::byte, 3> in{};
  ASSERT_TRUE(device.transfer(out, in));
  EXPECT_EQ(in, (std::array{std::byte{0xED}, std::byte{0xFF}, std::byte{0x00}}));
}

TEST(SpiBus, WhereNoRegisterEverAnswersATransferFailsAndEnds) {
  RegisterWorld world;
  registers::Spi block{};
  registers::Gpio port{};
  world.on_read(block.sr, [] { return 0U; });
  SpiBus bus{block, bus_hz};
  SpiDevice device{bus, Pin{port, 4}, {.most_hz = 10'000'000}};
  EXPECT_FALSE(device.transfer(out, {}));
  EXPECT_FALSE(device.transfer(out, {}));
  EXPECT_LE(world.accesses(), 1000U);
}

TEST_F(SpiBusTest, InterruptsLongerThanSomeBytesLoseNothing) {
  Echo echo{0, 21'000'000};
  spi.attach(port, 4, echo);
  SpiDevice device{bus, Pin{port.block(), 4}, {.most_hz = 21'000'000}};
  for (const int looks : {1, 2, 3, 5, 50}) {
    spi.interrupt_for(looks);
    std::array<std::byte, 3> in{};
    std::array<std::byte, 2> more{};
    ASSERT_TRUE(device.transfer({{.out = out}, {.out = out, .in = in}, {.in = more}}));
    EXPECT_EQ(in, (std::array{std::byte{0xED}, std::byte{0xFF}, std::byte{0x00}})) << looks;
    EXPECT_EQ(more, (std::array{std::byte{0xFF}, std::byte{0xFF}})) << looks;
    EXPECT_EQ(echo.frames.back(), (std::vector<std::uint8_t>{0x12, 0x00, 0xFF, 0x12, 0x00, 0xFF, 0x00, 0x00})) << looks;
  }
}

TEST_F(SpiBusTest, WhatAnEarlierOverrunLeftBehindIsNotTakenForAnAnswer) {
  Echo echo{0, 21'000'000};
  spi.attach(port, 4, echo);
  Pin select{port.block(), 4};
  SpiDevice device{bus, select, {.most_hz = 21'000'000}};
  ASSERT_TRUE(device.transfer(out, {}));
  // Two bytes that nobody reads.
  select.low();
  spi.block().dr.write(1);
  spi.block().dr.write(2);
  while (spi.block().sr.any(registers::spi::busy)) {
  }
  ASSERT_TRUE(spi.block().sr.all(registers::spi::overrun | registers::spi::received));
  select.high();
  std::array<std::byte, 3> in{};
  ASSERT_TRUE(device.transfer(out, in));
  EXPECT_EQ(in, (std::array{std::byte{0xED}, std::byte{0xFF}, std::byte{0x00}}));
  EXPECT_FALSE(spi.block().sr.any(registers::spi::overrun));
}

}  // namespace
}  // namespace fantail::hal::stm32f4
