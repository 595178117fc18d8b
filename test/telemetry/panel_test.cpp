// SPDX-License-Identifier: MIT
#include "telemetry/panel.hpp"

#include "degree.hpp"
#include "json/value.hpp"
#include "test.hpp"

namespace fantail::telemetry {
namespace {

using hal::Microseconds;
using Json = json::Value;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class PanelTest : public ::testing::Test {
 protected:
  template <typename Content>
  void hear(const Content& content, std::int64_t sequence, Microseconds now) {
    const Packet packet = encode(Stamp{.run = 1, .sequence = sequence, .time = Microseconds{12'340'000}}, content);
    receiver.take(name(packet.channel), packet.content(), now);
  }
  void hear_all(Microseconds now) {
    Canards canards;
    canards.command_rad = {1.0 * degree, 2.0 * degree, {}, 4.0 * degree};
    canards.encoder_rad = {1.5 * degree, {}, 3.0 * degree, 4.0 * degree};
    canards.limit_rad = {9.0 * degree, 9.0 * degree, 6.0 * degree, 9.0 * degree};
    canards.verdicts = {core::CanardVerdict::healthy, core::CanardVerdict::dead, {}, core::CanardVerdict::healthy};
    hear(State{.phase = core::Phase::controlling,
               .reason = core::PhaseReason::guide_clear,
               .saturated = true,
               .roll_angle_rad = -30.0 * degree,
               .roll_rate_rad_s = 5.0 * degree,
               .command_rad = 6.0 * degree,
               .height_m = 100.0},
         0, now);
    hear(canards, 0, now);
    hear(Health{.gyro = core::SensorState::fresh, .accelerometer = core::SensorState::lost, .late_ticks = 2}, 0, now);
  }

  Receiver receiver;
  Panel panel{"udpm://", receiver};
};

TEST_F(PanelTest, SaysThatNobodySpeaks) {
  panel.look(Microseconds{5});
  EXPECT_PRED2(contains, panel.table(), "udpm://  SILENT: nothing received yet");
  EXPECT_PRED2(contains, panel.lines(), "link: SILENT");
  const Json object = json::parse(panel.json());
  EXPECT_EQ(object["link"], "silent");
  EXPECT_EQ(object["state"]["stale"], true);
  EXPECT_TRUE(object["state"]["roll_angle_deg"].is_null());
  EXPECT_TRUE(object["state"]["saturated"].is_null());
}

TEST_F(PanelTest, ShowsDegreesAndADashForWhatIsNotKnown) {
  hear_all(Microseconds{0});
  panel.look(Microseconds{200'000});
  const std::string table = panel.table();
  EXPECT_PRED2(contains, table, "udpm://  live, 12.34 s since power-up");
  EXPECT_PRED2(contains, table, "phase controlling (guide_clear)");
  EXPECT_PRED2(contains, table, "roll -30.00 deg, rate +5.00 deg/s; reference - deg, excitation - deg");
  EXPECT_PRED2(contains, table, "command +6.00 of 6.00 deg, SATURATED");
  EXPECT_PRED2(contains, table, " m/s along the guide");
  EXPECT_PRED2(contains, panel.lines(), " m/s along the guide; link: ");
  EXPECT_PRED2(contains, table, "       1    +1.00     +1.50       +0.50    9.00  healthy\n");
  EXPECT_PRED2(contains, table, "       2    +2.00         -           -    9.00  dead\n");
  EXPECT_PRED2(contains, table, "       3        -     +3.00           -    6.00  unknown\n");
  EXPECT_PRED2(contains, table, "gyro fresh, accelerometer lost, 2 late ticks\n");
  EXPECT_FALSE(contains(table, "STALE"));
}

TEST_F(PanelTest, ARollOfNothingHasNoMinus) {
  hear(State{.roll_angle_rad = -1e-6}, 1, Microseconds{0});
  panel.look(Microseconds{0});
  EXPECT_PRED2(contains, panel.table(), "roll +0.00 deg");
}

TEST_F(PanelTest, WhatIsOldSaysSoAtItsPlaceAndTheRestIsLive) {
  hear_all(Microseconds{0});
  hear(State{.roll_angle_rad = 1.0}, 1, Microseconds{3'000'000});
  panel.look(Microseconds{3'500'000});
  const std::string table = panel.table();
  EXPECT_PRED2(contains, table, "motion  live\n");
  EXPECT_PRED2(contains, table, "canards  STALE, 3.5 s old\n");
  EXPECT_PRED2(contains, table, "health  STALE, 3.5 s old\n");
  const Json object = json::parse(panel.json());
  EXPECT_EQ(object["state"]["stale"], false);
  EXPECT_EQ(object["canards"]["stale"], true);
  EXPECT_EQ(object["canards"]["age_s"], 3.5);
}

TEST_F(PanelTest, ASilentSenderMakesEverythingStale) {
  hear_all(Microseconds{0});
  panel.look(Microseconds{1'000'000});
  EXPECT_PRED2(contains, panel.lines(), "12.340 s  controlling");
  panel.look(Microseconds{1'000'001});
  EXPECT_PRED2(contains, panel.table(), "STALE for 1.0 s");
  EXPECT_PRED2(contains, panel.lines(), "12.340 s  STALE: controlling");
  EXPECT_EQ(json::parse(panel.json())["link"], "stale");
}

TEST_F(PanelTest, EventsAreToldOnceInLinesAndStayInTheTable) {
  hear_all(Microseconds{0});
  hear(Event{.phase = Event::PhaseChange{.before = core::Phase::armed,
                                         .phase = core::Phase::launched,
                                         .reason = core::PhaseReason::launch_detected}},
       0, Microseconds{0});
  hear(Event{.verdict = Event::VerdictChange{.canard = 2, .verdict = core::CanardVerdict::stalled}}, 1,
       Microseconds{0});
  panel.look(Microseconds{200'000});
  EXPECT_TRUE(
      panel.lines().starts_with("12.340 s  event: armed -> launched (launch_detected)\n"
                                "12.340 s  event: canard 3: healthy -> stalled\n"))
      << panel.lines();
  EXPECT_EQ(json::parse(panel.json())["events"].size(), 2U);
  panel.look(Microseconds{400'000});
  EXPECT_FALSE(contains(panel.lines(), "event"));
  EXPECT_PRED2(contains, panel.table(), "event  12.340 s  canard 3: healthy -> stalled\n");
}

TEST_F(PanelTest, TheLinkIsShownChannelByChannel) {
  for (const std::int64_t sequence : {0, 1, 2, 6, 4, 4}) {
    hear(State{}, sequence, Microseconds{500'000});
  }
  panel.look(Microseconds{1'000'000});
  EXPECT_PRED2(contains, panel.table(),
               "  FANTAIL_STATE         5.0         5       2       1          1        0           0\n");
  EXPECT_PRED2(contains, panel.lines(), "link: live, 5 received, 2 lost, 1 late, 1 duplicate in 1 s");
  const Json total = json::parse(panel.json())["channels"]["FANTAIL_STATE"]["total"];
  EXPECT_EQ(total["received"], 5);
  EXPECT_EQ(total["lost"], 2);
  EXPECT_EQ(total["late"], 1);
  EXPECT_EQ(total["duplicate"], 1);
}

}  // namespace
}  // namespace fantail::telemetry
