// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/self_test.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::avionics::alone {

using core::Microseconds;
using protocol::SelfTestFailure;
using protocol::SelfTestState;

inline constexpr Microseconds tick_time{1'000};
inline constexpr Microseconds tested_from{1'000'000};
inline constexpr int still_ticks = 3'000;
inline constexpr int move_ticks = 400;

/// The self-test without a board around it, on a rocket that is sound but for what a test changes.
struct TestedRocket {
  core::FlightPlan plan = core::default_plan();
  SelfTest test{plan};
  core::Inputs inputs{.time = tested_from};
  core::TickRecord record;
  FlashFacts flash{.plan = protocol::PlanSource::built_in, .free_bytes = 100'000'000, .region_bytes = 100'000'000};
  bool board_faulty = false;
  std::function<void(TestedRocket&)> change = [](TestedRocket&) {};  ///< in every tick, before the test sees it

  explicit TestedRocket(std::function<void(TestedRocket&)> what = [](TestedRocket&) {}) : change{std::move(what)} {
    record.motion.gyro = core::SensorState::fresh;
    record.motion.at_rest_for = Microseconds{10'000'000};
    EXPECT_EQ(test.start({.time = inputs.time}, false), protocol::ArmRefusal::none);
  }
  void tick() {
    inputs.time += tick_time;
    record.time = inputs.time;
    record.motion.at_rest_for += tick_time;
    for (auto& sample : inputs.accelerometers) {
      sample = {.time = inputs.time,
                .specific_force_m_s2 = {.x = core::standard_gravity_m_s2},
                .quality = core::SampleQuality::valid};
    }
    const auto asked = test.canard_request();
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      record.encoders[i] = asked ? (*asked)[i] : plan.canards.each[i].trim;
    }
    change(*this);
    test.update(inputs, record, flash, board_faulty);
  }
  /// One tick at this time after the beginning, between which nothing was measured.
  void tick_at(Microseconds time) {
    inputs.time = tested_from + time - tick_time;
    tick();
  }
  TestedRocket& run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick();
    }
    return *this;
  }
  [[nodiscard]] Microseconds tested_for() const { return inputs.time - tested_from; }
  void expect(SelfTestFailure failure, std::optional<std::size_t> canard = {}) const {
    EXPECT_EQ(test.state(), failure == SelfTestFailure::none ? SelfTestState::passed : SelfTestState::failed);
    EXPECT_EQ(test.failure(), failure);
    EXPECT_EQ(test.canard(), canard);
    EXPECT_FALSE(test.canard_request());
  }
};

// With the still seconds, the centre and each of four canards out and back.
inline constexpr int whole_test = still_ticks + 9 * move_ticks;

}  // namespace fantail::avionics::alone
