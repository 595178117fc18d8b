// SPDX-License-Identifier: MIT
#include "core/roll_reference.hpp"

#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

ReferencePlan plan_of(ReferenceKind kind) {
  ReferencePlan plan = default_plan().reference;
  plan.kind = kind;
  plan.initial = 3_deg;
  return plan;
}

ReferencePlan square_wave(float frequency_hz, Microseconds begin) {
  ReferencePlan plan = plan_of(ReferenceKind::square_wave);
  plan.square_wave_begin = begin;
  plan.square_wave_first = 45_deg;
  plan.square_wave_second = -10_deg;
  plan.square_wave_frequency_hz = frequency_hz;
  return plan;
}

TEST(RollReference, HoldStaysAtTheInitialAngleForTenMinutes) {
  const ReferencePlan plan = plan_of(ReferenceKind::hold);
  EXPECT_EQ(roll_reference(plan, Microseconds{0}), 3_deg);
  EXPECT_EQ(roll_reference(plan, Microseconds{600'000'000}), 3_deg);
}

TEST(RollReference, EachStepBeginsAtItsVeryMicrosecond) {
  ReferencePlan plan = plan_of(ReferenceKind::steps);
  plan.step_times_count = plan.step_angles_count = most_reference_steps;
  for (std::size_t i = 0; i < most_reference_steps; ++i) {
    plan.step_times[i] = Microseconds{static_cast<std::int64_t>(i) * 1'234'567 + 1};
    plan.step_angles[i] = Angle::from_degrees(static_cast<float>(i) * -20.0F - 1.0F);
  }
  for (std::size_t i = 0; i < most_reference_steps; ++i) {
    const Angle before = i == 0 ? plan.initial : plan.step_angles[i - 1];
    EXPECT_EQ(roll_reference(plan, plan.step_times[i] - Microseconds{1}), before) << i;
    EXPECT_EQ(roll_reference(plan, plan.step_times[i]), plan.step_angles[i]) << i;
  }
  EXPECT_EQ(roll_reference(plan, Microseconds{600'000'000}), plan.step_angles.back());
}

TEST(RollReference, AStepAtZeroHasNoInitialAngle) {
  ReferencePlan plan = plan_of(ReferenceKind::steps);
  plan.step_times_count = plan.step_angles_count = 1;
  plan.step_angles[0] = 45_deg;
  EXPECT_EQ(roll_reference(plan, Microseconds{0}), 45_deg);
}

// Every half wave of ten minutes, at its first and last microsecond. The frequencies are whole numbers of millihertz,
// so the k-th half wave begins at the first microsecond at or after k * 500 000 000 / millihertz: integers, no
// rounding.
TEST(RollReference, SquareWaveTurnsAtExactMultiplesOfTheHalfPeriodForTenMinutes) {
  for (const std::int64_t millihertz : {100, 300, 500, 700, 900, 1000, 3000, 7000, 9973, 9999, 10000}) {
    const Microseconds begin{1'000'000};
    const ReferencePlan plan = square_wave(static_cast<float>(millihertz) / 1000.0F, begin);
    const std::int64_t half_waves = 6 * millihertz / 5;
    for (std::int64_t k = 0; k <= half_waves; ++k) {
      const Microseconds turn{(k * 500'000'000 + millihertz - 1) / millihertz};
      const Angle here = k % 2 == 0 ? 45_deg : -10_deg;
      const Angle previous = k == 0 ? 3_deg : (k % 2 == 0 ? -10_deg : 45_deg);
      ASSERT_EQ(roll_reference(plan, begin + turn), here) << millihertz << " mHz, half wave " << k;
      ASSERT_EQ(roll_reference(plan, begin + turn - Microseconds{1}), previous) << millihertz << " mHz, " << k;
    }
  }
}

TEST(RollReference, SquareWaveOfTheFirstLaunchAlternatesEverySecondAfterOneSecondOfZero) {
  ReferencePlan plan = square_wave(0.5F, Microseconds{1'000'000});
  plan.initial = 0_deg;
  plan.square_wave_first = -15_deg;
  plan.square_wave_second = 15_deg;
  EXPECT_EQ(roll_reference(plan, Microseconds{999'999}), 0_deg);
  EXPECT_EQ(roll_reference(plan, Microseconds{1'000'000}), -15_deg);
  EXPECT_EQ(roll_reference(plan, Microseconds{1'999'999}), -15_deg);
  EXPECT_EQ(roll_reference(plan, Microseconds{2'000'000}), 15_deg);
  EXPECT_EQ(roll_reference(plan, Microseconds{3'000'000}), -15_deg);
}

}  // namespace
}  // namespace fantail::core
