// SPDX-License-Identifier: MIT
#include "core/chirp.hpp"

#include <cstdlib>

#include "core/flight_plan_fields.hpp"
#include "core/trig.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;
using std::numbers::pi_v;

ExcitationPlan published(ExcitationForm form) {
  ExcitationPlan plan = default_plan().excitation;
  plan.form = form;
  return plan;
}

double degrees(Angle angle) { return static_cast<double>(angle.radians()) * 180.0 / pi_v<double>; }

double excitation_deg(const ExcitationPlan& plan, std::int64_t time_us) {
  return degrees(Chirp{plan}.update(Microseconds{time_us}));
}

std::vector<Angle> run(const ExcitationPlan& plan, std::int64_t from_us, std::int64_t to_us) {
  Chirp chirp{plan};
  std::vector<Angle> result;
  for (std::int64_t t = from_us; t < to_us; t += 1000) {
    result.push_back(chirp.update(Microseconds{t}));
  }
  return result;
}

// The largest distance in degrees from amplitude * sin(2 pi turns(t)) in double, at odd moments too.
double largest_error_deg(const ExcitationPlan& plan, const std::function<double(double)>& turns) {
  Chirp chirp{plan};
  double largest = 0.0;
  for (Microseconds t = plan.begin; t < plan.end; t += Microseconds{997}) {
    const double expected =
        degrees(plan.amplitude) * std::sin(2.0 * pi_v<double> * turns(static_cast<double>(t.count()) * 1e-6));
    largest = std::max(largest, std::abs(degrees(chirp.update(t)) - expected));
  }
  return largest;
}

TEST(Chirp, ProductFormGivesThePublishedExcitation) {
  const ExcitationPlan plan = published(ExcitationForm::product);
  EXPECT_NEAR(excitation_deg(plan, 400'000), 3.6193, 1e-4);
  EXPECT_NEAR(excitation_deg(plan, 500'000), 0.0, 1e-4);
  EXPECT_NEAR(excitation_deg(plan, 6'990'000), -3.6172, 1e-4);
}

TEST(Chirp, IsExactlyZeroOutsideItsWindow) {
  for (const ExcitationForm form : {ExcitationForm::product, ExcitationForm::sweep}) {
    ExcitationPlan plan = published(form);
    plan.amplitude_variation = 2_deg;
    plan.frequency_variation_hz = 2.0F;
    Chirp chirp{plan};
    for (const std::int64_t t : {0, 399'999, 7'000'000, 7'000'001, 600'000'000}) {
      EXPECT_EQ(chirp.update(Microseconds{t}).radians(), 0.0F) << t;
    }
  }
  EXPECT_EQ(excitation_deg(published(ExcitationForm::none), 1'000'000), 0.0);
}

TEST(Chirp, ProductFormKeepsItsPhaseOverTheWholeWindow) {
  const auto turns = [](double t) { return (2.0 * t - 10.0) * t; };
  EXPECT_LT(largest_error_deg(published(ExcitationForm::product), turns), 1e-5);
}

TEST(Chirp, ProductFormKeepsItsPhaseToTheEndOfTheLongestPlan) {
  ExcitationPlan plan = published(ExcitationForm::product);
  plan.end = Microseconds{600'000'000};
  plan.product_slope_hz_s = 50.0F;
  plan.product_offset_hz = -50.0F;
  EXPECT_LT(largest_error_deg(plan, [](double t) { return std::fmod((50.0 * t - 50.0) * t, 1.0); }), 1e-4);
}

// Frequency times time in whole numbers, split at the second so that 64 bits hold it, and rounded once.
float turns_of(std::int64_t frequency_phz, std::int64_t time_us) {
  constexpr std::int64_t million = 1'000'000;
  constexpr std::int64_t turn = million * million;
  const std::int64_t frequency = std::abs(frequency_phz);
  const std::int64_t rest_us = time_us % million;
  const std::int64_t phase =
      frequency % turn * (time_us / million) + frequency / million * rest_us + frequency % million * rest_us / million;
  return static_cast<float>(frequency_phz < 0 ? -(phase % turn) : phase % turn) / 1e12F;
}

TEST(Chirp, PhaseIsThatOfWholeNumbersToTheLastBit) {
  ExcitationPlan plan = published(ExcitationForm::product);
  plan.begin = Microseconds{0};
  plan.end = Microseconds{3'600'000'000};
  for (const auto& [offset_hz, slope_hz_s] : {std::pair{0.0F, 0.0F}, {-10.0F, 2.0F}, {0.25F, 0.0F}, {-50.0F, 8.0F}}) {
    plan.product_offset_hz = offset_hz;
    plan.product_slope_hz_s = slope_hz_s;
    Chirp chirp{plan};
    for (std::int64_t t = 0; t < plan.end.count(); t += 1'000'003 * (1 + t / 100'000'000)) {
      const std::int64_t frequency_phz = millionths(offset_hz) * 1'000'000 + millionths(slope_hz_s) * t;
      const float expected_rad = plan.amplitude.radians() * sin_turns(turns_of(frequency_phz, t));
      ASSERT_EQ(chirp.update(Microseconds{t}).radians(), expected_rad) << t << " us, from " << offset_hz << " Hz";
    }
  }
}

// 5 Hz/s, half of which is a whole number of nHz/s: no digit is cut off.
TEST(Chirp, PhaseOfASweepUpwardsAndDownwardsIsThatOfWholeNumbersToTheLastBit) {
  for (const bool downwards : {false, true}) {
    ExcitationPlan plan = published(ExcitationForm::sweep);
    plan.begin = Microseconds{0};
    plan.end = Microseconds{10'000'000};
    plan.sweep_first_hz = downwards ? 50.5F : 0.5F;
    plan.sweep_last_hz = downwards ? 0.5F : 50.5F;
    Chirp chirp{plan};
    for (std::int64_t t = 0; t < plan.end.count(); t += 9'973) {
      const std::int64_t frequency_phz =
          downwards ? 50'500'000'000'000 - 2'500'000 * t : 500'000'000'000 + 2'500'000 * t;
      const float expected_rad = plan.amplitude.radians() * sin_turns(turns_of(frequency_phz, t));
      ASSERT_EQ(chirp.update(Microseconds{t}).radians(), expected_rad) << t << " us, downwards: " << downwards;
    }
  }
}

TEST(Chirp, SweepRunsEvenlyFromTwoToTenHertzWithAContinuousPhase) {
  const ExcitationPlan plan = published(ExcitationForm::sweep);
  EXPECT_EQ(excitation_deg(plan, 400'000), 0.0);
  EXPECT_LT(largest_error_deg(plan, [](double t) { return (2.0 + 0.5 * 8.0 / 6.6 * (t - 0.4)) * (t - 0.4); }), 1e-5);
}

TEST(Chirp, SweepMayRunDownwardsAndForTenMinutes) {
  ExcitationPlan plan = published(ExcitationForm::sweep);
  plan.begin = Microseconds{0};
  plan.end = Microseconds{600'000'000};
  plan.sweep_first_hz = 50.0F;
  plan.sweep_last_hz = 0.5F;
  EXPECT_LT(largest_error_deg(plan, [](double t) { return std::fmod((50.0 - 0.5 * 49.5 / 600.0 * t) * t, 1.0); }),
            1e-2);
}

TEST(Chirp, VariationIsOffByDefault) {
  const ExcitationPlan plan = default_plan().excitation;
  EXPECT_EQ(plan.amplitude_variation, Angle{});
  EXPECT_EQ(plan.frequency_variation_hz, 0.0F);
  for (const ExcitationForm form : {ExcitationForm::product, ExcitationForm::sweep}) {
    ExcitationPlan other_seed = published(form);
    other_seed.variation_seed = 77;
    EXPECT_EQ(run(published(form), 0, 8'000'000), run(other_seed, 0, 8'000'000));
  }
}

TEST(Chirp, VariationDependsOnNothingButItsSeed) {
  for (const ExcitationForm form : {ExcitationForm::product, ExcitationForm::sweep}) {
    ExcitationPlan plan = published(form);
    plan.amplitude_variation = 1_deg;
    plan.frequency_variation_hz = 0.5F;
    const std::vector<Angle> once = run(plan, 0, 8'000'000);
    EXPECT_EQ(once, run(plan, 0, 8'000'000));
    EXPECT_EQ(std::vector<Angle>(once.begin() + 3210, once.end()), run(plan, 3'210'000, 8'000'000))
        << "a tick that comes late must find what it would have found";
    plan.variation_seed += 1;
    EXPECT_NE(once, run(plan, 0, 8'000'000));
  }
}

// A slow carrier, positive in the whole window, so that it can be divided out.
TEST(Chirp, AmplitudeVariationIsLinearBetweenTenthsOfASecondAndBounded) {
  ExcitationPlan plan = published(ExcitationForm::product);
  plan.begin = Microseconds{2'000'000};
  plan.end = Microseconds{8'000'000};
  plan.product_slope_hz_s = 0.0F;
  plan.product_offset_hz = 0.05F;
  plan.amplitude_variation = 1_deg;
  std::vector<double> variation_deg;
  for (std::int64_t t = 2'000'000; t < 8'000'000; t += 10'000) {
    const double carrier = std::sin(2.0 * pi_v<double> * 0.05 * static_cast<double>(t) * 1e-6);
    variation_deg.push_back(excitation_deg(plan, t) / carrier - 4.0);
  }
  double largest = 0.0;
  double largest_bend = 0.0;
  for (std::size_t i = 1; i + 1 < variation_deg.size(); ++i) {
    const double bend = variation_deg[i + 1] - 2.0 * variation_deg[i] + variation_deg[i - 1];
    if (i % 10 != 0) {
      ASSERT_NEAR(bend, 0.0, 1e-5) << i;
    }
    largest = std::max(largest, std::abs(variation_deg[i]));
    largest_bend = std::max(largest_bend, std::abs(bend));
  }
  EXPECT_LE(largest, 1.0 + 1e-5);
  EXPECT_GT(largest, 0.8) << "sixty draws of [-1, 1) reach further than this";
  EXPECT_GT(largest_bend, 0.05);
}

TEST(Chirp, FrequencyVariationBendsThePhaseOfTheSweepButNeverBreaksIt) {
  ExcitationPlan plan = published(ExcitationForm::sweep);
  plan.sweep_first_hz = plan.sweep_last_hz = 3.0F;
  plan.end = Microseconds{60'000'000};
  plan.frequency_variation_hz = 2.0F;
  const std::vector<Angle> values = run(plan, 400'000, 60'000'000);
  const double fastest_deg = 4.0 * 2.0 * pi_v<double> * 5.0 * 0.001;
  for (std::size_t i = 1; i < values.size(); ++i) {
    ASSERT_LE(std::abs(degrees(values[i] - values[i - 1])), fastest_deg * 1.001) << i;
  }
  const auto furthest = std::ranges::max_element(values, {}, [](Angle a) { return abs(a); });
  EXPECT_LE(degrees(abs(*furthest)), 4.0 + 1e-6);
}

}  // namespace
}  // namespace fantail::core
