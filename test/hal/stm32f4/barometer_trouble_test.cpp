// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include "avionics/tested_rocket.hpp"
#include "fake_ms5611.hpp"
#include "hal/stm32f4/barometer.hpp"
#include "sensor_rig.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeMs5611;

class BarometerTrouble : public test::SensorTest<FakeMs5611, 42'000'000> {
 protected:
  Barometer make() {
    Barometer barometer{place(ms5611::spi), clock};
    barometer.start(SensorStart::power_up);
    return barometer;
  }
  Barometer running() {
    Barometer barometer = make();
    EXPECT_LE(ticks_to_sample(barometer, 100), 28);
    return barometer;
  }
  void pass(Barometer& barometer, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      static_cast<void>(next(barometer));
    }
  }
  void expect_for(Barometer& barometer, int ticks, Status status) {
    for (int i = 0; i < ticks; ++i) {
      ASSERT_EQ(next(barometer).status, status) << i;
    }
  }
  void expect_good_for(Barometer& barometer, int ticks, double pressure_pa) {
    for (int i = 0; i < ticks; ++i) {
      const BarometerSample sample = next(barometer);
      ASSERT_EQ(sample.status, Status::ok) << i;
      ASSERT_NEAR(sample.pressure_pa, pressure_pa, 12.0) << i;
    }
  }
};

TEST_F(BarometerTrouble, WhereNoneIsFittedNothingIsReadForEver) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    device.stuck_at = level;
    Barometer barometer = make();
    spi.forget_traffic();
    expect_for(barometer, 2'000, Status::no_reading);
    EXPECT_NEAR(static_cast<double>(spi.bytes()), 100 * (1 + 8 * 6), 50) << "one search every 20 ms";
  }
}

TEST_F(BarometerTrouble, OneThatStopsAnsweringIsSilentWithinAConversionAndComesBack) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    for (const int ticks : {50, 2'000}) {
      Barometer barometer = running();
      device.stuck_at = level;
      pass(barometer, 5);
      expect_for(barometer, ticks, Status::no_reading);
      device.stuck_at.reset();
      EXPECT_LE(ticks_to_sample(barometer, 100), 46);
      expect_good_for(barometer, 50, 101'325.0);
    }
  }
}

TEST_F(BarometerTrouble, TheExampleOfTheMakersApplicationNoteHasTheRightCrc) {
  device.constants = {0x3132, 0x3334, 0x3536, 0x3738, 0x3940, 0x4142, 0x4344, 0x450B};  // AN520
  EXPECT_EQ(FakeMs5611::with_crc(device.constants), device.constants);
  Barometer barometer = make();
  pass(barometer, 20);
  EXPECT_GT(device.conversions, 0);
}

TEST_F(BarometerTrouble, EachWrongBitOfItsConstantsIsAnErrorUntilItIsRight) {
  const FakeMs5611::Constants good = device.constants;
  for (std::size_t bit = 0; bit < 128; ++bit) {
    if (bit >= 120 && bit < 124) {
      continue;  // they mean nothing
    }
    device.constants[bit / 16] = static_cast<std::uint16_t>(good[bit / 16] ^ 0x8000U >> bit % 16);
    Barometer barometer = make();
    pass(barometer, 15);
    expect_for(barometer, 30, Status::error);
    device.constants = good;
    EXPECT_LE(ticks_to_sample(barometer, 100), 46);
  }
}

TEST_F(BarometerTrouble, ALineThatSaysAnythingIsNeverTakenForConstants) {
  // Of random constants one in sixteen has the right CRC, and there are fifty searches in a second.
  std::mt19937 random{3};
  device.disturbance = [&](std::uint8_t) { return static_cast<std::uint8_t>(random()); };
  Barometer barometer = make();
  for (int i = 0; i < 60'000; ++i) {
    ASSERT_NE(next(barometer).status, Status::ok) << i;
  }
  EXPECT_EQ(barometer.read().status, Status::error);
  EXPECT_EQ(device.conversions, 0);
}

TEST_F(BarometerTrouble, WordsThatAreAllTheSameAreNoConstants) {
  for (std::uint32_t value = 0; value <= 0xFF; ++value) {
    device.stuck_at = static_cast<std::uint8_t>(value);
    Barometer barometer = make();
    pass(barometer, 30);
    ASSERT_EQ(barometer.read().status, value == 0x00 || value == 0xFF ? Status::no_reading : Status::error) << value;
  }
}

TEST_F(BarometerTrouble, OneThatResetsItselfIsFoundAndLoadsItsConstantsAgain) {
  for (int phase = 0; phase < 10; ++phase) {
    Barometer barometer = running();
    pass(barometer, phase);
    const int resets = device.resets;
    device.lose_power();
    for (int i = 0; i < 60; ++i) {
      const BarometerSample sample = next(barometer);
      ASSERT_TRUE(sample.status != Status::ok || std::abs(sample.pressure_pa - 101'325.0) < 12.0) << phase << ' ' << i;
    }
    EXPECT_EQ(device.resets, resets + 1) << phase;
    expect_good_for(barometer, 50, 101'325.0);
  }
}

TEST_F(BarometerTrouble, AResetThatDoesNotReachTheDeviceIsSentAgain) {
  Barometer barometer = running();
  device.lose_power();
  while (clock.time < Microseconds{1'000'000} && next(barometer).status == Status::ok) {
  }
  spi.stop();
  static_cast<void>(next(barometer));
  spi.go_on();
  spi.violations.clear();
  EXPECT_LE(ticks_to_sample(barometer, 100), 46);
  expect_good_for(barometer, 50, 101'325.0);
}

TEST_F(BarometerTrouble, ConversionsThatHaveNoResultAreNoReadingUntilTheyHave) {
  Barometer barometer = running();
  device.never_ready = true;
  pass(barometer, 10);
  expect_for(barometer, 500, Status::no_reading);
  device.never_ready = false;
  EXPECT_LE(ticks_to_sample(barometer, 100), 46);
}

TEST_F(BarometerTrouble, APressureOrATemperatureThatStandsStillForTwentyResultsIsAnErrorUntilItMoves) {
  for (const bool pressure : {true, false}) {
    Barometer barometer = running();
    pass(barometer, 100);
    (pressure ? device.pressure_frozen : device.temperature_frozen) = true;
    int ticks = 0;
    while (ticks < 1'000 && next(barometer).status == Status::ok) {
      ticks += 1;
    }
    EXPECT_EQ(ticks, pressure ? 199 : 204);
    const int resets = device.resets;
    expect_for(barometer, 2'000, Status::error);
    EXPECT_NEAR(device.resets, resets + 10, 1) << "and a reset does not make it better, though it is tried";
    device.pressure_frozen = device.temperature_frozen = false;
    const int to_be_believed = ticks_to_sample(barometer, 1'000);
    EXPECT_GE(to_be_believed, 80);
    EXPECT_LE(to_be_believed, 130);
  }
}

/// That the next result is equal, at most: the true value is in the middle of a count.
double probability_of_equal(double noise_counts) { return std::erf(0.5 / (noise_counts * std::sqrt(2.0))); }

TEST_F(BarometerTrouble, AFortiethOfTheNoiseOfTheDataSheetHoldsTheFalseAlarmsBelowOneInAThousandMillionHours) {
  const double results_in_an_hour = 2 * 360'000.0;
  const double noise_counts = 89.0 / 40;
  EXPECT_LT(results_in_an_hour * std::pow(probability_of_equal(noise_counts), Barometer::most_repeats), 1e-9);
  device.noise_counts = noise_counts;
  Barometer barometer = running();
  expect_good_for(barometer, 60'000, 101'325.0);
}

TEST_F(BarometerTrouble, WhatIsOutOfItsRangesIsAnErrorAndNoPressure) {
  for (const double pressure_pa : {990.0, 121'000.0}) {
    Barometer barometer = running();
    device.pressure_pa = pressure_pa;
    const int resets = device.resets;
    pass(barometer, 11);
    expect_for(barometer, 200, Status::error);
    EXPECT_GT(device.resets, resets + 5) << "its constants may be spoilt: they are read again";
    EXPECT_NEAR(barometer.read().pressure_pa, 101'325.0, 12.0);
    device.pressure_pa = 101'325.0;
    EXPECT_LE(ticks_to_sample(barometer, 100), 40);
  }
  for (const double temperature_c : {-41.0, 86.0}) {
    Barometer barometer = running();
    device.temperature_c = temperature_c;
    pass(barometer, 21);
    expect_for(barometer, 200, Status::error);
    device.temperature_c = 20.0;
  }
}

// What the driver cannot know is left to those who know how a rocket moves.

TEST_F(BarometerTrouble, LightOnItIsPassedOnAsPressure) {
  Barometer barometer = running();
  device.light_pa = -4'000.0;
  pass(barometer, 11);
  expect_good_for(barometer, 300, 97'325.0);
  device.light_pa = 0.0;
  pass(barometer, 11);
  expect_good_for(barometer, 300, 101'325.0);
}

TEST_F(BarometerTrouble, AnEjectionChargeIsPassedOnUpToTheEndOfTheRange) {
  Barometer barometer = running();
  device.pressure_pa = 115'000.0;
  pass(barometer, 11);
  expect_good_for(barometer, 20, 115'000.0);
  device.pressure_pa = 140'000.0;
  pass(barometer, 11);
  expect_for(barometer, 20, Status::error);
  device.pressure_pa = 70'000.0;
  EXPECT_LE(ticks_to_sample(barometer, 100), 40);
  expect_good_for(barometer, 50, 70'000.0);
}

TEST_F(BarometerTrouble, ABlockedPortIsNoFreeze) {
  Barometer barometer = running();
  device.blocked_at_pa = 101'325.0;
  device.pressure_pa = 60'000.0;
  expect_good_for(barometer, 10'000, 101'325.0);
}

TEST_F(BarometerTrouble, AnMs5607ReadsHalf) {
  device.is_ms5607 = true;
  Barometer barometer = running();
  expect_good_for(barometer, 100, 101'325.0 / 2);
}

// With the constants of the MS5607's data sheet, which are 110 002 Pa at 20 degrees with D1 = 6465444: the thickest air
// that was ever measured, and thin and cold air at 4 000 m.
TEST_F(BarometerTrouble, AnMs5607IsFoundByTheSelfTestInAnyWeatherAndAnMs5611PassesIt) {
  for (const auto& [pressure_pa, temperature_c] :
       {std::pair{108'400.0, 40.0}, {108'400.0, -38.0}, {101'325.0, 20.0}, {58'500.0, -30.0}}) {
    for (const bool is_ms5607 : {true, false}) {
      device.constants = is_ms5607 ? FakeMs5611::with_crc({0, 46372, 43981, 29059, 27842, 31553, 28165, 0})
                                   : FakeMs5611{clock}.constants;
      device.is_ms5607 = is_ms5607;
      device.pressure_pa = pressure_pa;
      device.temperature_c = temperature_c;
      Barometer barometer = running();
      Microseconds last{};
      avionics::alone::TestedRocket rocket{[&](avionics::alone::TestedRocket& r) {
        const BarometerSample sample = next(barometer);
        r.record.barometer_state = core::BarometerState::on_pad;
        r.inputs.barometer.reset();
        if (sample.status == Status::ok && sample.time > last) {
          last = sample.time;
          r.inputs.barometer = {.time = r.inputs.time, .pressure_pa = static_cast<float>(sample.pressure_pa)};
        }
      }};
      rocket.run(avionics::alone::whole_test)
          .expect(is_ms5607 ? protocol::SelfTestFailure::barometer_failed : protocol::SelfTestFailure::none);
    }
  }
}

}  // namespace
}  // namespace fantail::hal::stm32f4
