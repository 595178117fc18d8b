// SPDX-License-Identifier: MIT

#include "core/chirp.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

// The first draws of seed 4711, computed in Python: MurmurHash3's fmix32 of seed * 0x9E3779B1 + stream * 0x85EBCA77 +
// number, of which the upper 24 bits are a number in [-1, 1). Stream 0 varies the amplitude, stream 1 the frequency.
constexpr std::array amplitude_draws{-0.054162979, 0.066627741, -0.938673735, 0.561493397,
                                     0.251344800,  0.437311888, 0.790390730};
constexpr std::array frequency_draws{0.633149266, -0.938345194, 0.008776069, -0.529542565,
                                     0.973553419, -0.341497898, 0.827756763};
constexpr double span_s = 0.1;

ExcitationPlan seeded(ExcitationForm form) {
  ExcitationPlan plan = default_plan().excitation;
  plan.form = form;
  plan.variation_seed = 4711;
  return plan;
}

double in_degrees(Angle angle) { return static_cast<double>(angle.radians()) * 180.0 / std::numbers::pi; }

/// Linear from draw to draw.
double between(const std::array<double, 7>& draws, double since_begin_s) {
  const double spans = since_begin_s / span_s;
  const auto span = static_cast<std::size_t>(spans);
  const double share = spans - static_cast<double>(span);
  return draws[span] + share * (draws[span + 1] - draws[span]);
}

double integral_of(const std::array<double, 7>& draws, double since_begin_s) {
  double sum = 0.0;
  double done_s = 0.0;
  for (std::size_t i = 0; done_s + span_s <= since_begin_s; ++i, done_s = span_s * static_cast<double>(i)) {
    sum += 0.5 * (draws[i] + draws[i + 1]) * span_s;
  }
  return sum + 0.5 * (between(draws, done_s) + between(draws, since_begin_s)) * (since_begin_s - done_s);
}

// Either one alone, too.
TEST(Chirp, TheVariationsAreTheDrawsOfTheirSeedAndLinearBetweenThem) {
  struct Case {
    double amplitude_deg;
    double frequency_hz;
  };
  for (const auto& [amplitude_deg, frequency_hz] : {Case{10.0, 0.0}, Case{0.0, 0.5}, Case{10.0, 10.0}}) {
    for (const ExcitationForm form : {ExcitationForm::product, ExcitationForm::sweep}) {
      ExcitationPlan plan = seeded(form);
      plan.amplitude_variation = Angle::from_degrees(static_cast<float>(amplitude_deg));
      plan.frequency_variation_hz = static_cast<float>(frequency_hz);
      Chirp chirp{plan};
      for (int t_us = 400'000; t_us < 999'000; t_us += 977) {
        const double t = t_us * 1e-6;
        const double s = t - 0.4;
        const double turns = form == ExcitationForm::product
                                 ? (2.0 * t - 10.0 + frequency_hz * between(frequency_draws, s)) * t
                                 : (2.0 + 0.5 * 8.0 / 6.6 * s) * s + frequency_hz * integral_of(frequency_draws, s);
        const double expected_deg =
            (4.0 + amplitude_deg * between(amplitude_draws, s)) * std::sin(2.0 * std::numbers::pi * turns);
        ASSERT_NEAR(in_degrees(chirp.update(Microseconds{t_us})), expected_deg, 1e-4)
            << t_us << " us, " << frequency_hz << " Hz";
      }
    }
  }
}

TEST(Chirp, ASmallVariationIsNotLostWhereTheSweepHasMadeAWholeTurn) {
  ExcitationPlan plan = seeded(ExcitationForm::sweep);
  plan.sweep_first_hz = plan.sweep_last_hz = 5.0F;
  plan.frequency_variation_hz = 1e-6F;
  const double turns = 1e-6 * integral_of(frequency_draws, 0.2);
  const double expected_deg = 4.0 * 2.0 * std::numbers::pi * turns;
  EXPECT_NEAR(in_degrees(Chirp{plan}.update(plan.begin + Microseconds{200'000})), expected_deg,
              1e-3 * std::abs(expected_deg));
}

TEST(Chirp, ATickThatComesMinutesLateFindsTheVariationOfItsOwnTime) {
  ExcitationPlan plan = seeded(ExcitationForm::sweep);
  plan.begin = Microseconds{0};
  plan.end = Microseconds{600'000'000};
  plan.amplitude_variation = Angle::from_degrees(4.0F);
  plan.frequency_variation_hz = 1.0F;
  // 2^27 us: by this time, times and products in 32 bits have come round more than once.
  const Microseconds late{134'217'728};
  Chirp chirp{plan};
  EXPECT_EQ(chirp.update(Microseconds{0}), Angle{});
  const Angle found = chirp.update(late);
  EXPECT_EQ(found, Chirp{plan}.update(late));
  EXPECT_NE(found, Angle{});
}

}  // namespace
}  // namespace fantail::core
