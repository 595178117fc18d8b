// SPDX-License-Identifier: MIT
#include "pin_watch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fantail::board {
namespace {

constexpr double most_us = 800.0;      // test/proof/canard_pulse.cpp, without its step
constexpr double at_limit_deg = 0.05;  // a modelled servo that is told the limit stands there

}  // namespace

PinWatch::PinWatch(BoardFlight& flight, const core::FlightPlan& plan, double from_s)
    : flight_{flight}, from_s_{from_s}, seen_{flight.board().chip.pulses().size()} {
  for (std::size_t i = 0; i < canards_.size(); ++i) {
    const core::CanardPlan& canard = plan.canards.each[i];
    const double us_per_radian = std::abs(double{canard.pulse_per_radian_us});
    const double stop_rad =
        std::min(double{canard.mechanical_stop.radians()}, double{core::hard_canard_limit.radians()});
    const double limit_rad = std::min(double{plan.controller.canard_limit.radians()}, stop_rad);
    canards_[i] = {.centre_us = canard.pulse_centre_us,
                   .plan_us = limit_rad * us_per_radian + pulse_step_us,
                   .hard_us = std::min(stop_rad * us_per_radian, most_us) + pulse_step_us,
                   .plan_deg = limit_rad * 180.0 / std::numbers::pi + at_limit_deg,
                   .last_s = from_s};
  }
}

void PinWatch::follow() {
  const std::vector<HeardPulse>& pulses = flight_.board().chip.pulses();
  for (; seen_ < pulses.size(); ++seen_) {
    if (pulses[seen_].end_s() >= from_s_) {
      canards_[pulses[seen_].line].last_s = pulses[seen_].end_s();
      look_at(pulses[seen_]);
    }
  }
  for (std::size_t i = 0; i < canards_.size(); ++i) {
    const double silent_ms = 1e3 * (flight_.board().now_s() - canards_[i].last_s);
    pins_.silence_ms = std::max(pins_.silence_ms, silent_ms);
    const bool beyond = std::abs(flight_.servo_deg(i)) > canards_[i].plan_deg;
    canards_[i].beyond_ms = beyond ? canards_[i].beyond_ms + 1.0 : 0.0;
    pins_.longest_beyond_ms = std::max(pins_.longest_beyond_ms, canards_[i].beyond_ms);
  }
}

void PinWatch::look_at(const HeardPulse& pulse) {
  if (!pulse.whole) {
    pins_.cut += 1;
    return;
  }
  const Canard& canard = canards_[pulse.line];
  const double far_us = std::abs(pulse.width_us - canard.centre_us);
  pins_.narrowest_us = std::min(pins_.narrowest_us, pulse.width_us);
  pins_.widest_us = std::max(pins_.widest_us, pulse.width_us);
  pins_.farthest_us = std::max(pins_.farthest_us, far_us);
  pins_.beyond_plan += far_us > canard.plan_us ? 1 : 0;
  pins_.beyond_hard += far_us > canard.hard_us ? 1 : 0;
}

}  // namespace fantail::board
