// SPDX-License-Identifier: MIT
#include "bench/watch.hpp"

#include "avionics/can_frame.hpp"
#include "hal/board.hpp"
#include "hal/sim/can_bus.hpp"
#include "json/value.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

using Json = json::Value;

class WatchTest : public testing::Test {
 protected:
  void hear(const protocol::BoardReport& report) {
    (void)board.send(avionics::can_frame(encode(protocol::StatusReport{})));
    (void)board.send(avionics::can_frame(encode(report)));
    link.listen(now);
    watch.look(now);
  }
  [[nodiscard]] bool table_says(std::string_view words) const { return watch.table().find(words) != std::string::npos; }

  static constexpr hal::Microseconds now{1'000'000};
  hal::sim::CanWire wire;
  hal::sim::CanBus board{wire};
  hal::sim::CanBus pc{wire};
  link::AvionicsLink link{pc};
  Watch watch{"vcan0", link, pc};
};

std::uint32_t bit(hal::BoardFault fault) { return 1U << static_cast<unsigned>(fault); }

TEST_F(WatchTest, EveryFaultOfTheBoardIsNamed) {
  hear({.faults = bit(hal::BoardFault::imu_silent) | bit(hal::BoardFault::flash_wrong_id),
        .reset_cause = static_cast<std::uint8_t>(hal::ResetCause::watchdog),
        .plan = protocol::PlanSource::stored,
        .battery_mv = std::uint16_t{7'912},
        .overruns = 3});
  EXPECT_TRUE(
      table_says("board: imu_silent, flash_wrong_id (prevents arming); reset by the watchdog, battery 7.91 V, "
                 "3 control ticks missed\nplan: the one in the flash\n"))
      << watch.table();
  EXPECT_NE(watch.line().find("board: imu_silent, flash_wrong_id;"), std::string::npos) << watch.line();
  const Json object = json::parse(watch.json());
  EXPECT_EQ(object["board_faults"], Json::array({"imu_silent", "flash_wrong_id"}));
  EXPECT_EQ(object["reset_cause"], "watchdog");
  EXPECT_EQ(object["battery_v"], 7.91);
  EXPECT_EQ(object["ticks_missed"], 3);
  EXPECT_EQ(object["plan"], "stored");
  EXPECT_EQ(object["flash_failed"], false);
}

TEST_F(WatchTest, ASoundBoardHasNoFault) {
  hear({});
  EXPECT_TRUE(table_says("board: no fault; reset by power-on, battery not measured, 0 control ticks missed\n"));
  EXPECT_EQ(watch.line().find("board:"), std::string::npos);
  const Json object = json::parse(watch.json());
  EXPECT_EQ(object["board_faults"], Json::array());
  EXPECT_EQ(object["battery_v"], nullptr);
}

// Neither is a fault of the board where the sensor is simulated, without the driver that looks for them.
TEST_F(WatchTest, ADeadImuAndASilentEncoderAreSeen) {
  watch.look(now);
  EXPECT_EQ(json::parse(watch.json())["gyro_state"], nullptr);
  (void)board.send(avionics::can_frame(
      encode(protocol::HealthReport{.gyro = core::SensorState::failed, .accelerometer = core::SensorState::fresh})));
  protocol::EncoderReport encoders;
  encoders.angle = {core::Angle{}, core::Angle{}, std::nullopt, core::Angle{}};
  (void)board.send(avionics::can_frame(encode(encoders, 0)));
  hear({});
  EXPECT_TRUE(table_says("gyro failed, accelerometer fresh\n")) << watch.table();
  EXPECT_TRUE(table_says("silent")) << watch.table();
  EXPECT_NE(watch.line().find("canard 3 command - deg, encoder silent"), std::string::npos) << watch.line();
  EXPECT_NE(watch.line().find("canard 4 command - deg, encoder +0.00"), std::string::npos) << watch.line();
  EXPECT_NE(watch.line().find("gyro failed, accelerometer fresh;"), std::string::npos) << watch.line();
  const Json object = json::parse(watch.json());
  EXPECT_EQ(object["gyro_state"], "failed");
  EXPECT_EQ(object["accelerometer_state"], "fresh");
}

TEST_F(WatchTest, TheAbortInputIsNamedAsItStands) {
  watch.look(now);
  EXPECT_EQ(json::parse(watch.json())["abort_input"], nullptr);
  using enum protocol::AbortState;
  for (const auto& [state, words, key] : {std::tuple{none_fitted, "none fitted", "none_fitted"},
                                          {ready, "ready", "ready"},
                                          {asks_to_abort, "asks to abort", "asks_to_abort"},
                                          {unsettled, "its contact chatters", "unsettled"}}) {
    (void)board.send(avionics::can_frame(encode(protocol::ArmReply{.abort_input = state})));
    hear({});
    EXPECT_TRUE(table_says(std::string{"abort input: "} + words + "\n")) << watch.table();
    EXPECT_NE(watch.line().find(std::string{"abort input: "} + words + ";"), std::string::npos) << watch.line();
    EXPECT_EQ(json::parse(watch.json())["abort_input"], key);
  }
}

TEST_F(WatchTest, CountersThatWrapHaveTheirModulusBesideThem) {
  hear({});
  const Json object = json::parse(watch.json());
  EXPECT_EQ(object["avionics_counters_modulo"], 256);
  EXPECT_EQ(object["uptime_modulo_s"], 16'777.216);
}

TEST_F(WatchTest, WhatTheBoardHasNotSaidIsNull) {
  watch.look(now);
  const Json object = json::parse(watch.json());
  for (const char* key : {"board_faults", "reset_cause", "battery_v", "ticks_missed", "plan", "flash_failed"}) {
    EXPECT_EQ(object[key], nullptr) << key;
  }
}

TEST_F(WatchTest, APlanFromANewerVersionSaysWhatToDo) {
  hear({.plan = protocol::PlanSource::stored_is_newer, .flash_failed = true});
  EXPECT_TRUE(
      table_says("from a newer version of the firmware; it will not be armed until that is flashed or a plan is sent"));
  EXPECT_TRUE(table_says("flash: does not answer"));
  EXPECT_EQ(json::parse(watch.json())["plan"], "stored_is_newer");
}

TEST(FaultNames, ABitThatOnlyNewerAvionicsKnowsIsShownByItsNumber) {
  EXPECT_EQ(fault_names(1U << 31U | 1U), (std::vector<std::string>{"crystal_failed", "bit_31"}));
}

}  // namespace
}  // namespace fantail::bench
