// SPDX-License-Identifier: MIT
#include <cmath>

#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {

std::string gain_margin_text(const flight::LoopMargin& margin) {
  if (!margin.gain_margin) {
    return "any";
  }
  const bool swings_with_less = (margin.phase_margin_rad > 0.0) == (*margin.gain_margin < 1.0);
  return text::brief(*margin.gain_margin, 1) + " times" + (swings_with_less ? ", and oscillates with less" : "");
}

std::vector<flight::LoopMargin> different_margins(const flight::Flight& flight) {
  std::vector<flight::LoopMargin> all;
  for (const flight::LoopMargin& margin : flight.loop_margins) {
    const auto same = [&margin](const flight::LoopMargin& other) {
      return std::round(other.speed_m_s) == std::round(margin.speed_m_s) &&
             std::round(text::degrees(other.phase_margin_rad)) == std::round(text::degrees(margin.phase_margin_rad));
    };
    if (all.empty() || !same(all.back())) {
      all.push_back(margin);
    } else if (margin.phase_margin_rad < all.back().phase_margin_rad) {
      all.back() = margin;
    }
  }
  return all;
}

}  // namespace fantail::report
