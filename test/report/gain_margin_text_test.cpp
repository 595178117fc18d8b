// SPDX-License-Identifier: MIT
#include "report/gain_margin_text.hpp"

#include <gtest/gtest.h>

namespace fantail::report {
namespace {

TEST(GainMarginText, SaysWhereLessGainIsWhatMakesTheLoopSwing) {
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0, .gain_margin = 3.21}), "3.2");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0, .gain_margin = 0.4}), "0.4, and swings with less");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = 1.0}), "any");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = -0.2, .gain_margin = 0.7}), "0.7");
  EXPECT_EQ(gain_margin_text({.phase_margin_rad = -0.2, .gain_margin = 1.5}), "1.5, and swings with less");
}

}  // namespace
}  // namespace fantail::report
