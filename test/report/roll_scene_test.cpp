// SPDX-License-Identifier: MIT

#include "report/answer.hpp"
#include "report/sections.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

std::size_t sample_at(const page::RollScene& scene, double time_s) {
  return static_cast<std::size_t>(std::lround((time_s - scene.begin_s) / scene.step_s));
}

TEST(RollScene, TurnsAsTheRocketTrulyDid) {
  SyntheticFlight synthetic;
  const page::RollScene scene = roll_scene(synthetic.flight, -0.4).value();
  EXPECT_DOUBLE_EQ(scene.begin_s, -0.4);
  EXPECT_DOUBLE_EQ(scene.step_s, 0.02);
  EXPECT_EQ(scene.roll_deg.size(), 246U);  // to 4.5 s
  EXPECT_NEAR(scene.roll_deg[sample_at(scene, 0.5)], 0.0, 1e-9);
  EXPECT_NEAR(scene.roll_deg[sample_at(scene, 3.0)], -10.0, 1e-9);
  EXPECT_TRUE(scene.without_control_deg.empty());
  EXPECT_EQ(scene.note.find("Without control"), std::string::npos);
}

TEST(RollScene, OfALogTurnsAsTheFlightComputerKnewItAndStandsUnknownInAGap) {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth.reset();
  }
  std::erase_if(synthetic.flight.rows, [](const flight::Row& row) { return row.time_s > 2.0 && row.time_s < 2.5; });
  const page::RollScene scene = roll_scene(synthetic.flight, -0.5).value();
  EXPECT_NEAR(scene.roll_deg[sample_at(scene, 1.5)], -10.0, 1e-9);
  EXPECT_TRUE(std::isnan(scene.roll_deg[sample_at(scene, 2.2)]));
  EXPECT_NE(scene.note.find("flight computer"), std::string::npos);
}

TEST(RollScene, TurnsACanardFromItsTrimInTheSenseOfRoll) {
  SyntheticFlight synthetic;
  auto& canards = synthetic.flight.plan.canards.each;
  canards[1].direction = core::Direction::reversed;
  canards[2].trim = core::Angle::from_degrees(1.0F);
  for (flight::Row& row : synthetic.flight.rows) {
    row.encoders_rad = {text::radians(4.0), text::radians(4.0), text::radians(4.0), std::nullopt};
    row.commands_rad[3] = text::radians(2.0);  // its encoder is silent
  }
  const page::RollScene scene = roll_scene(synthetic.flight, 0.0).value();
  EXPECT_NEAR(scene.canards_deg[0][10], 4.0, 1e-5);
  EXPECT_NEAR(scene.canards_deg[1][10], -4.0, 1e-5);
  EXPECT_NEAR(scene.canards_deg[2][10], 3.0, 1e-5);
  EXPECT_NEAR(scene.canards_deg[3][10], 2.0, 1e-5);
}

TEST(RollScene, HasASecondRocketWhereItIsKnownHowItWouldHaveRolled) {
  SyntheticFlight synthetic;
  synthetic.flight.events.control_end_s = 4.4;
  synthetic.flight.events.apogee_s = 4.0;
  synthetic.flight.without_control = {{.time_s = 0.0}, {.time_s = 4.0, .true_roll_angle_rad = 8.0 * std::numbers::pi}};
  const page::RollScene scene = roll_scene(synthetic.flight, 0.0).value();
  EXPECT_NEAR(scene.without_control_deg[sample_at(scene, 1.0)], 360.0, 1e-6);
  EXPECT_TRUE(std::isnan(scene.without_control_deg[sample_at(scene, 4.2)]));
  EXPECT_DOUBLE_EQ(scene.shown_s, 4.0);
  const Figures f = figures(synthetic.flight);
  EXPECT_NEAR(f.roll_turns_without_control.value_or(0.0), 0.0, 0.0) << "the flight goes on after it, so nobody knows";
  synthetic.flight.without_control.push_back({.time_s = 5.0, .true_roll_angle_rad = 10.0 * std::numbers::pi});
  // From 0.6 s to 4.5 s, at a turn a second.
  EXPECT_NEAR(figures(synthetic.flight).roll_turns_without_control.value(), 3.9, 1e-9);
  const Figures all = figures(synthetic.flight);
  const std::string page = result::html(answer(synthetic.flight, all, verdict(synthetic.flight, all)));
  const std::size_t turns = page.find("0.00 turns");
  ASSERT_NE(turns, std::string::npos);
  EXPECT_NE(page.substr(turns, page.find("</", turns) - turns).find(" 3.90"), std::string::npos);
}

TEST(RollScene, HasThePathAndTheWindOfAFlightThatGoesAnywhere) {
  SyntheticFlight synthetic;
  EXPECT_FALSE(roll_scene(synthetic.flight, 0.0)->path);
  synthetic.flight.path = {{.time_s = 0.0}, {.time_s = 2.0, .north_m = 3.0, .east_m = -4.0, .height_m = 50.0}};
  page::RollScene scene = roll_scene(synthetic.flight, 0.0).value();
  ASSERT_TRUE(scene.path);
  EXPECT_EQ(scene.path->height_m.size(), scene.roll_deg.size());
  EXPECT_DOUBLE_EQ(scene.path->north_m[sample_at(scene, 1.0)], 0.0);
  EXPECT_DOUBLE_EQ(scene.path->east_m[sample_at(scene, 3.0)], -4.0);
  EXPECT_FALSE(scene.path->wind);
  synthetic.flight.wind = {.speed_m_s = 5.0, .from_rad = text::radians(270.0), .height_m = 10.0};
  scene = roll_scene(synthetic.flight, 0.0).value();
  EXPECT_EQ(fantail::figures(scene.path->wind->words), Numbers{"5"});
  EXPECT_NE(scene.path->wind->words.find("west"), std::string::npos) << scene.path->wind->words;
  EXPECT_NEAR(std::sin(scene.path->wind->to_rad), 1.0, 1e-9);  // to the east
  synthetic.flight.path_frame = flight::PathFrame::plane;
  EXPECT_FALSE(roll_scene(synthetic.flight, 0.0)->path) << "nobody knows where it points";
}

TEST(RollScene, IsThereOnlyWhereARollAngleIsKnown) {
  SyntheticFlight synthetic;
  EXPECT_FALSE(roll_scene(flight::Flight{}, 0.0));
  EXPECT_FALSE(roll_scene(synthetic.flight, 4.5));  // one row
  for (flight::Row& row : synthetic.flight.rows) {
    row.truth.reset();
    row.roll_angle_rad = std::nan("");
  }
  EXPECT_FALSE(roll_scene(synthetic.flight, 0.0));
}

TEST(RollScene, OfALongRunHasNoMoreSamplesThanAPageCanCarry) {
  SyntheticFlight synthetic;
  std::vector<flight::Row>& rows = synthetic.flight.rows;
  for (int row = 0; row < 90'000; ++row) {
    rows.push_back(rows.back());
    rows.back().time_s += 0.01;
  }
  const page::RollScene scene = roll_scene(synthetic.flight, 0.0).value();
  EXPECT_LE(scene.roll_deg.size(), 3001U);
  EXPECT_NEAR(scene.begin_s + scene.step_s * static_cast<double>(scene.roll_deg.size() - 1), rows.back().time_s,
              scene.step_s);
}

TEST(CanardCharts, ShowHealthyCanardsAsABandAndEachOtherAloneAndAllOnDemand) {
  SyntheticFlight synthetic;
  for (flight::Row& row : synthetic.flight.rows) {
    row.encoders_rad = {text::radians(1.0), text::radians(2.0), text::radians(3.0), text::radians(8.0)};
  }
  const auto together = [&] { return charts(synthetic.flight).charts[2]; };
  ASSERT_EQ(together().areas.size(), 1U);
  EXPECT_EQ(together().areas[0].name, "all four, from trim");
  EXPECT_NEAR(together().areas[0].low[100], 1.0, 1e-5);
  EXPECT_NEAR(together().areas[0].high[100], 8.0, 1e-5);
  synthetic.flight.canard_verdict_changes = {{1.0, 3, core::CanardVerdict::stalled}};
  EXPECT_NEAR(together().areas[0].high[100], 3.0, 1e-5);
  EXPECT_EQ(together().series.back().name, "canard 4 (stalled)");
  EXPECT_NEAR(together().series.back().y[100], 8.0, 1e-5);
  EXPECT_EQ(charts(synthetic.flight).more.size(), 4U);
}

}  // namespace
}  // namespace fantail::report
