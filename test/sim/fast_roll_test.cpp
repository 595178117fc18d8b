// SPDX-License-Identifier: MIT

#include "jammed_canards.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

// alpha and beta grow alike: the steady rate is v beta u / alpha at any Mach number, and the way there is shorter. All
// in a tunnel that is faster than any, with the sound of the ISA at sea level.
TEST(Compressibility, MakesTheRollFasterAndItsSteadyRateStays) {
  struct Case {
    double speed_m_s;
    const char* kind;
    double factor;
  };
  const double sound_m_s = std::sqrt(1.4 * 287.05287 * 288.15);
  const double mach = 200.0 / sound_m_s;
  for (const Case& c : {Case{200.0, "prandtl_glauert", 1.0 / std::sqrt(1.0 - mach * mach)}, Case{200.0, "none", 1.0},
                        Case{300.0, "prandtl_glauert", 5.0 / 3.0}}) {
    Scenario s =
        jammed({2.0, 2.0, 2.0, 2.0}, {"controller.proportional_gain=0", "controller.derivative_gain_s=0",
                                      "servo.backlash_deg=0", std::string{"aerodynamics.compressibility="} + c.kind});
    s.tunnel = {.fan_rpm = 1000.0, .speed_per_rpm_m_s = c.speed_m_s / 1000.0};
    const double damping_per_s = c.factor * 0.5 * 1.2 * c.speed_m_s * 5.0265e-5 * alpha_m2 / 0.00393;
    const double final_rad_s = c.speed_m_s * beta_m * 2.0 * degree / alpha_m2;
    std::optional<double> from_s;
    for (const Tick& tick : fly(s).ticks) {
      if (tick.time_s > 0.3 && (from_s || tick.truth.canard_rad > 1.0 * degree)) {
        from_s = from_s.value_or(tick.time_s);
        ASSERT_NEAR(tick.truth.roll_rate_rad_s, -final_rad_s * std::expm1(-damping_per_s * (tick.time_s - *from_s)),
                    1e-9)
            << c.speed_m_s << " " << c.kind;
      }
    }
    EXPECT_TRUE(from_s);
  }
}

TEST(Compressibility, AloneLeavesTheStraightFlightAsItIs) {
  const FlownWorld constant = fly("tasha3_launch2", {"disturbance.angles_deg=[0]"});
  const FlownWorld growing =
      fly("tasha3_launch2", {"disturbance.angles_deg=[0]", "aerodynamics.compressibility=prandtl_glauert"});
  EXPECT_EQ(growing.ticks.back().truth.height_m, constant.ticks.back().truth.height_m);
  EXPECT_EQ(growing.events.apogee, constant.events.apogee);
}

TEST(DragOverMach, CountsInBothMotions) {
  for (const char* motion : {"straight", "six_dof"}) {
    const std::string flown = std::string{"flight.motion="} + motion;
    const double usual_m = fly("tasha3_launch2", {flown}).ticks.back().truth.height_m;
    const double same_m = fly("tasha3_launch2", {flown, "body.drag_mach=[0.1, 0.9]", "body.drag_factor=[1, 1]"})
                              .ticks.back()
                              .truth.height_m;
    const double more_m = fly("tasha3_launch2", {flown, "body.drag_mach=[0.1, 0.2]", "body.drag_factor=[1, 1.5]"})
                              .ticks.back()
                              .truth.height_m;
    const double half_m =
        fly("tasha3_launch2", {flown, "body.drag_mach=[0]", "body.drag_factor=[2]", "body.drag_area_m2=0.0025"})
            .ticks.back()
            .truth.height_m;
    EXPECT_EQ(same_m, usual_m);
    EXPECT_LT(more_m, usual_m - 5.0);
    EXPECT_NEAR(half_m, usual_m, 1e-9);
  }
}

}  // namespace
}  // namespace fantail::sim
