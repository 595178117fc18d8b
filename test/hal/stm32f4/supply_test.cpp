// SPDX-License-Identifier: MIT

#include "hal/stm32f4/supply.hpp"

#include "fake_adc.hpp"
#include "fake_supply.hpp"
#include "hal/stm32f4/battery.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeAdc;
using test::FakeSupply;
using test::RegisterWorld;

struct TheSupply : testing::Test {
  RegisterWorld world{};
  FakeSupply device{world};
  Supply supply{device.power, device.lines};

  bool low_after(std::uint32_t ticks) {
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      supply.update();
    }
    return supply.faults().has(BoardFault::supply_low);
  }
};

TEST_F(TheSupply, IsGoodAtItsNominalVoltageAndTheRestOfItsRegisterStaysAsItWas) {
  EXPECT_FALSE(low_after(3));
  EXPECT_EQ(device.power.cr.read(), 0x4000U | 7U << 5U | 1U << 4U);
}

TEST_F(TheSupply, IsLowBelowTheHighestLevelOfTheDetectorAndGoodASecondAfterItHasRisenAboveItsHysteresis) {
  EXPECT_FALSE(low_after(1));
  device.set_volts(3.05);
  EXPECT_FALSE(low_after(1));
  device.set_volts(3.01);
  EXPECT_TRUE(low_after(1));
  EXPECT_TRUE(low_after(5'000));
  device.set_volts(3.10);
  EXPECT_TRUE(low_after(5'000)) << "within the hysteresis";
  device.set_volts(3.20);
  EXPECT_TRUE(low_after(999));
  EXPECT_FALSE(low_after(1));
}

TEST_F(TheSupply, ADipBetweenTwoTicksIsToldForASecond) {
  EXPECT_FALSE(low_after(10));
  device.dip_to(2.95);
  EXPECT_TRUE(low_after(1));
  EXPECT_TRUE(low_after(999));
  EXPECT_FALSE(low_after(1));
}

TEST_F(TheSupply, EveryDipBeginsTheSecondAnew) {
  EXPECT_FALSE(low_after(1));
  device.dip_to(2.95);
  EXPECT_TRUE(low_after(800));
  device.dip_to(2.95);
  EXPECT_TRUE(low_after(1'000));
  EXPECT_FALSE(low_after(1));
}

TEST_F(TheSupply, NobodyIsInterrupted) {
  device.dip_to(2.9);
  EXPECT_EQ(RegisterWorld::peek(device.lines.emr), 0U);
  EXPECT_EQ(RegisterWorld::peek(device.lines.ftsr), 0U);
  EXPECT_EQ(RegisterWorld::peek(device.lines.imr), 1U << 16U);
}

TEST(ASupplyAtPowerUp, TheEdgeOfTheDetectorThatIsSwitchedOnIsNoDip) {
  RegisterWorld world;
  FakeSupply device{world};
  device.has_edge_when_switched_on = true;
  Supply supply{device.power, device.lines};
  supply.update();
  EXPECT_TRUE(supply.faults().none());
  supply.update();
  EXPECT_TRUE(supply.faults().none());
}

TEST(ASupplyAtPowerUp, ThatIsLowIsToldInTheFirstTick) {
  RegisterWorld world;
  FakeSupply device{world};
  device.set_volts(2.9);
  Supply supply{device.power, device.lines};
  supply.update();
  EXPECT_TRUE(supply.faults().has(BoardFault::supply_low));
}

using test::RegisterWorld;

struct TheBattery : testing::Test {
  RegisterWorld world{};
  FakeAdc converter{world};
  Battery battery{converter.registers, converter.common, {.channel = 12, .reference_mv = 3300, .divider = 11}};
  void tick() {
    battery.update();
    converter.pass(0.001);
  }
};

TEST_F(TheBattery, IsUnknownUntilTheTickAfterTheFirstConversion) {
  converter.volts[12] = 1.0;
  EXPECT_FALSE(battery.millivolts());
  tick();
  EXPECT_FALSE(battery.millivolts());
  tick();
  ASSERT_TRUE(battery.millivolts());
  EXPECT_FALSE(battery.failed());
}

TEST_F(TheBattery, IsElevenTimesThePinToWithinACount) {
  for (const double volts : {0.0, 0.6, 6.0, 7.4, 8.4, 12.6, 36.3}) {
    converter.volts[12] = volts / 11;
    tick();
    tick();
    ASSERT_TRUE(battery.millivolts());
    EXPECT_NEAR(*battery.millivolts(), volts * 1000, 3300.0 * 11 / 4095) << volts;
  }
}

TEST_F(TheBattery, AVoltageBeyondWhatTheBusCanSayIsTheMostItCanSay) {
  Battery high{converter.registers, converter.common, {.channel = 12, .reference_mv = 3300, .divider = 40}};
  converter.volts[12] = 3.3;
  high.update();
  converter.pass(0.001);
  high.update();
  EXPECT_EQ(high.millivolts(), 65'535);
}

TEST_F(TheBattery, TheConverterIsWithinItsClockAndSamplesForTheDivider) {
  EXPECT_LE(converter.clock_hz(), 36e6);  // data sheet, ADC characteristics
  EXPECT_EQ(converter.cycles(), 480);
}

TEST_F(TheBattery, AConversionIsDoneWithinATickAlsoWithTheSlowClock) {
  converter.bus_hz = 16e6;
  converter.volts[12] = 1.0;
  tick();
  tick();
  EXPECT_TRUE(battery.millivolts());
}

TEST_F(TheBattery, AConverterThatNeverEndsIsUnmeasuredAfterTenTicksAndNothingWaits) {
  converter.volts[12] = 1.0;
  tick();
  tick();
  converter.ends = false;
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(battery.failed());
    const std::uint64_t before = world.accesses();
    tick();
    EXPECT_LE(world.accesses() - before, 3U);
  }
  tick();
  EXPECT_TRUE(battery.failed());
  EXPECT_FALSE(battery.millivolts()) << "an old voltage is not the battery's";
}

TEST_F(TheBattery, AConverterThatAnswersAgainIsBelievedAgain) {
  converter.ends = false;
  for (int i = 0; i < 20; ++i) {
    tick();
  }
  ASSERT_TRUE(battery.failed());
  converter.ends = true;
  tick();
  tick();
  EXPECT_FALSE(battery.failed());
  EXPECT_TRUE(battery.millivolts());
}

}  // namespace

}  // namespace fantail::hal::stm32f4
