// SPDX-License-Identifier: MIT
#include "report/card.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "report/card_text.hpp"
#include "synthetic_flight.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

std::string card_of(const flight::Flight& flight) {
  const Figures f = figures(flight);
  return card_svg(flight, f, verdict(flight, f));
}

bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Card, SaysVerdictFiguresAndWhereTheyComeFrom) {
  SyntheticFlight synthetic;
  const std::string card = card_of(synthetic.flight);
  EXPECT_TRUE(card.starts_with("<svg ")) << card;
  for (const char* part :
       {">synthetic<", "paper dart", ">Held<", "Steady, 10.0 deg from the command", "3.9 s under control",
        "turned by 0.00", "Simulated, seed 7.", "roll angle in degrees, as flown"}) {
    EXPECT_TRUE(holds(card, part)) << part;
  }
  EXPECT_TRUE(holds(card, ">turned by 0.00 turns under control<")) << "the end of control is not in these rows";
  EXPECT_FALSE(holds(card, "without control"));
  EXPECT_FALSE(holds(card, "nan"));
  synthetic.end_control(4.4, core::PhaseReason::apogee);
  EXPECT_TRUE(holds(card_of(synthetic.flight), ">turned by 0.00 turns under control, 0.6 s to 4.4 s<"));
  synthetic.flight.seed.reset();
  EXPECT_TRUE(holds(card_of(synthetic.flight), "From a log."));
}

TEST(Card, ShowsWhatControlWasWorthWhereThatIsKnown) {
  SyntheticFlight synthetic;
  synthetic.flight.without_control = {
      {.time_s = -1.0}, {.time_s = 0.0, .true_roll_angle_rad = 5.0}, {.time_s = 4.5, .true_roll_angle_rad = 27.5}};
  const std::string card = card_of(synthetic.flight);
  EXPECT_TRUE(holds(card, "\u2013 \u2013 without control"));
  EXPECT_TRUE(holds(card, "without control by 3.10 turns"));  // 5 rad/s for 3.9 s
}

TEST(Card, ARollOfHalfATurnIsDrawnInTurnsAndASmallerOneInDegrees) {
  SyntheticFlight synthetic;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad = text::radians(179.0); });
  const std::string smaller = card_of(synthetic.flight);
  EXPECT_TRUE(holds(smaller, "roll angle in degrees") && holds(smaller, ">100<")) << smaller;
  synthetic.each_controlled([](flight::Row& row) { row.truth->roll_angle_rad = text::radians(181.0); });
  const std::string half = card_of(synthetic.flight);
  EXPECT_TRUE(holds(half, "roll angle in turns") && holds(half, ">0.2<")) << half;
}

TEST(Card, SaysTheWholeOfALongVerdictAndWhatWasChangedOnTheCommandLine) {
  SyntheticFlight synthetic;
  synthetic.flight.changes = {"controller.canard_limit_deg=9", "wind.speed_m_s=5"};
  const Figures f = figures(synthetic.flight);
  Verdict v = verdict(synthetic.flight, f);
  v.text = "Begins.";
  for (int i = 0; i < 40; ++i) {
    v.text += " A sentence";  // 447 characters in all
  }
  v.text += " ends.";
  const std::string card = card_svg(synthetic.flight, f, v);
  EXPECT_TRUE(holds(card, " ends.</text>")) << card;
  EXPECT_FALSE(holds(card, "\u2026")) << card;
  EXPECT_TRUE(
      holds(card, "Simulated, seed 7. Changed on the command line: controller.canard_limit_deg=9, wind.speed_m_s=5."));
}

double size_at(const std::string& card, std::size_t place) {
  const std::string_view tag = "font-size=\"";
  return std::stod(card.substr(card.rfind(tag, place) + tag.size()));
}

// Everything that the verdict can say at once.
TEST(Card, SaysTheWholeOfTheLongestVerdict) {
  SyntheticFlight synthetic;
  flight::Flight& flight = synthetic.flight;
  flight.events.apogee_s = 4.4;
  flight.trajectory_end_s = 4.5;
  flight.loop_margins = {{20.0, text::radians(55.0), 12.0}, {47.0, text::radians(-10.0), 0.7}};
  flight.unmeasured = {.spin_from_s = 0.8,
                       .spin_for_s = 0.4,
                       .spin_rad_s = text::radians(-2000.0),
                       .silent_from_s = 2.0,
                       .silent_for_s = 0.012,
                       .speed_bound_from_s = 0.3};
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    flight.canard_verdict_changes.push_back({1.0, canard, core::CanardVerdict::stalled});
    flight.canard_verdict_changes.push_back({1.2, canard, core::CanardVerdict::healthy});
    flight.canard_verdict_changes.push_back({1.4, canard, core::CanardVerdict::slipping});
  }
  for (int reset = 0; reset < 30; ++reset) {
    const double from_s = 1.0 + 0.05 * reset;
    flight.outages.push_back({.from_s = from_s, .to_s = from_s + 0.01, .cause = "watchdog", .resumed = true});
  }
  flight.plan.controller.canard_limit = core::Angle::from_degrees(6.0F);
  synthetic.each_controlled([](flight::Row& row) {
    row.truth->disturbance_rad = text::radians(-7.3);
    row.truth->canard_rad = text::radians(3.5 + 4.8 * std::sin(80.0 * row.time_s));
    row.command_rad = text::radians(6.0);
    row.saturated = true;
  });
  synthetic.end_control(3.0, core::PhaseReason::gyro_failed);
  const std::string verdict = verdict_of(flight).text;
  EXPECT_GT(verdict.size(), 1400U) << verdict;
  const std::string card = card_of(flight);
  EXPECT_FALSE(holds(card, "\u2026")) << card;
  EXPECT_TRUE(holds(card, "from 1.00 s to the end, healthy in between.</text>")) << card;
  EXPECT_GE(size_at(card, card.find("Until the trajectory")), 10.0);
}

// A third more room for each letter than it needs would be too much.
TEST(Card, NoNameAndNoVerdictRunsOffIt) {
  constexpr double room = 1136.0 - 64.0;
  SyntheticFlight synthetic;
  for (const char* letter : {"W", "m", "i", "a", "\u00e9", "\u6f22"}) {
    std::string name;
    for (int i = 0; i < 200; ++i) {
      name += letter;
    }
    synthetic.flight.vehicle = synthetic.flight.scenario = name;
    const std::string card = card_of(synthetic.flight);
    for (std::size_t at = card.find("\u2026</text>"); at != std::string::npos;
         at = card.find("\u2026</text>", at + 1)) {
      const std::size_t begin = card.rfind('>', at) + 1;
      const std::size_t tag = card.rfind("<text", at);
      const bool bold = card.substr(tag, begin - tag).find("bold") != std::string::npos;
      EXPECT_LE(width(card.substr(begin, at + 3 - begin), {size_at(card, at), bold}), room) << letter;
      EXPECT_GE(width(card.substr(begin, at + 3 - begin), {size_at(card, at), bold}), 0.8 * room) << letter;
    }
  }
  EXPECT_LE(width("WWWWWWWWWW", {10.0}), 100.0 * 1.1);
  EXPECT_GE(width("WWWWWWWWWW", {10.0}), 98.9);  // 0.989 em each in the font itself
  EXPECT_GE(width("WWWWWWWWWW", {10.0, true}), 110.3);
}

TEST(Card, DrawsNoLineOverATimeOfWhichNothingIsOnRecord) {
  SyntheticFlight synthetic;
  const auto pieces = [&synthetic] {
    const std::string card = card_of(synthetic.flight);
    const std::size_t end = card.find("\" fill=\"none\"");
    const std::size_t begin = card.rfind("d=\"", end);
    return std::count(card.begin() + static_cast<std::ptrdiff_t>(begin),
                      card.begin() + static_cast<std::ptrdiff_t>(end), 'M');
  };
  EXPECT_EQ(pieces(), 1);
  std::erase_if(synthetic.flight.rows, [](const flight::Row& row) { return row.time_s > 1.0 && row.time_s < 3.0; });
  EXPECT_EQ(pieces(), 2);
}

TEST(Card, KnowsWhichLettersItsFontLacks) {
  EXPECT_TRUE(needs_another_font("\u6f22\u5b57") && needs_another_font("\u304b") && needs_another_font("\ud55c"));
  EXPECT_FALSE(needs_another_font("Tasha III \u00b7 \u00e9\u03b1\u0416\u2026"));
}

TEST(Card, CutsBetweenCharactersAndShowsNoneThatXmlForbids) {
  SyntheticFlight synthetic;
  synthetic.flight.scenario.clear();
  for (int i = 0; i < 100; ++i) {
    synthetic.flight.scenario += "\u00e9";
  }
  synthetic.flight.vehicle = "paper\x01\x1b\xff dart";
  const std::string card = card_of(synthetic.flight);
  EXPECT_TRUE(holds(card, "\u00e9 \u2026</text>")) << card;
  EXPECT_TRUE(holds(card, "paper??? dart")) << card;
  EXPECT_EQ(card.find_first_of("\x01\x1b\xff"), std::string::npos);
}

TEST(Card, OfNoRowAndOfHostileAndEndlessNamesIsStillACard) {
  EXPECT_TRUE(card_of(flight::Flight{}).ends_with("</svg>\n"));
  SyntheticFlight synthetic;
  synthetic.flight.scenario = std::string(500, 'x');
  synthetic.flight.vehicle = "</text><script>";
  const std::string card = card_of(synthetic.flight);
  EXPECT_FALSE(holds(card, "<script>"));
  EXPECT_FALSE(holds(card, std::string(40, 'x')));
  EXPECT_TRUE(holds(card, "x \u2026"));
}

}  // namespace
}  // namespace fantail::report
