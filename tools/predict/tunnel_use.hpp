// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "predict/airframe.hpp"
#include "predict/tunnel_result.hpp"
#include "sim/scenario.hpp"

// What the steps of a tunnel say of the vehicle that is to fly.
namespace fantail::predict {

/// Throws text::Error for steps of a vehicle with another name than the scenario's. A file that does not say whose they
/// are is taken.
void require_same_vehicle(const sim::Scenario& scenario, const TunnelResult& tunnel);

/// Damping and torque for the reference area of the vehicle, which they scale inversely with.
[[nodiscard]] TunnelResult for_vehicle(const sim::Scenario& scenario, TunnelResult tunnel);

/// The range of the vehicle's reference area, where the steps do not say which one they were identified with.
[[nodiscard]] std::optional<AreaFactor> area_factor(const sim::Scenario& scenario, const TunnelResult& tunnel);

// A sentence each.

[[nodiscard]] std::string whose_rows(const sim::Scenario& scenario, const TunnelResult& tunnel);
/// What is identified is the product of an area with damping and torque.
[[nodiscard]] std::string which_area(const sim::Scenario& scenario, const TunnelResult& tunnel);
/// What was identified with the fins on has their wash in it. Empty for a vehicle without wash.
[[nodiscard]] std::optional<std::string> wash_in_rows(const sim::Scenario& scenario, const TunnelResult& tunnel);

}  // namespace fantail::predict
