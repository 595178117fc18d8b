// SPDX-License-Identifier: MIT
#include "flight/gate.hpp"

#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "core/roll_reference.hpp"
#include "text/number.hpp"

namespace fantail::flight {
namespace {

using Until = core::DormantUntil;

struct Gate {
  bool burn_out;
  bool pressure;
  bool height;
};

Gate gate_of(const Flight& flight) {
  const Until until = flight.known.plan ? flight.plan.dormancy.until : Until::guide;
  return {.burn_out = until == Until::burn_out || until == Until::burn_out_and_height,
          .pressure = until == Until::max_dynamic_pressure || until == Until::max_dynamic_pressure_and_height,
          .height = gate_height_m(flight).has_value()};
}

std::string height(const Flight& flight) {
  return text::brief(static_cast<double>(flight.plan.dormancy.height_m), 1) + " m";
}

/// Both, or the one that is there.
std::string both(const std::string& one, const std::string& other) {
  return one.empty() || other.empty() ? one + other : fmt::format("{} and {}", one, other);
}

}  // namespace

bool has_gate(const Flight& flight) { return flight.known.plan && flight.plan.dormancy.until != Until::guide; }

bool shows_gate(const Flight& flight) { return has_gate(flight) || captures(flight) || flight.events.dormant_s; }

std::string gate_name(const Flight& flight) {
  if (!has_gate(flight)) {
    return "the plan's gate";
  }
  const Gate gate = gate_of(flight);
  return both(gate.burn_out   ? "burn-out"
              : gate.pressure ? "the largest dynamic pressure"
                              : "",
              gate.height ? height(flight) : "");
}

std::string gate_has_opened(const Flight& flight) {
  if (!has_gate(flight)) {
    return "the plan's gate opened";
  }
  const Gate gate = gate_of(flight);
  return both(gate.burn_out   ? "burn-out detected"
              : gate.pressure ? "past the largest dynamic pressure"
                              : "",
              gate.height ? "the low end of its height above " + height(flight) : "");
}

std::string gate_has_closed(const Flight& flight) {
  const Gate gate = gate_of(flight);
  return gate.burn_out   ? "the motor pushes again"
         : gate.pressure ? "the dynamic pressure rises again"
                         : "the plan's gate closed again";
}

std::optional<double> gate_height_m(const Flight& flight) {
  const Until until = flight.plan.dormancy.until;
  const bool waits =
      until == Until::height || until == Until::burn_out_and_height || until == Until::max_dynamic_pressure_and_height;
  return flight.known.plan && waits ? std::optional{static_cast<double>(flight.plan.dormancy.height_m)} : std::nullopt;
}

bool captures(const Flight& flight) {
  return flight.known.plan && flight.plan.controller.entry == core::ControlEntry::capture;
}

std::optional<double> chosen_turn(const Flight& flight, const Row& first_under_control, double since_control_start_s) {
  if (!captures(flight) || !std::isfinite(first_under_control.reference_rad)) {
    return std::nullopt;
  }
  const core::Angle planned =
      core::roll_reference(flight.plan.reference, core::Microseconds{std::llround(1e6 * since_control_start_s)});
  const double added_rad = first_under_control.reference_rad - static_cast<double>(planned.radians());
  return std::round(added_rad / (2.0 * std::numbers::pi)) + 0.0;
}

}  // namespace fantail::flight
