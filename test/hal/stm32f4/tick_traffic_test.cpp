// SPDX-License-Identifier: MIT

#include "fake_as5047p.hpp"
#include "fake_capture.hpp"
#include "fake_icm42688.hpp"
#include "fake_ism330dhcx.hpp"
#include "fake_kx134.hpp"
#include "fake_ms5611.hpp"
#include "fake_w25q.hpp"
#include "hal/stm32f4/accelerometer.hpp"
#include "hal/stm32f4/as5047p.hpp"
#include "hal/stm32f4/barometer.hpp"
#include "hal/stm32f4/encoder.hpp"
#include "hal/stm32f4/flash.hpp"
#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/imu.hpp"
#include "hal/stm32f4/ism330dhcx.hpp"
#include "hal/stm32f4/kx134.hpp"
#include "hal/stm32f4/second_imu.hpp"
#include "hal/stm32f4/w25q.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeAs5047p;
using test::FakeCapture;
using test::FakeClock;
using test::FakeIcm42688;
using test::FakeIsm330dhcx;
using test::FakeKx134;
using test::FakeMs5611;
using test::FakePort;
using test::FakeSpi;
using test::FakeW25q;
using test::RegisterWorld;

/// All devices on the buses they have on the board, at its clocks.
class TickTraffic : public testing::Test {
 protected:
  static constexpr std::uint32_t apb1_hz = 42'000'000;
  static constexpr std::uint32_t apb2_hz = 84'000'000;

  RegisterWorld world;
  FakeClock clock;
  FakePort port_a{world};
  FakePort port_b{world};
  FakePort port_c{world};
  FakeSpi spi_1{world, apb2_hz};
  FakeSpi spi_2{world, apb1_hz};
  FakeSpi spi_3{world, apb1_hz};
  SpiBus bus_1{spi_1.block(), apb2_hz};
  SpiBus bus_2{spi_2.block(), apb1_hz};
  SpiBus bus_3{spi_3.block(), apb1_hz};
  FakeIcm42688 fake_imu{clock};
  std::array<FakeAs5047p, canards> fake_encoders{};
  FakeIsm330dhcx fake_second_imu{clock};
  FakeKx134 fake_accelerometer{clock};
  FakeMs5611 fake_barometer{clock};
  FakeW25q fake_flash{clock};

  FakeCapture capture{world, clock, 84e6, [this] { return fake_imu.interrupt_1(); }};

  Imu imu{SpiDevice{bus_1, Pin{port_a.block(), 4}, icm42688::spi}, clock, EdgeTimer{capture.registers, 84'000'000}};
  Encoder encoder{
      {SpiDevice{bus_2, Pin{port_b.block(), 12}, as5047p::spi}, SpiDevice{bus_2, Pin{port_b.block(), 0}, as5047p::spi},
       SpiDevice{bus_2, Pin{port_b.block(), 1}, as5047p::spi}, SpiDevice{bus_2, Pin{port_c.block(), 5}, as5047p::spi}},
      clock};
  SecondImu second_imu{SpiDevice{bus_3, Pin{port_b.block(), 11}, ism330dhcx::spi}, clock};
  Accelerometer accelerometer{SpiDevice{bus_3, Pin{port_c.block(), 4}, kx134::spi}, clock};
  Barometer barometer{SpiDevice{bus_3, Pin{port_b.block(), 10}, ms5611::spi}, clock};
  Flash flash{SpiDevice{bus_3, Pin{port_a.block(), 15}, w25q::spi}, clock};

  void SetUp() override {
    spi_1.attach(port_a, 4, fake_imu);
    spi_2.attach(port_b, 12, fake_encoders[0]);
    spi_2.attach(port_b, 0, fake_encoders[1]);
    spi_2.attach(port_b, 1, fake_encoders[2]);
    spi_2.attach(port_c, 5, fake_encoders[3]);
    spi_3.attach(port_c, 4, fake_accelerometer);
    spi_3.attach(port_a, 15, fake_flash);
    spi_3.attach(port_b, 11, fake_second_imu);
    spi_3.attach(port_b, 10, fake_barometer);
    flash.start();
    imu.start(SensorStart::in_flight);
    for (int i = 0; i < 100; ++i) {
      read_sensors();
    }
  }
  void TearDown() override {
    for (const auto& violations :
         {spi_1.violations, spi_2.violations, spi_3.violations, fake_imu.violations, fake_second_imu.violations,
          fake_accelerometer.violations, fake_barometer.violations}) {
      for (const std::string& violation : violations) {
        ADD_FAILURE() << violation;
      }
    }
  }
  void read_sensors() {
    clock.time += Microseconds{1'000};
    ASSERT_NE(imu.read().status, Status::error);
    ASSERT_NE(accelerometer.read().status, Status::error);
    ASSERT_NE(encoder.read().each[0].status, Status::error);
  }
  void forget_traffic() {
    spi_1.forget_traffic();
    spi_2.forget_traffic();
    spi_3.forget_traffic();
  }
};

TEST_F(TickTraffic, TheSensorsTakeFortyFiveMicrosecondsOfWire) {
  forget_traffic();
  read_sensors();
  // IMU: a burst of 17 registers behind its address, twelve of them again, and the id.
  EXPECT_EQ(spi_1.bytes(), 1U + 17U + 1U + 12U + 2U);
  EXPECT_NEAR(spi_1.wire_us(), 33 * 8 / 21.0, 1e-9);
  // Four frames of two bytes.
  EXPECT_EQ(spi_2.bytes(), 4U * 2U);
  EXPECT_NEAR(spi_2.wire_us(), 8 * 8 / 5.25, 1e-9);
  // Accelerometer: five registers from the id to the flag, and three axes.
  EXPECT_EQ(spi_3.bytes(), 1U + 5U + 1U + 6U);
  EXPECT_NEAR(spi_3.wire_us(), 13 * 8 / 5.25, 1e-9);
  EXPECT_LE(spi_1.wire_us() + spi_2.wire_us() + spi_3.wire_us(), 45.0);
}

TEST_F(TickTraffic, ASecondImuTakesThirtyMicrosecondsMoreAndDisturbsNobodyOnItsBus) {
  second_imu.start(SensorStart::in_flight);
  for (int i = 0; i < 200; ++i) {
    read_sensors();
    ASSERT_NE(second_imu.read().status, Status::error);
  }
  forget_traffic();
  EXPECT_EQ(second_imu.read().status, Status::ok);
  // Status, temperature and six axes behind their address, and the id.
  EXPECT_EQ(spi_3.bytes(), 1U + 16U + 2U);
  EXPECT_NEAR(spi_3.wire_us(), 19 * 8 / 5.25, 1e-9);
}

TEST_F(TickTraffic, ABarometerTakesAtMostElevenMicrosecondsMoreAndDisturbsNobodyOnItsBus) {
  second_imu.start(SensorStart::in_flight);
  barometer.start(SensorStart::power_up);
  double most_us = 0.0;
  BarometerSample sample{};
  for (int i = 0; i < 200; ++i) {
    read_sensors();
    ASSERT_NE(second_imu.read().status, Status::error);
    forget_traffic();
    sample = barometer.read();
    most_us = std::max(most_us, spi_3.wire_us());
  }
  EXPECT_EQ(sample.status, Status::ok);
  EXPECT_EQ(second_imu.read().status, Status::ok);
  // The last constant, twice, and the command of the first conversion.
  EXPECT_NEAR(most_us, 7 * 8 / 5.25, 1e-9);
}

TEST_F(TickTraffic, WithAPageProgramOneTickHasLessThanHalfOfItsThreeHundredMicrosecondsOnTheWire) {
  forget_traffic();
  read_sensors();
  const std::array<std::byte, 256> page{};
  ASSERT_EQ(flash.program(0, page), FlashResult::ok);
  // Status, write enable, status again, instruction and address, the page.
  constexpr std::uint64_t program = 2 + 1 + 2 + 4 + 256;
  EXPECT_EQ(spi_3.bytes(), 13U + program);
  EXPECT_NEAR(spi_3.wire_us(), 13 * 8 / 5.25 + program * 8 / 21.0, 1e-9);
  EXPECT_LE(spi_1.wire_us() + spi_2.wire_us() + spi_3.wire_us(), 146.0);
}

TEST_F(TickTraffic, AReadOf256BytesCostsNoMoreThanAPageProgram) {
  forget_traffic();
  std::array<std::byte, 256> page{};
  ASSERT_EQ(flash.read(0, page), FlashResult::ok);
  EXPECT_EQ(spi_3.bytes(), 2U + 4U + 256U);
}

TEST_F(TickTraffic, WhereEveryBusStopsATickStillEndsSoon) {
  for (int i = 0; i < 3; ++i) {
    spi_1.stop();
    spi_2.stop();
    spi_3.stop();
    const std::uint64_t before = world.accesses();
    read_sensors();
    std::array<std::byte, 256> page{};
    EXPECT_EQ(flash.program(0, page), FlashResult::failed);
    // Each is a few cycles of a bus at 42 or 84 MHz.
    EXPECT_LE(world.accesses() - before, 3000U);
  }
  spi_1.violations.clear();
  spi_2.violations.clear();
  spi_3.violations.clear();
}

}  // namespace
}  // namespace fantail::hal::stm32f4
