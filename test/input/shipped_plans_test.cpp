// SPDX-License-Identifier: MIT
#include <filesystem>

#include "core/flight_plan_fields.hpp"
#include "input/plan_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

using namespace core::literals;
using core::Microseconds;

core::FlightPlan shipped(const std::string& name) {
  return read_plan(Document::load(std::filesystem::path{SHIPPED_PLANS} / (name + ".toml")));
}

TEST(ShippedPlans, FirstLaunchIsAsPublishedThroughout) {
  const core::FlightPlan plan = shipped("tasha3_launch1");
  EXPECT_EQ(plan.run.start, core::Start::launch);
  EXPECT_FLOAT_EQ(plan.launch_detection.threshold_m_s2, 2.0F * 9.80665F);
  EXPECT_EQ(plan.launch_detection.hold, Microseconds{200'000});
  EXPECT_EQ(plan.launch_detection.accelerometers, core::AccelerometerRule::one);
  EXPECT_FALSE(plan.launch_detection.low_pass);
  EXPECT_EQ(plan.motion.height_origin, core::HeightOrigin::velocity_only);
  EXPECT_EQ(plan.guide.length_m, 4.0F);
  EXPECT_EQ(plan.guide.clearance_m, 2.0F);
  EXPECT_EQ(plan.guide.minimum_speed_m_s, 0.0F);
  EXPECT_EQ(plan.controller.proportional_gain, 1.0F);
  EXPECT_EQ(plan.controller.derivative_gain_s, 0.1F);
  EXPECT_EQ(plan.controller.canard_limit, 6_deg);
  EXPECT_EQ(plan.controller.rate_reference, core::RateReference::zero);
  EXPECT_EQ(plan.excitation.form, core::ExcitationForm::none);
  // 0 deg, then -15 and +15 in turn, every second.
  EXPECT_EQ(plan.reference.kind, core::ReferenceKind::square_wave);
  EXPECT_EQ(plan.reference.initial, 0_deg);
  EXPECT_EQ(plan.reference.square_wave_begin, Microseconds{1'000'000});
  EXPECT_EQ(plan.reference.square_wave_first, -15_deg);
  EXPECT_EQ(plan.reference.square_wave_second, 15_deg);
  EXPECT_EQ(plan.reference.square_wave_frequency_hz, 0.5F);
}

TEST(ShippedPlans, SecondLaunchHasTwoAccelerometersOneStepAndTheProductChirp) {
  const core::FlightPlan plan = shipped("tasha3_launch2");
  EXPECT_EQ(plan.run.start, core::Start::launch);
  EXPECT_FLOAT_EQ(plan.launch_detection.threshold_m_s2, 2.5F * 9.80665F);
  EXPECT_EQ(plan.launch_detection.hold, Microseconds{100'000});
  EXPECT_EQ(plan.launch_detection.accelerometers, core::AccelerometerRule::two_agree);
  EXPECT_TRUE(plan.launch_detection.low_pass);
  EXPECT_EQ(plan.launch_detection.low_pass_hz, 8.0F);
  EXPECT_FLOAT_EQ(plan.launch_detection.disagreement_m_s2, 2.0F * 9.80665F);
  EXPECT_EQ(plan.motion.height_origin, core::HeightOrigin::replay);
  EXPECT_EQ(plan.guide.length_m, 4.0F);
  EXPECT_EQ(plan.guide.clearance_m, 2.0F);
  EXPECT_EQ(plan.guide.minimum_speed_m_s, 17.0F);
  EXPECT_EQ(plan.guide.clearance_time, Microseconds{1'500'000});
  EXPECT_EQ(plan.controller.proportional_gain, 0.5F);
  EXPECT_EQ(plan.controller.derivative_gain_s, 0.05F);
  EXPECT_EQ(plan.controller.canard_limit, 9_deg);
  EXPECT_EQ(plan.reference.kind, core::ReferenceKind::steps);
  ASSERT_EQ(plan.reference.step_times_count, 1);
  EXPECT_EQ(plan.reference.step_times[0], Microseconds{2'000'000});
  EXPECT_EQ(plan.reference.step_angles[0], -20_deg);
  EXPECT_EQ(plan.excitation.form, core::ExcitationForm::product);
  EXPECT_EQ(plan.excitation.amplitude, 4_deg);
  EXPECT_EQ(plan.excitation.begin, Microseconds{400'000});
  EXPECT_EQ(plan.excitation.end, Microseconds{7'000'000});
  EXPECT_EQ(plan.excitation.product_slope_hz_s, 2.0F);
  EXPECT_EQ(plan.excitation.product_offset_hz, -10.0F);
  EXPECT_EQ(plan.excitation.amplitude_variation, 0_deg);
  EXPECT_EQ(plan.excitation.frequency_variation_hz, 0.0F);
}

// So that a flight of the one beside the other shows the integral and nothing else.
TEST(ShippedPlans, WithTheIntegralIsTheSecondLaunchButForItsLaw) {
  core::FlightPlan plan = shipped("tasha3_launch2_integral");
  EXPECT_EQ(plan.offset.rejection, core::OffsetRejection::integral);
  EXPECT_EQ(plan.offset.integral_gain_per_s, 0.5F);
  EXPECT_EQ(plan.controller.derivative_gain_s, 0.08F);
  const core::FlightPlan published = shipped("tasha3_launch2");
  plan.offset = published.offset;
  plan.controller.derivative_gain_s = published.controller.derivative_gain_s;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    ASSERT_EQ(field.used_slots(plan), field.used_slots(published)) << field.key;
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      EXPECT_EQ(field.get_bits(plan, slot), field.get_bits(published, slot)) << field.section << '.' << field.key;
    }
  }
}

// What ranges ask (docs/safety.md): of the clauses in numbers, those that a plan alone can meet.
TEST(ShippedPlans, ThatMayFlyWaitCaptureAndEndAtTrim) {
  for (const char* name : {"tasha3_launch2_irec", "tasha3_launch2_euroc", "kestrel", "kestrel_euroc"}) {
    const core::FlightPlan plan = shipped(name);
    EXPECT_NE(plan.dormancy.until, core::DormantUntil::guide) << name;
    EXPECT_EQ(plan.controller.entry, core::ControlEntry::capture) << name;
    EXPECT_EQ(plan.run.tilt_limit, 30_deg) << name;
    EXPECT_EQ(plan.run.tilt_from, core::TiltOrigin::guide) << name;
    EXPECT_EQ(plan.run.canard_fault, core::CanardFaultPolicy::end_control) << name;
    EXPECT_NE(plan.run.abort_input, core::AbortInput::none) << name;
    EXPECT_EQ(plan.excitation.form, core::ExcitationForm::none) << name;
    EXPECT_TRUE(plan.reference.step_times[0] >= Microseconds{1'200'000}) << name;
  }
  EXPECT_EQ(shipped("tasha3_launch2_euroc").dormancy.height_m, 1500.0F);
  EXPECT_EQ(shipped("kestrel_euroc").dormancy.height_m, 1500.0F);
}

// So that kestrel_euroc differs from kestrel in its gate and in nothing else.
TEST(ShippedPlans, OfKestrelDifferInTheirGate) {
  core::FlightPlan plan = shipped("kestrel_euroc");
  const core::FlightPlan other = shipped("kestrel");
  EXPECT_EQ(plan.dormancy.until, core::DormantUntil::burn_out_and_height);
  plan.dormancy = other.dormancy;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    for (std::size_t slot = 0; slot < field.used_slots(other); ++slot) {
      EXPECT_EQ(field.get_bits(plan, slot), field.get_bits(other, slot)) << field.section << '.' << field.key;
    }
  }
}

TEST(ShippedPlans, TunnelRunsStepBy45DegreesEveryTenSecondsEightTimes) {
  const core::FlightPlan plan = shipped("tunnel_steps");
  EXPECT_EQ(plan.run.start, core::Start::tunnel);
  EXPECT_EQ(plan.run.control_time, Microseconds{80'000'000});
  EXPECT_EQ(plan.controller.proportional_gain, 0.5F);
  EXPECT_EQ(plan.controller.derivative_gain_s, 0.05F);
  EXPECT_EQ(plan.controller.canard_limit, 9_deg);
  EXPECT_EQ(plan.reference.kind, core::ReferenceKind::square_wave);
  EXPECT_EQ(plan.reference.square_wave_first, 45_deg);
  EXPECT_EQ(plan.reference.square_wave_second, 0_deg);
  EXPECT_EQ(plan.reference.square_wave_frequency_hz, 0.1F);
  EXPECT_EQ(plan.excitation.form, core::ExcitationForm::none);
}

TEST(ShippedPlans, AFreelyRollingTunnelRunHasNoGains) {
  const core::FlightPlan plan = shipped("tunnel_free");
  EXPECT_EQ(plan.run.start, core::Start::tunnel);
  EXPECT_EQ(plan.run.control_time, Microseconds{600'000'000});
  EXPECT_EQ(plan.controller.proportional_gain, 0.0F);
  EXPECT_EQ(plan.controller.derivative_gain_s, 0.0F);
  EXPECT_EQ(plan.reference.kind, core::ReferenceKind::hold);
  EXPECT_EQ(plan.excitation.form, core::ExcitationForm::none);
}

TEST(ShippedPlans, OfTheStabilityCheckControlsNothingForAsLongAsTheRecordLasts) {
  const core::FlightPlan plan = shipped("tunnel_stability");
  EXPECT_EQ(plan.run.start, core::Start::tunnel);
  EXPECT_EQ(plan.controller.proportional_gain, 0.0F);
  EXPECT_EQ(plan.controller.derivative_gain_s, 0.0F);
  EXPECT_LE(plan.run.control_time, Microseconds{110'000'000});
}

TEST(ShippedPlans, OfTheGimbalHoldsTheRollOnCommand) {
  const core::FlightPlan plan = shipped("gimbal");
  EXPECT_EQ(plan.run.start, core::Start::tunnel);
  EXPECT_EQ(plan.run.control_time, Microseconds{30'000'000});
  EXPECT_EQ(plan.reference.kind, core::ReferenceKind::hold);
}

TEST(ShippedPlans, AreElevenAndNoFileIsForgottenHere) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator{SHIPPED_PLANS}) {
    EXPECT_NO_THROW((void)read_plan(Document::load(entry.path()))) << entry.path();
    count += 1;
  }
  EXPECT_EQ(count, 11U);
}

}  // namespace
}  // namespace fantail::input
