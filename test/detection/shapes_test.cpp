// SPDX-License-Identifier: MIT
#include "detection/shapes.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "core/launch_detector.hpp"
#include "seed.hpp"

namespace fantail::detection {
namespace {

constexpr float one_g = core::standard_gravity_m_s2;

core::LaunchDetectionPlan raw_rule(float threshold_g, int hold_ms) {
  core::LaunchDetectionPlan plan = core::default_plan().launch_detection;
  plan.threshold_m_s2 = threshold_g * one_g;
  plan.hold = core::Microseconds{hold_ms * 1'000};
  plan.accelerometers = core::AccelerometerRule::one;
  plan.low_pass = false;
  return plan;
}

/// At which step, if ever.
std::optional<std::size_t> detected(const core::LaunchDetectionPlan& plan, const std::vector<float>& axial_m_s2) {
  core::LaunchDetector detector{plan, core::Microseconds{5'000}};
  for (std::size_t i = 0; i < axial_m_s2.size(); ++i) {
    const core::Microseconds time{static_cast<std::int64_t>(i) * 1'000};
    const core::AccelerometerSample sample{
        .time = time, .specific_force_m_s2 = {axial_m_s2[i], 0.0F, 0.0F}, .quality = core::SampleQuality::valid};
    if (detector.update(time, {sample, sample}) == core::DetectionState::detected) {
      return i;
    }
  }
  return std::nullopt;
}

TEST(Shapes, AHalfSineIsAsHighAsTheFormulaAtEveryStep) {
  std::vector<float> values(100, 0.0F);
  add_half_sine(values, 0.0105, 0.04, 50.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = 1e-3 * static_cast<double>(i) - 0.0105;
    const double expected = t >= 0.0 && t <= 0.04 ? 50.0 * std::sin(std::numbers::pi * t / 0.04) : 0.0;
    EXPECT_NEAR(values[i], expected, 1e-4) << i;
  }
}

// On a rocket that reads 1 g it is above the threshold from asin(s) / pi of its width to as much before its end, with
// s = (threshold - 1 g) / peak.
TEST(Shapes, AShockFiresExactlyWhenItsClosedFormTimeAboveTheThresholdReachesTheHold) {
  int fired = 0;
  int all = 0;
  for (int width_ms = 20; width_ms <= 400; width_ms += 7) {
    for (const double peak_g : {0.9, 1.6, 2.0, 4.0, 9.0}) {
      std::vector<float> values(600, one_g);
      const double width = 1e-3 * width_ms;
      add_half_sine(values, 0.05, width, peak_g * 9.80665);
      const double sine = 1.5 / peak_g;
      const double margin = sine < 1.0 ? std::asin(sine) / std::numbers::pi * width : 0.5 * width;
      // Of the steps within that time the first and the last; both lie on the grid of milliseconds.
      const double first = std::ceil((0.05 + margin) / step_s - 1e-6);
      const double last = std::floor((0.05 + width - margin) / step_s + 1e-6);
      const bool expected = sine < 1.0 && last - first >= 100.0;
      ++all;
      fired += expected ? 1 : 0;
      EXPECT_EQ(detected(raw_rule(2.5F, 100), values).has_value(), expected)
          << peak_g << " g for " << width_ms << " ms";
    }
  }
  EXPECT_GT(fired, 50);
  EXPECT_GT(all - fired, 50);
}

TEST(Shapes, AConstantThreeGIsDetectedOneHoldAfterItsFirstSample) {
  std::vector<float> values(400, one_g);
  std::fill(values.begin() + 100, values.end(), 3.0F * one_g);
  EXPECT_EQ(detected(raw_rule(2.0F, 200), values), 300U);
  EXPECT_EQ(detected(raw_rule(2.5F, 100), values), 200U);
}

// A first-order lag rises from 1 to 3 g as 3 - 2 exp(-w t), which is at 2.5 g after ln(4) / w.
TEST(Shapes, BehindALowPassAConstantThreeGIsLateByTheLagsClosedForm) {
  core::LaunchDetectionPlan plan = raw_rule(2.5F, 100);
  plan.low_pass = true;
  for (const float cutoff_hz : {4.0F, 8.0F, 16.0F, 50.0F}) {
    plan.low_pass_hz = cutoff_hz;
    std::vector<float> values(600, one_g);
    std::fill(values.begin() + 100, values.end(), 3.0F * one_g);
    const double lag_ms = 1e3 * std::log(4.0) / (2.0 * std::numbers::pi * static_cast<double>(cutoff_hz));
    const auto at = detected(plan, values);
    ASSERT_TRUE(at);
    // The filter has moved once already with the sample of step 100.
    EXPECT_EQ(*at, 99U + static_cast<std::size_t>(std::ceil(lag_ms)) + 100U) << cutoff_hz;
  }
}

TEST(Shapes, BandNoiseHasItsStandardDeviationAndItsBand) {
  sim::Random random{test::seed(7), 0};
  for (const double frequency_hz : {40.0, 150.0, 300.0}) {
    std::vector<float> values(400'000, 0.0F);
    add_band_noise(values, 2.0, frequency_hz, random);
    double square = 0.0;
    double step_square = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
      const double v = values[i];
      const double step = v - static_cast<double>(values[i - 1]);
      square += v * v;
      step_square += step * step;
    }
    EXPECT_NEAR(std::sqrt(square / 400'000.0), 2.0, 0.05);
    // The correlations of a second-order resonance (Yule and Walker), and of its difference over two steps.
    const double radius = std::exp(-std::numbers::pi * 0.2e-3 * frequency_hz);
    const double last = 2.0 * radius * std::cos(2e-3 * std::numbers::pi * frequency_hz);
    const double one = last / (1.0 + radius * radius);
    const double two = last * one - radius * radius;
    const double three = last * two - radius * radius * one;
    const double of_the_difference = (one - three) / (2.0 * (1.0 - two));
    EXPECT_NEAR(step_square / square, 2.0 * (1.0 - of_the_difference), 0.02) << frequency_hz;
  }
}

}  // namespace
}  // namespace fantail::detection
