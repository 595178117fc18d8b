// SPDX-License-Identifier: MIT

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "milliseconds.hpp"
#include "motion_rig.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

/// An autopilot on a rig at 1 kHz, switch closed, canards that stand where they are told until one of them is stuck.
class Bench {
 public:
  explicit Bench(const FlightPlan& plan) : autopilot_{plan} {}

  const TickRecord& tick(double acceleration_m_s2, double roll_rate_rad_s = 0.0, bool switch_closed = true,
                         bool arm = false) {
    rig_.advance(ms(1), acceleration_m_s2, roll_rate_rad_s);
    Inputs inputs = rig_.inputs();
    inputs.accelerometers[1].specific_force_m_s2.x += second_more_m_s2_;
    inputs.arm_switch_closed = switch_closed;
    inputs.arm_command = arm;
    for (std::size_t i = 0; i < canard_count; ++i) {
      inputs.encoders[i] = stuck_ && i == 2 ? Angle{} : record_.canards[i].angle;
    }
    record_ = autopilot_.step(inputs);
    return record_;
  }
  void run(Microseconds length, double acceleration_m_s2, double roll_rate_rad_s = 0.0) {
    for (Microseconds t{}; t < length; t += ms(1)) {
      tick(acceleration_m_s2, roll_rate_rad_s);
    }
  }
  void arm_on_pad() {
    run(ms(4'000), 0.0);
    tick(0.0, 0.0, true, true);
    run(ms(200), 0.0);
  }
  void stick_one_canard() { stuck_ = true; }
  void let_the_second_accelerometer_read_more_by(float m_s2) { second_more_m_s2_ = m_s2; }
  [[nodiscard]] const TickRecord& record() const { return record_; }

 private:
  MotionRig rig_;
  Autopilot autopilot_;
  TickRecord record_;
  bool stuck_ = false;
  float second_more_m_s2_ = 0.0F;
};

TEST(AutopilotPhase, DisarmingInTheMiddleOfAHoldStartsItAgain) {
  FlightPlan plan = default_plan();
  plan.launch_detection.low_pass = false;
  Bench bench{plan};
  bench.arm_on_pad();
  bench.run(ms(95), 40.0);
  EXPECT_EQ(bench.tick(40.0, 0.0, false).phase, Phase::safe);
  EXPECT_EQ(bench.tick(40.0, 0.0, true, true).phase, Phase::armed);
  for (int t = 0; t < 100; ++t) {
    ASSERT_EQ(bench.tick(40.0).phase, Phase::armed) << t;
  }
  EXPECT_EQ(bench.tick(40.0).phase, Phase::launched);
}

// As a sensor that stands still while a rocket is shaken does: after the detection the other one reads something else.
TEST(AutopilotPhase, TwoAccelerometersThatDisagreeAfterTheDetectionPutOffControl) {
  FlightPlan plan = default_plan();
  plan.launch_detection.accelerometers = AccelerometerRule::two_agree;
  Bench bench{plan};
  bench.arm_on_pad();
  bench.run(ms(200), 40.0);
  ASSERT_EQ(bench.record().phase, Phase::launched);
  EXPECT_EQ(bench.record().detection, DetectionState::quiet);
  bench.let_the_second_accelerometer_read_more_by(-20.0F);
  bench.run(ms(800), 40.0);
  EXPECT_GT(bench.record().motion.distance_along_guide_m, 15.0F);
  EXPECT_EQ(bench.record().phase, Phase::launched);
  EXPECT_EQ(bench.record().command, Angle{});
  bench.let_the_second_accelerometer_read_more_by(0.0F);
  bench.run(ms(250), 40.0);
  EXPECT_EQ(bench.record().phase, Phase::launched);
  bench.run(ms(50), 40.0);
  EXPECT_EQ(bench.record().phase, Phase::controlling);
}

TEST(AutopilotPhase, CanardThatIsStuckEndsControlOnlyWhenThePlanSaysSo) {
  for (const CanardFaultPolicy policy :
       {CanardFaultPolicy::continue_control, CanardFaultPolicy::end_control, CanardFaultPolicy::share}) {
    FlightPlan plan = default_plan();
    plan.run.canard_fault = policy;
    Bench bench{plan};
    bench.arm_on_pad();
    bench.run(ms(900), 40.0, 0.5);
    ASSERT_EQ(bench.record().phase, Phase::controlling);
    bench.stick_one_canard();
    bench.run(ms(600), 40.0, 0.5);
    const bool ends = policy == CanardFaultPolicy::end_control;
    EXPECT_EQ(bench.record().phase, ends ? Phase::finished : Phase::controlling);
    EXPECT_EQ(bench.record().reason, ends ? PhaseReason::canard_fault : PhaseReason::guide_clear);
  }
}

}  // namespace
}  // namespace fantail::core
