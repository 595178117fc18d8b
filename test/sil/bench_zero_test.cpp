// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "bench/zero.hpp"
#include "link/plan_transfer.hpp"
#include "sil/bench_at_world.hpp"
#include "text/degrees.hpp"

namespace fantail::sil {
namespace {

using bench::CanardZero;
using bench::Trusted;

std::vector<CanardZero> measure(BenchAtWorld& place) {
  link::AvionicsLink link{place.bus()};
  link::Session session = place.open_session(link);
  const bench::Bounds bounds = bench::bounds(link.newest<protocol::LimitReport>()->message, session.trims());
  std::vector<CanardZero> zeros;
  for (std::size_t canard = 0; canard < 4; ++canard) {
    const auto exercise = bench::Exercise::limits_of(bounds, canard);
    std::vector<bench::ZeroRun> runs;
    for (int run = 0; run < 3; ++run) {
      const auto recording = bench::perform(exercise, session, link, [](double) {});
      const auto reading = bench::zero_reading(bench::examine(recording, exercise, {}, {}), canard);
      EXPECT_TRUE(reading.run) << reading.refusal;
      runs.push_back(reading.run.value_or(bench::ZeroRun{}));
    }
    zeros.push_back(bench::combined(runs));
  }
  EXPECT_TRUE(session.close());
  return zeros;
}

core::FlightPlan with(core::FlightPlan plan, const std::vector<CanardZero>& zeros, Trusted trusted) {
  for (std::size_t i = 0; i < 4; ++i) {
    const bench::ZeroFields fields = bench::measured_fields(plan.canards.each[i], zeros[i], trusted);
    plan.canards.each[i].pulse_centre_us = static_cast<float>(fields.pulse_centre_us.value);
    plan.canards.each[i].pulse_per_radian_us = static_cast<float>(text::degrees(fields.pulse_per_degree_us.value));
    plan.canards.each[i].encoder_zero = core::Angle::from_degrees(static_cast<float>(fields.encoder_zero_deg.value));
  }
  return plan;
}

void send(BenchAtWorld& place, const core::FlightPlan& plan) {
  std::array<std::byte, protocol::plan_block_size> block{};
  (void)protocol::write_plan_block(plan, block);
  place.wait(3 * second);
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  ASSERT_EQ(link::send_plan(place, link, block, [](std::size_t) {}).state, protocol::TransferState::stored);
}

// The horn of canard 3 is 2.5 deg off; the encoder is on the shaft and sees it.
TEST(BenchZero, AnOffsetIsFoundAndGoneOnceItsPlanIsLoaded) {
  for (const Trusted trusted : {Trusted::encoder, Trusted::servo}) {
    BenchAtWorld place{"bench_canard3_wrong_trim"};
    const std::vector<CanardZero> before = measure(place);
    EXPECT_NEAR(text::degrees(before[2].centre_rad.value), 2.5, 0.6) << "and what servos off the shelf are off";
    send(place, with(place.scenario.plan, before, trusted));
    const std::vector<CanardZero> after = measure(place);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(text::degrees(after[i].centre_rad.value), 0.0, 0.03) << i;
      EXPECT_NEAR(after[i].scale.value, 1.0, 0.005) << i;
    }
    EXPECT_TRUE(place.limits().passed());
  }
}

}  // namespace
}  // namespace fantail::sil
