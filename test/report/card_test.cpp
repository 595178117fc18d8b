// SPDX-License-Identifier: MIT
#include "report/card.hpp"

#include <gtest/gtest.h>

#include "synthetic_flight.hpp"

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
                           "turned by 0.00", "Simulated, seed 7.", "turns, as flown"}) {
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
