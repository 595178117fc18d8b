// SPDX-License-Identifier: MIT
#include "report/card.hpp"

#include <gtest/gtest.h>

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
  for (const char* part : {">synthetic<", "paper dart", ">Held<", "Roll stayed within 0.0 deg", "3.9 s under control",
                           "turned by 0.00", "Simulated, seed 7.", "roll angle in degrees, as flown"}) {
    EXPECT_TRUE(holds(card, part)) << part;
  }
  EXPECT_FALSE(holds(card, "without control"));
  EXPECT_FALSE(holds(card, "nan"));
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
