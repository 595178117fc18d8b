// SPDX-License-Identifier: MIT
#include "hal/stm32f4/supply.hpp"

#include <gtest/gtest.h>

#include "fake_supply.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

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

}  // namespace
}  // namespace fantail::hal::stm32f4
