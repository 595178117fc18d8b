// SPDX-License-Identifier: MIT
#include "hal/stm32f4/barometer.hpp"

#include <cmath>

#include "fake_ms5611.hpp"
#include "sensor_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeMs5611;

class BarometerTest : public test::SensorTest<FakeMs5611, 42'000'000> {
 protected:
  Barometer make(SensorStart how = SensorStart::power_up) {
    Barometer barometer{place(ms5611::spi), clock};
    barometer.start(how);
    return barometer;
  }
  Barometer running() {
    Barometer barometer = make();
    EXPECT_LE(ticks_to_sample(barometer, 100), 28);
    return barometer;
  }
  std::uint32_t first_pressure_pa() {
    Barometer barometer = running();
    return barometer.read().pressure_pa;
  }
};

TEST_F(BarometerTest, MakesTheDataSheetsPressureOfTheDataSheetsExample) {
  device.pressure_result = 9'085'466;
  device.temperature_result = 8'569'150;
  EXPECT_EQ(first_pressure_pa(), 100'009U);
}

TEST_F(BarometerTest, CompensatesTheColdAsOthersDo) {
  // Betaflight's tests of its driver: 2.05 and -27.10 degrees C.
  device.pressure_result = 9'085'466;
  device.temperature_result = 8'069'150;
  EXPECT_EQ(first_pressure_pa(), 96'512U);
  device.temperature_result = 7'369'150;
  EXPECT_EQ(first_pressure_pa(), 90'613U);
}

TEST_F(BarometerTest, MeasuresWithinAPascalInTheWholeOfItsRanges) {
  device.noise_counts = 0.0;
  for (const double temperature_c : {-39.5, -30.0, -15.0, 0.0, 19.9, 20.1, 45.0, 84.5}) {
    for (const double pressure_pa : {1'002.0, 30'000.0, 101'325.0, 119'998.0}) {
      device.temperature_c = temperature_c;
      device.pressure_pa = pressure_pa;
      EXPECT_NEAR(first_pressure_pa(), pressure_pa, 1.5) << temperature_c;
    }
  }
}

TEST_F(BarometerTest, MeasuresWithConstantsOfAnotherDevice) {
  device.constants = FakeMs5611::with_crc({0x8000, 0xB7BD, 0xBA8C, 0x7685, 0x6C88, 0x8876, 0x7340, 0x45F0});
  device.temperature_c = -5.0;
  EXPECT_NEAR(first_pressure_pa(), 101'325.0, 15.0);
}

TEST_F(BarometerTest, SaysNoReadingUntilItHasSettled) {
  Barometer barometer = make();
  EXPECT_EQ(barometer.read().status, Status::no_reading);
  // 3 ms of reset, eight words, of which the first comes with the end of the reset, and three conversions of 5 ms.
  EXPECT_EQ(ticks_to_sample(barometer, 100), 25);
  EXPECT_NEAR(barometer.read().pressure_pa, 101'325.0, 10.0) << "the first conversion after a reset is wrong";
  EXPECT_EQ(spi.clock_hz(), 5'250'000U);
}

TEST_F(BarometerTest, HasANewSampleEveryTenMillisecondsAndTheOldOneWithItsTimeBetween) {
  Barometer barometer = running();
  for (int i = 0; i < 100; ++i) {
    const BarometerSample fresh = barometer.read();
    // It was found in this tick, 5 ms after its conversion began, which on average takes 4.13 ms.
    EXPECT_EQ(fresh.time, clock.time - Microseconds{5'000} + Microseconds{2'065});
    EXPECT_EQ(fresh.status, Status::ok);
    for (int old = 0; old < 9; ++old) {
      EXPECT_EQ(next(barometer).time, fresh.time);
    }
    EXPECT_GT(next(barometer).time, fresh.time);
  }
}

TEST_F(BarometerTest, ASampleThatIsFetchedLateKeepsTheTimeOfItsMeasurement) {
  Barometer barometer = running();
  for (int i = 0; i < 7; ++i) {
    static_cast<void>(next(barometer));
  }
  const Microseconds begun = clock.time - Microseconds{2'000};
  clock.time += Microseconds{45'000};
  EXPECT_EQ(barometer.read().time, begun + Microseconds{2'065});
}

TEST_F(BarometerTest, ItsNoiseIsThatOfTheDataSheet) {
  Barometer barometer = running();
  double sum = 0.0, squares = 0.0;
  constexpr int samples = 2'000;
  for (int i = 0; i < 10 * samples; ++i) {
    const double off = static_cast<double>(next(barometer).pressure_pa) - 101'325.0;
    sum += off;
    squares += off * off;
  }
  EXPECT_NEAR(sum / (10 * samples), 0.0, 0.7);  // it rounds down
  EXPECT_NEAR(std::sqrt(squares / (10 * samples)), 1.8, 0.3);
}

TEST_F(BarometerTest, IsStartedInFlightAsAtPowerUpEvenInTheMiddleOfAConversion) {
  for (int ticks = 0; ticks < 12; ++ticks) {
    Barometer before = running();
    for (int i = 0; i < ticks; ++i) {
      static_cast<void>(next(before));
    }
    Barometer after = make(SensorStart::in_flight);
    EXPECT_LE(ticks_to_sample(after, 100), 26);
    EXPECT_NEAR(after.read().pressure_pa, 101'325.0, 10.0);
  }
}

TEST_F(BarometerTest, NoTickHasMoreThanSevenBytesHoweverTheDeviceBehaves) {
  Barometer barometer = make();
  std::uint64_t most = 0, sum = 0;
  for (int i = 0; i < 3'000; ++i) {
    device.stuck_at = i % 700 > 500 ? std::optional<std::uint8_t>{0x00} : std::nullopt;
    spi.forget_traffic();
    static_cast<void>(next(barometer));
    most = std::max(most, spi.bytes());
    sum += i < 500 ? spi.bytes() : 0;
  }
  EXPECT_EQ(most, 7U) << "a word twice, and behind the last one the first conversion";
  EXPECT_NEAR(static_cast<double>(sum) / 500, 1.0, 0.15) << "a command, a result and the next command, every 5 ms";
}

TEST_F(BarometerTest, ABusThatStopsIsNoReadingUntilItGoesOn) {
  Barometer barometer = running();
  spi.stop();
  for (int i = 0; i < 100; ++i) {
    static_cast<void>(next(barometer));
  }
  EXPECT_EQ(barometer.read().status, Status::no_reading);
  spi.violations.clear();
  spi.go_on();
  EXPECT_LE(ticks_to_sample(barometer, 100), 46);
  spi.violations.clear();
}

}  // namespace
}  // namespace fantail::hal::stm32f4
