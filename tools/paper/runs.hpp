// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "flight/flight.hpp"
#include "identify/model/roll_model.hpp"
#include "input/scenario_file.hpp"
#include "paper/runs.hpp"
#include "tunnel/swirl.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::paper {

/// One of the published runs, flown in the simulated world.
struct Run {
  sim::Scenario scenario;
  flight::Flight flight;
};

/// Says what is going on; what it throws ends the work.
using Tell = std::function<void(const std::string& what)>;

[[nodiscard]] Run fly(const std::string& scenario, std::span<const input::Override> changes, const Tell& tell);

/// Where a record takes its canard angle from. They differ where fins take torque of the canards back.
enum class Canards : std::uint8_t { as_the_air_sees_them, as_encoders_read };

/// The truth of a run from one time of its clock to another, a sample every `every_s`: an ideal log. Excitation and
/// reference with it, for the closed loop.
[[nodiscard]] identify::model::Record true_record(const Run& run, double from_s, double to_s, double every_s,
                                                  Canards canards = Canards::as_the_air_sees_them);

[[nodiscard]] identify::model::Airframe airframe(const sim::Scenario& scenario);

/// What the tunnel's own instruments would have logged in this run.
[[nodiscard]] tunnel::TunnelLog wind_log(const Run& run);

/// A run in which the rocket rolled freely, as its log would show it.
[[nodiscard]] tunnel::RollSession roll_session(const Run& run);

}  // namespace fantail::paper
