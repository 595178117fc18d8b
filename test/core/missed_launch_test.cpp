// SPDX-License-Identifier: MIT

#include "core/flight_phase.hpp"
#include "phase_sequence.hpp"
#include "rocket.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

// Armed rockets that have moved without a detected launch: flown, raised with their rail, shaken, or left unmeasured.

constexpr double one_g_m_s2 = 9.80665;

FlightPlan plan_of_two() {
  FlightPlan plan = default_plan();
  plan.launch_detection.threshold_m_s2 = 2.5F * standard_gravity_m_s2;
  plan.launch_detection.hold = ms(100);
  plan.launch_detection.accelerometers = AccelerometerRule::two_agree;
  return plan;
}

/// 3 s at 2.3 g, which the plan above does not take for a launch, and as much free flight as is asked for.
void miss_a_launch(Rocket& rocket, Microseconds coast) {
  rocket.arm_on_pad();
  rocket.run(ms(3'000), 1.3 * one_g_m_s2);
  rocket.run(coast, -one_g_m_s2);
}

TEST(MissedLaunch, AfterLessThanASecondWithoutWeightTheRocketIsFinished) {
  Rocket rocket{plan_of_two()};
  miss_a_launch(rocket, ms(600));
  rocket.expect(Phase::armed, PhaseReason::moved_without_launch);
  rocket.run(ms(400), -one_g_m_s2);
  rocket.expect(Phase::finished, PhaseReason::flew_without_launch);
}

// Nose up under its drogue it stands as still as on the pad, and the main opens.
TEST(MissedLaunch, HangingStillUnderAParachuteIsNoRestThatReadiesIt) {
  for (const int coast_ms : {1'000, 1'500, 1'900}) {
    Rocket rocket{plan_of_two()};
    miss_a_launch(rocket, ms(coast_ms));
    rocket.run(ms(6'000));
    for (int t = 0; t < 800; ++t) {
      rocket.tick((8.0 * std::sin(3.14159265 * t / 800) - 1.0) * one_g_m_s2);
    }
    rocket.run(ms(2'000));
    rocket.expect(Phase::finished, PhaseReason::flew_without_launch);
  }
}

TEST(MissedLaunch, TheOpeningShockOfAParachuteStartsNoControl) {
  for (const double shock_g : {4.0, 6.0, 8.0, 12.0, 20.0}) {
    for (const int length_ms : {100, 300, 500, 800, 1'000}) {
      for (const int coast_ms : {300, 1'000, 1'900, 4'000}) {
        Rocket rocket{plan_of_two()};
        miss_a_launch(rocket, ms(coast_ms));
        for (int t = 0; t < length_ms; ++t) {
          const double half_sine_g = shock_g * std::sin(3.14159265 * t / length_ms);
          ASSERT_NE(rocket.tick((half_sine_g - 1.0) * one_g_m_s2).phase, Phase::launched)
              << shock_g << " " << length_ms;
        }
        rocket.run(ms(1'000), 0.0);
        ASSERT_NE(rocket.record().phase, Phase::controlling);
      }
    }
  }
}

TEST(MissedLaunch, AHopInTheGuideNeedsRestAndThenTheNextLaunchIsDetected) {
  Rocket rocket{plan_of_two()};
  rocket.arm_on_pad();
  rocket.run(ms(60), 4.0 * one_g_m_s2);  // too short for the plan
  rocket.run(ms(480), -one_g_m_s2);      // up and down again
  rocket.expect(Phase::armed, PhaseReason::moved_without_launch);
  rocket.run(ms(3'400));
  rocket.run(ms(50), 4.0 * one_g_m_s2);
  rocket.expect(Phase::armed, PhaseReason::moved_without_launch);
  rocket.run(ms(3'800));
  rocket.expect(Phase::armed, PhaseReason::rested);
  rocket.run(ms(200), 4.0 * one_g_m_s2);
  rocket.expect(Phase::launched, PhaseReason::launch_detected);
}

/// Raised evenly by so much within a second, and then still.
struct RaisedRail {
  double by_deg;
  Microseconds begin{};
  void operator()(Inputs& inputs) const {
    const double share = std::clamp(static_cast<double>((inputs.time - begin).count()) * 1e-6, 0.0, 1.0);
    const double tilt_rad = (by_deg - by_deg * share) * MotionRig::degree;
    const float axial = inputs.accelerometers[0].specific_force_m_s2.x;
    for (AccelerometerSample& sample : inputs.accelerometers) {
      sample.specific_force_m_s2 = {axial - static_cast<float>(one_g_m_s2 * (1.0 - std::cos(tilt_rad))), 0.0F,
                                    static_cast<float>(one_g_m_s2 * std::sin(tilt_rad))};
    }
    inputs.gyro.rate_rad_s.y = share > 0.0 && share < 1.0 ? static_cast<float>(by_deg * MotionRig::degree) : 0.0F;
  }
};

TEST(RaisedRail, ALaunchSoonerThanRestIsNotFlownWithTheAttitudeOfBefore) {
  Rocket rocket{plan_of_two()};
  rocket.inputs_changed_by(RaisedRail{.by_deg = 23.0, .begin = ms(5'000)});
  rocket.arm_on_pad();
  ASSERT_NEAR(rocket.record().motion.tilt.degrees(), 23.0F, 0.1F);
  rocket.run(ms(5'000) + ms(1'000) + ms(2'900) - rocket.rig.time());
  rocket.expect(Phase::armed, PhaseReason::moved_without_launch);
  rocket.run(ms(1'000), 4.0 * one_g_m_s2);
  EXPECT_NE(rocket.record().phase, Phase::controlling);
}

TEST(RaisedRail, AfterRestTheAttitudeIsTakenAnew) {
  Rocket rocket{plan_of_two()};
  rocket.inputs_changed_by(RaisedRail{.by_deg = 23.0, .begin = ms(5'000)});
  rocket.arm_on_pad();
  rocket.run(ms(5'000) + ms(1'000) + ms(3'700) - rocket.rig.time());
  rocket.expect(Phase::armed, PhaseReason::rested);
  rocket.run(ms(200), 4.0 * one_g_m_s2);
  rocket.expect(Phase::launched, PhaseReason::launch_detected);
  EXPECT_NEAR(rocket.record().motion.tilt.degrees(), 0.0F, 0.1F);
}

TEST(RaisedRail, RestOnTheSideIsNoReadiness) {
  Rocket rocket{plan_of_two()};
  rocket.inputs_changed_by([](Inputs& inputs) {
    if (inputs.time > ms(5'000)) {
      for (AccelerometerSample& sample : inputs.accelerometers) {
        sample.specific_force_m_s2 = {0.0F, static_cast<float>(one_g_m_s2), 0.0F};
      }
    }
  });
  rocket.arm_on_pad();
  rocket.run(ms(60'000));
  rocket.expect(Phase::armed, PhaseReason::moved_without_launch);
}

TEST(MissedLaunch, ATurnThatBecameTheGyrosZeroIsNoRest) {
  FlightPlan plan = plan_of_two();
  const float bias_rad_s = largest_gyro_bias_rad_s(plan.motion);
  for (const bool beyond : {false, true}) {
    Rocket rocket{plan};
    rocket.inputs_changed_by([&](Inputs& inputs) { inputs.gyro.rate_rad_s.x = (beyond ? 1.01F : 0.99F) * bias_rad_s; });
    rocket.run(ms(5'000));
    EXPECT_NEAR(rocket.record().motion.roll_rate_rad_s, beyond ? 1.01F * bias_rad_s : 0.0F, 1e-5F);
  }
}

TEST(MissedLaunch, ControlDoesNotBeginWhileTheGyroIsSilent) {
  FlightPlan plan = plan_of_two();
  plan.motion.longest_gyro_gap = ms(500);
  Rocket rocket{plan};
  rocket.arm_on_pad();
  rocket.run_until_phase_changes(60.0);
  const Microseconds silent_from = rocket.rig.time();
  rocket.inputs_changed_by([&](Inputs& inputs) {
    if (inputs.time - silent_from < ms(450)) {
      inputs.gyro.quality = SampleQuality::absent;
    }
  });
  const Microseconds waited = rocket.run_until_phase_changes(60.0);
  rocket.expect(Phase::controlling, PhaseReason::guide_clear);
  EXPECT_GE(waited, ms(450));
  EXPECT_EQ(rocket.record().motion.gyro, SensorState::fresh);
}

// What an armed rocket that has moved must do before it detects a launch.

using namespace literals;

TEST(FlightPhase, AfterAFailedGateNothingIsDetectedBeforeTwoSecondsAtRest) {
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.time += ms(1'500);
  sequence.tick();
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  sequence.launch().expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
  sequence.next.motion.at_rest_for = ms(1'999);
  sequence.launch().expect(Phase::armed, PhaseReason::guide_not_cleared_in_time);
  sequence.next.motion.at_rest_for = ms(2'000);
  sequence.tick();
  EXPECT_TRUE(sequence.phases().listens_for_launch());
  sequence.next.motion.at_rest_for = ms(0);
  sequence.launch().expect(Phase::launched, PhaseReason::launch_detected);
}

TEST(FlightPhase, AnArmedRocketThatMovesDetectsNothingBeforeItHasRested) {
  Sequence sequence;
  sequence.arm();
  EXPECT_FALSE(sequence.tick([](Tick& i) {
    i.motion.has_moved = true;
    i.launch_detected = true;
  })) << "not even in that tick";
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
  sequence.launch().expect(Phase::armed, PhaseReason::moved_without_launch);
  sequence.next.motion.at_rest_for = ms(2'000);
  sequence.tick([](Tick& i) { i.motion.has_moved = true; });  // at rest, but its attitude is not known yet
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
  sequence.tick([](Tick& i) { i.motion.tilt = 45.1_deg; });  // lies, or hangs
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  EXPECT_FALSE(sequence.tick());
  sequence.expect(Phase::armed, PhaseReason::rested);
  sequence.next.motion.at_rest_for = ms(0);
  sequence.launch().expect(Phase::launched, PhaseReason::launch_detected);
}

TEST(FlightPhase, AnArmedRocketThatFellIsFinishedAndASafeOneIsNot) {
  Sequence sequence;
  sequence.tick([](Tick& i) { i.motion.has_fallen = true; });
  sequence.expect(Phase::safe, PhaseReason::power_on);
  sequence.arm();
  EXPECT_TRUE(sequence.tick([](Tick& i) { i.motion.has_fallen = true; }));
  sequence.expect(Phase::finished, PhaseReason::flew_without_launch);
  Sequence in_hands;
  in_hands.arm();
  in_hands.tick([](Tick& i) {
    i.motion.has_fallen = true;
    i.arm_switch_closed = false;
  });
  in_hands.expect(Phase::safe, PhaseReason::disarmed_by_switch);
}

TEST(FlightPhase, MovementInTheTunnelIsNobodysBusiness) {
  FlightPlan plan = default_plan();
  plan.run.start = Start::tunnel;
  Sequence sequence{plan};
  sequence.arm();
  sequence.tick([](Tick& i) { i.motion.has_moved = i.motion.has_fallen = true; });
  sequence.expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
}

TEST(FlightPhase, DisarmingDoesNotExcuseFromTheRest) {
  Sequence sequence;
  sequence.arm().launch();
  sequence.next.time += ms(1'500);
  sequence.tick();
  sequence.tick([](Tick& i) { i.arm_switch_closed = false; });
  sequence.arm().expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
  EXPECT_FALSE(sequence.phases().listens_for_launch());
  sequence.tick();
  sequence.expect(Phase::armed, PhaseReason::moved_without_launch);
}

}  // namespace

}  // namespace fantail::core
