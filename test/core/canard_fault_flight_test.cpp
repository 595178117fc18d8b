// SPDX-License-Identifier: MIT
// From what the encoders say to what the canards are told, with no verdict set by hand.

#include "rocket.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr std::size_t broken = 2;

// kp of 0.5: at roll angles of -10 and -30 degrees 5 and 15 are wanted. Three at the plan limit of 9 and the broken one
// where it stands make (27 + at) / 4 at most.
TEST(CanardFaultFlight, TheCanardThatStandsStillIsNamedAndTheOthersTakeItsShareWithinTheirLimits) {
  FlightPlan plan = default_plan();
  plan.run.canard_fault = CanardFaultPolicy::share;
  plan.excitation.form = ExcitationForm::none;
  plan.reference = {};
  for (const double roll_deg : {-10.0, -30.0}) {
    for (const Angle at : {-9_deg, 0_deg, 25_deg}) {
      Rocket rocket{plan};
      rocket.fly_to_control();
      rocket.run(ms(100), 20.0, roll_deg * static_cast<double>(pi) / 18.0);
      rocket.inputs_changed_by([at](Inputs& inputs) { inputs.encoders[broken] = at; });
      for (int i = 0; i < 600; ++i) {
        const TickRecord& record = rocket.tick(20.0);
        ASSERT_EQ(record.phase, Phase::controlling);
        for (std::size_t c = 0; c < canard_count; ++c) {
          ASSERT_LE(abs(record.canards[c].angle), plan.controller.canard_limit) << at.degrees() << " at " << i;
          ASSERT_TRUE(c == broken || record.verdicts[c] == CanardVerdict::healthy) << c << " at " << i;
        }
      }
      const TickRecord& record = rocket.record();
      EXPECT_NE(name(record.verdicts[broken]), name(CanardVerdict::healthy)) << at.degrees();
      const float wanted_deg = -0.5F * static_cast<float>(roll_deg);
      const float reach_deg = (27.0F + at.degrees()) / 4.0F;
      EXPECT_NEAR(record.canard_angle.value_or(90_deg).degrees(), std::min(wanted_deg, reach_deg), 0.05F)
          << "the four together, at " << at.degrees();
      EXPECT_EQ(record.saturated, wanted_deg > reach_deg) << at.degrees();
    }
  }
}

}  // namespace
}  // namespace fantail::core
