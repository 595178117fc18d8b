// SPDX-License-Identifier: MIT
#include "phase_sequence.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using Step = std::function<void(Sequence&)>;

void expect_abort(const Step& begin, Phase from, Phase to) {
  Sequence sequence;
  begin(sequence);
  ASSERT_EQ(sequence.phases().phase(), from);
  EXPECT_TRUE(sequence.tick([](Tick& i) { i.abort = true; }));
  sequence.expect(to, PhaseReason::aborted);
  EXPECT_FALSE(sequence.tick()) << "it does not come back when nobody asks any more";
  sequence.expect(to, PhaseReason::aborted);
}

void to_controlling(Sequence& sequence) { sequence.arm().launch().clear_guide(); }

TEST(Abort, InArmedMakesTheRocketSafe) {
  expect_abort([](Sequence& s) { s.arm(); }, Phase::armed, Phase::safe);
}

TEST(Abort, InEveryPhaseOfAFlightEndsIt) {
  expect_abort([](Sequence& s) { s.arm().launch(); }, Phase::launched, Phase::finished);
  expect_abort(to_controlling, Phase::controlling, Phase::finished);
  expect_abort(
      [](Sequence& s) {
        s.next.gate_is_open = false;
        to_controlling(s);
      },
      Phase::dormant, Phase::finished);
  expect_abort(
      [](Sequence& s) {
        to_controlling(s);
        s.next.gate_is_open = false;  // it closes again
        s.tick();
      },
      Phase::dormant, Phase::finished);
}

TEST(Abort, ComesBeforeALaunchAGuideAndAGateInTheSameTick) {
  Sequence sequence;
  sequence.arm();
  sequence.tick([](Tick& i) { i.abort = i.launch_detected = true; });
  sequence.expect(Phase::safe, PhaseReason::aborted);
  Sequence launched;
  launched.arm().launch();
  launched.next.abort = true;
  launched.clear_guide().expect(Phase::finished, PhaseReason::aborted);
}

TEST(Abort, ARocketThatIsAskedToAbortIsNotArmed) {
  Sequence sequence;
  sequence.next.abort = true;
  sequence.arm().expect(Phase::safe, PhaseReason::power_on);
  sequence.next.abort = false;
  sequence.arm().expect(Phase::armed, PhaseReason::armed_by_switch_and_command);
}

TEST(Abort, ChangesNothingInSafeAndAfterAFlight) {
  Sequence safe;
  EXPECT_FALSE(safe.tick([](Tick& i) { i.abort = true; }));
  Sequence flown;
  to_controlling(flown);
  flown.next.motion.vertical_speed_m_s = -0.1F;
  flown.tick();
  EXPECT_FALSE(flown.tick([](Tick& i) { i.abort = true; }));
  flown.expect(Phase::finished, PhaseReason::apogee);
}

TEST(Abort, EndsATunnelRunToo) {
  FlightPlan plan = default_plan();
  plan.run.start = Start::tunnel;
  Sequence tunnel{plan};
  tunnel.arm().start_tunnel().expect(Phase::controlling, PhaseReason::tunnel_start_command);
  tunnel.tick([](Tick& i) { i.abort = true; });
  tunnel.expect(Phase::finished, PhaseReason::aborted);
}

}  // namespace
}  // namespace fantail::core
