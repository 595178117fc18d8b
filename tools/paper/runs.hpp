// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "identify/model/roll_model.hpp"
#include "input/scenario_file.hpp"
#include "page/chart.hpp"
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

/// A chart of a page on which two stand side by side, as a figure.
[[nodiscard]] std::string half_width_figure(page::Chart chart, const std::string& caption);

/// What a row of a flight contributes to a curve; not a number where there is nothing.
using RowValue = std::function<double(const flight::Row&)>;

/// A curve of a run over its clock (minus `zero_s`) between two times of that clock.
struct Stretch {
  double zero_s = 0.0;
  double from_s = 0.0;
  double to_s = 0.0;
};
[[nodiscard]] page::Series curve(const Run& run, const Stretch& stretch, std::string name, page::Role role,
                                 const RowValue& value);

/// A list over another, both as they are.
[[nodiscard]] page::Series curve(const std::vector<double>& x, std::vector<double> y, std::string name,
                                 page::Role role);

[[nodiscard]] double true_angle_deg(const flight::Row& row);
[[nodiscard]] double true_rate_deg_s(const flight::Row& row);
[[nodiscard]] double true_canard_deg(const flight::Row& row);
[[nodiscard]] double true_disturbance_deg(const flight::Row& row);

}  // namespace fantail::paper
