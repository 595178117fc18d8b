// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"

namespace fantail::report {
namespace {

TEST(GainMarginText, SaysWhereLessGainIsWhatMakesTheLoopSwing) {
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0, .gain_margin = 3.21}), "3.2 times");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0, .gain_margin = 0.4}), "0.4 times, and swings with less");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0}), "any");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = -0.2, .gain_margin = 0.7}), "0.7 times");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = -0.2, .gain_margin = 1.5}), "1.5 times, and swings with less");
}

TEST(DifferentMargins, OfThoseThatArePrintedAlikeTheWorstIsShown) {
  const auto margin = [](double speed_m_s, double degrees) {
    return flight::LoopMargin{.speed_m_s = speed_m_s, .phase_margin_rad = text::radians(degrees)};
  };
  flight::Flight flight;
  flight.loop_margins = {margin(21.9, 56.2), margin(22.0, 55.9), margin(22.4, 56.4), margin(22.4, 50.0)};
  const std::vector<flight::LoopMargin> shown = different_margins(flight);
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown[0].speed_m_s, 22.0);
  EXPECT_EQ(shown[1].speed_m_s, 22.4);
}

}  // namespace
}  // namespace fantail::report
