// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include "airframe/new_rocket.hpp"
#include "airframe/summary.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::airframe {

using text::degrees;
using text::fixed;

std::vector<std::string> what_decides(const model::BuildUp& b, const std::optional<FirstGains>& first,
                                      double canard_limit_rad) {
  std::vector<std::string> sentences;
  if (b.cant_as_canards) {
    const model::Estimate& cant = *b.cant_as_canards;
    const double most_deg = degrees(canard_limit_rad) / cant.value;
    const std::string least =
        std::isinf(cant.high) ? "none at all" : fixed(degrees(canard_limit_rad) / cant.high, 1) + " deg";
    sentences.push_back(fmt::format(
        "One degree of fin cant takes {} deg of the canards ({} by the method's error). With their limit of {} deg "
        "they "
        "undo a cant of {} deg, and of {} in the worst case. In flight less is held: see fantail predict.",
        fixed(cant.value, 2), range_text(cant, 2), fixed(degrees(canard_limit_rad), 0), fixed(most_deg, 1), least));
  }
  if (first && b.roll_torque_m3) {
    // Where the canards' torque and the damping are equal: 1/2 rho v2 A beta u = 1/2 rho v A alpha p.
    const auto rate_deg_s = [&](double speed_m_s) {
      return degrees(speed_m_s * b.roll_torque_m3->value / b.roll_damping_m4.value * canard_limit_rad);
    };
    sentences.push_back(
        fmt::format("At that limit the canards turn the rocket at up to {} deg/s at {} m/s, where control may begin. "
                    "At {} m/s, its top speed, it is {} deg/s; both are right within a factor of four.",
                    fixed(rate_deg_s(first->begin_speed_m_s), 0), fixed(first->begin_speed_m_s, 0),
                    fixed(first->highest_speed_m_s, 0), fixed(rate_deg_s(first->highest_speed_m_s), 0)));
  }
  return sentences;
}

}  // namespace fantail::airframe
