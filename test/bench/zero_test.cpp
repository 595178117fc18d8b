// SPDX-License-Identifier: MIT
#include "bench/zero.hpp"

#include "seed.hpp"
#include "synthetic.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

ZeroReading reading_of(Bench& bench, std::size_t canard, const Bounds& bounds = six_degrees()) {
  const Exercise exercise = Exercise::limits_of(bounds, canard);
  return zero_reading(examine(bench.record(exercise), exercise, {}, {}), canard);
}

/// Three runs, as the verb does it.
CanardZero measured(Bench bench, std::size_t canard, const Bounds& bounds = six_degrees()) {
  std::vector<ZeroRun> runs;
  for (int i = 0; i < 3; ++i) {
    bench.seed += 1;
    const ZeroReading reading = reading_of(bench, canard, bounds);
    EXPECT_TRUE(reading.run) << reading.refusal;
    runs.push_back(reading.run.value_or(ZeroRun{}));
  }
  return combined(runs);
}

TEST(Zero, CentreAndScaleAreThoseOfTheLineThatWasPutIn) {
  for (const double trim_deg : {0.0, -2.0, 3.0}) {
    Bench bench;
    bench.canards[1].noise_rad = 0.022 * degree;
    bench.canards[1].gain = 1.08;
    bench.canards[1].offset_rad = -1.7 * degree;
    bench.canards[1].play_rad = 0.2 * degree;
    const CanardZero zero = measured(bench, 1, six_degrees(6.0, trim_deg));
    EXPECT_NEAR(zero.centre_rad.value / degree, -1.7, 0.02) << trim_deg;
    EXPECT_NEAR(zero.scale.value, 1.08, 0.003);
    EXPECT_NEAR(zero.play_rad / degree, 1.08 * 0.2, 0.02);
  }
}

// Counted over random canards; a 95 % interval may miss one in twenty.
TEST(Zero, TheIntervalsHoldTheTruthAsOftenAsTheySay) {
  core::RandomStream random{test::seed(20260105)};
  constexpr int all = 60;
  int centre_held = 0;
  int scale_held = 0;
  for (int i = 0; i < all; ++i) {
    Bench bench;
    bench.seed = static_cast<std::uint32_t>(1 + 10 * i);
    const double gain = 0.9 + 0.2 * random.unit();
    const double offset_deg = 4.0 * random.unit() - 2.0;
    bench.canards[2].gain = gain;
    bench.canards[2].offset_rad = offset_deg * degree;
    bench.canards[2].play_rad = 0.3 * random.unit() * degree;
    bench.canards[2].noise_rad = (0.01 + 0.05 * random.unit()) * degree;
    bench.canards[2].lag_s = 0.01 + 0.015 * random.unit();
    const CanardZero zero = measured(bench, 2);
    centre_held += std::abs(zero.centre_rad.value / degree - offset_deg) <= zero.centre_rad.plus_minus / degree ? 1 : 0;
    scale_held += std::abs(zero.scale.value - gain) <= zero.scale.plus_minus ? 1 : 0;
    EXPECT_LT(zero.centre_rad.plus_minus / degree, 0.1);
    EXPECT_LT(zero.scale.plus_minus, 0.02);
  }
  std::printf("of %d canards, the centre was held %d times and the scale %d times\n", all, centre_held, scale_held);
  EXPECT_GE(centre_held, all * 9 / 10);
  EXPECT_GE(scale_held, all * 9 / 10);
}

std::string refusal(const IdealCanard& canard) {
  Bench bench;
  bench.canards[1] = canard;
  const ZeroReading reading = reading_of(bench, 1);
  EXPECT_FALSE(reading.run);
  return reading.refusal;
}

bool begins(const std::string& text, const std::string& with) { return text.starts_with(with); }

TEST(Zero, ACanardThatDidNotMoveIsRefused) {
  EXPECT_PRED2(begins, refusal({.gain = 0.0, .offset_rad = 0.3 * degree, .noise_rad = 0.022 * degree}),
               "Canard 2 is not measured: it did not move: its encoder stays at 0.30 deg.");
}

TEST(Zero, AnEncoderThatIsStuckIsRefused) {
  EXPECT_PRED2(begins, refusal({.gain = 0.0, .offset_rad = 0.3 * degree}),
               "Canard 2 is not measured: its encoder reads 0.30 deg for every command, without any scatter");
}

TEST(Zero, AReversedOneIsRefused) {
  EXPECT_PRED2(begins, refusal({.gain = -1.0, .noise_rad = 0.022 * degree}),
               "Canard 2 is not measured: its encoder moves against the command.");
}

TEST(Zero, OneThatSlipsIsNoScale) {
  EXPECT_PRED2(begins, refusal({.gain = 0.66, .noise_rad = 0.022 * degree}),
               "Canard 2 is not measured: it moves 0.6603 deg for each degree commanded");
}

TEST(Zero, AnUnpluggedEncoderIsRefused) {
  EXPECT_PRED2(begins, refusal({.dropout_share = 1.0}), "Canard 2 is not measured: its encoder gives no valid reading");
}

TEST(Zero, AnotherCanardThatMovesIsRefused) {
  Bench bench;
  bench.canards[1].answers_to = 2;
  bench.canards[2].answers_to = 1;
  const ZeroReading reading = reading_of(bench, 1);
  EXPECT_FALSE(reading.run) << "swapped plugs";
  EXPECT_PRED2(begins, reading.refusal, "Canard 2 is not measured: ");
}

core::CanardPlan usual() {
  core::CanardPlan canard = core::default_plan().canards.each[0];
  canard.encoder_zero = core::Angle::from_degrees(179.5F);
  return canard;
}

// With 10 us a degree: what stands 2 deg too far and moves 5 % too much needs a pulse that is that much smaller.
TEST(Zero, TheFieldsAreThoseThatMakeTheEncoderReadTheCommand) {
  const CanardZero zero{.centre_rad = {2.0 * degree, 0.1 * degree}, .scale = {1.05, 0.01}, .play_rad = 0.0};
  const ZeroFields by_encoder = measured_fields(usual(), zero, Trusted::encoder);
  EXPECT_NEAR(by_encoder.pulse_per_degree_us.value, 10.0 / 1.05, 1e-5);
  EXPECT_NEAR(by_encoder.pulse_per_degree_us.plus_minus, 0.1 / 1.05 / 1.05, 1e-5);
  EXPECT_NEAR(by_encoder.pulse_centre_us.value, 1500.0 - 20.0 / 1.05, 1e-4);
  EXPECT_NEAR(by_encoder.pulse_centre_us.plus_minus, 1.0 / 1.05, 1e-5);
  EXPECT_NEAR(by_encoder.encoder_zero_deg.value, 179.5, 1e-4);
  EXPECT_EQ(by_encoder.encoder_zero_deg.plus_minus, 0.0);
  const ZeroFields by_servo = measured_fields(usual(), zero, Trusted::servo);
  EXPECT_EQ(by_servo.pulse_centre_us.value, 1500.0);
  EXPECT_NEAR(by_servo.encoder_zero_deg.value, -178.5, 1e-4) << "179.5 + 2, once round";
}

TEST(Zero, TheTextSaysWhatAnEncoderCannotShow) {
  const std::vector<CanardZero> zeros(4, {.centre_rad = {2.0 * degree, 0.1 * degree}, .scale = {1.05, 0.01}});
  const std::string text = zero_text(zeros, core::default_plan().canards, Trusted::encoder);
  EXPECT_NE(
      text.find("canard 4: encoder at command zero 2.00 +- 0.10 deg, per degree commanded 1.0500 +- 0.0100, play"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("  pulse_centre_us           1500.0   1481.0 +- 1.0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  encoder_zero_deg            0.00   unchanged\n"), std::string::npos) << text;
  EXPECT_NE(text.find(what_an_encoder_cannot_show()), std::string::npos);
}

}  // namespace
}  // namespace fantail::bench
