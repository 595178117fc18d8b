// SPDX-License-Identifier: MIT

#include "avionics/can_frame.hpp"
#include "bench/axes.hpp"
#include "bench/zero.hpp"
#include "core/flight_plan_members.hpp"
#include "degree.hpp"
#include "figures.hpp"
#include "link/plan_transfer.hpp"
#include "protocol/bus_codec.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"
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

// The whole way from hands that turn a rocket to the verdict. What a sensor can have wrong is in axes_verdict_test;
// here a person turns it wrong, and the rates are as a real gyro gives them.

bench::TurnsSeen turns_of(const std::function<void(sim::Scenario&)>& change) {
  sim::Scenario scenario = input::load_scenario("bench_axes", {});
  change(scenario);
  BenchAtWorld place{std::move(scenario)};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);
  return bench::watch_turns(place, link, [](const bench::AskedTurn&) {});
}

bench::AxesResult result_of(const std::function<void(sim::Scenario&)>& change) {
  return bench::judge_axes(turns_of(change));
}

void expect_said(const bench::AxesResult& result, const std::string& word) {
  EXPECT_FALSE(result.right);
  EXPECT_TRUE(says(result.sentences.at(0), word)) << bench::axes_text(result);
}

TEST(BenchAxes, RightSensorsPassAndSeeEachTurn) {
  const bench::AxesResult result = result_of([](sim::Scenario&) {});
  EXPECT_TRUE(result.right) << bench::axes_text(result);
  EXPECT_NEAR(result.roll_rad.x, 360.0 * degree, 1.0 * degree);
  EXPECT_NEAR(result.roll_rad.y, 0.0, 0.5 * degree);
  EXPECT_NEAR(result.tilts[0].gyro.y_rad, 90.0 * degree, 0.5 * degree);
  EXPECT_NEAR(result.tilts[0].gyro.z_rad, 0.0, 0.5 * degree);
  EXPECT_NEAR(result.tilts[1].gyro.z_rad, 90.0 * degree, 0.5 * degree);
  for (const auto& tilt : result.tilts[1].accelerometer) {
    ASSERT_TRUE(tilt);
    EXPECT_NEAR(tilt->z_rad, 90.0 * degree, 3.0 * degree);
  }
}

TEST(BenchAxes, APersonMayRollTheRocketWhileLayingItDown) {
  const bench::AxesResult result = result_of([](sim::Scenario& scenario) {
    scenario.hand_turns[1].angle_rad.x = 40.0 * degree;
    scenario.hand_turns[1].angle_rad.z = -30.0 * degree;
    scenario.hand_turns[2].angle_rad.x = -40.0 * degree;
    scenario.hand_turns[2].angle_rad.z = 30.0 * degree;
  });
  EXPECT_TRUE(result.right) << bench::axes_text(result);
}

TEST(BenchAxes, ARollToTheWrongSideIsCalledReversed) {
  expect_said(result_of([](sim::Scenario& s) { s.hand_turns[0].angle_rad.x = -360.0 * degree; }), "reversed");
}

TEST(BenchAxes, AWrongScaleIsNamedAndAUsualOneIsNot) {
  const auto with_error = [](double error) {
    return result_of([error](sim::Scenario& s) { s.vehicle.imu_feels.rate_scale_error = error; });
  };
  const bench::AxesResult wrong = with_error(0.07);
  expect_said(wrong, "scale about x");
  const std::vector<std::string> of_the_roll = figures(wrong.sentences.at(0));
  EXPECT_TRUE(of_the_roll.at(0) == "360" && of_the_roll.at(1).starts_with("38")) << wrong.sentences.at(0);
  EXPECT_TRUE(std::ranges::any_of(wrong.sentences, [](const std::string& sentence) {
    return says(sentence, "about z") && says(sentence, "IMU") && tells(sentence, {"107"});
  })) << bench::axes_text(wrong);
  EXPECT_TRUE(with_error(0.01).right);
}

TEST(BenchAxes, AnImuMountedOtherwiseThanThePlanBelievesIsNamedAndItsLinesMakeItRight) {
  using core::SensorAxis;
  const auto built_otherwise = [](sim::Scenario& s) {
    s.vehicle.imu.mounting = {.to_nose = SensorAxis::minus_y, .along_y = SensorAxis::plus_x};
  };
  const bench::TurnsSeen seen = turns_of(built_otherwise);
  expect_said(bench::judge_axes(seen), "swapped");
  const auto found = bench::mounting_of(seen, core::default_plan().sensors);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->imu.to_nose, SensorAxis::minus_y);
  const bench::AxesResult again = result_of([&](sim::Scenario& s) {
    built_otherwise(s);
    s.plan.sensors = *found;
  });
  EXPECT_TRUE(again.right) << bench::axes_text(again);
}

TEST(BenchAxes, ARocketThatNobodyTurnsIsNotJudged) {
  EXPECT_THROW((void)result_of([](sim::Scenario& scenario) { scenario.hand_turns.clear(); }), bench::NotTurned);
}

TEST(BenchAxes, ATurnBeyondTheGyrosRangeIsNotJudged) {
  try {
    (void)result_of([](sim::Scenario& s) { s.hand_turns[0].duration_s = 0.25; });
    FAIL() << "judged";
  } catch (const bench::NotTurned& error) {
    EXPECT_TRUE(says(error.what(), "faster")) << error.what();
  }
}

// Heartbeats of other versions of the bus protocol, as a bench hears them.

/// On the bus of a rocket, and what sends heartbeats of version 35 there.
class OtherVersion : public testing::Test {
 protected:
  void send_heartbeat(std::uint32_t uptime_ms) {
    (void)other.send(avionics::can_frame(encode(protocol::HeartbeatReport{.version = 35, .uptime_ms = uptime_ms})));
  }

  BenchAtWorld place{"bench_healthy"};
  hal::sim::CanBus other{place.wire};
  link::AvionicsLink link{place.bus()};
};

TEST_F(OtherVersion, OneFrameOfAnotherDeviceDoesNotMakeTheAvionicsOneOfAnotherVersion) {
  send_heartbeat(0);
  EXPECT_NO_THROW(link::await_avionics(place, link));
}

TEST_F(OtherVersion, AnAvionicsThatSaysNothingElseIsRefusedByItsVersion) {
  place.switch_off();
  place.after_tick = [this, uptime_ms = std::uint32_t{0}]() mutable {
    if (++uptime_ms % 100 == 0) {
      send_heartbeat(uptime_ms);
    }
  };
  try {
    link::await_avionics(place, link);
    FAIL() << "it was taken for one of ours";
  } catch (const link::LinkError& error) {
    EXPECT_EQ(figures(error.what()), (std::vector<std::string>{"35", "2"}));
  }
}

}  // namespace

}  // namespace fantail::sil
