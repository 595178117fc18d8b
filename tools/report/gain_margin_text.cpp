// SPDX-License-Identifier: MIT
#include "report/gain_margin_text.hpp"

#include "text/number.hpp"

namespace fantail::report {

std::string gain_margin_text(const flight::LoopMargin& margin) {
  if (!margin.gain_margin) {
    return "any";
  }
  const bool swings_with_less = (margin.phase_margin_rad > 0.0) == (*margin.gain_margin < 1.0);
  return text::brief(*margin.gain_margin, 1) + (swings_with_less ? ", and swings with less" : "");
}

}  // namespace fantail::report
