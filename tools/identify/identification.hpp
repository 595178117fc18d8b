// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/flight_plan.hpp"
#include "identify/estimate.hpp"
#include "identify/record.hpp"
#include "identify/uncertainty.hpp"

namespace fantail::identify {

/// What a model begins each segment with.
enum class Start : std::uint8_t {
  measured,  ///< the first measured angle and rate, as published
  fitted,    ///< two more unknowns
};

/// Nodes at an even distance over the record: `intervals` of them between `intervals` + 1 nodes; 0: a constant.
struct EvenNodes {
  std::size_t intervals = 1;
};
/// So many intervals from 1 to `most` that one more is not worth it.
struct AutomaticNodes {
  std::size_t most = 6;
};
/// Times in seconds from the begin of the record, one table of them, or even ones, or as many as it takes.
using NodeChoice = std::variant<NodeTimes, EvenNodes, AutomaticNodes>;

/// How the canards were commanded, for the closed loop.
struct ClosedLoop {
  core::ControllerPlan controller{};
  double servo_lag_s = 0.0;            ///< first-order, between command and canard; 0: none, as published
  double controller_period_s = 0.001;  ///< the law runs as often, whatever the log's rate
};

struct Options {
  NodeChoice nodes = EvenNodes{1};
  Method method = Method::continuous;
  std::optional<ClosedLoop> closed_loop{};  ///< empty: open loop
  Grid grid{};
  Start start = Start::measured;
  bool with_uncertainty = true;
  bool with_error_map = true;  ///< also for the continuous method, for the picture
};

/// One line of the curve over the number of intervals.
struct NodeTrial {
  std::size_t intervals;
  Model model;
  double mean_abs_angle_error_rad;
};

struct Identification {
  Method method = Method::continuous;
  Loop loop = Loop::open;
  Model model{};
  Simulation simulation{};
  std::optional<Uncertainty> uncertainty{};
  std::optional<ErrorMap> error_map{};
  std::vector<NodeTrial> node_trials{};  ///< AutomaticNodes only
  std::vector<std::string> remarks{};    ///< the winner lies on the edge of the grid, ...
  std::size_t samples = 0;
  double seconds = 0.0;  ///< length of the record
};

/// Throws sim::InputError (bad_data) when there are fewer samples than unknowns, or when the record's speed is nowhere
/// above zero; (bad_configuration) for nodes that no sample lies between.
[[nodiscard]] Identification identify(const Record& record, const Airframe& airframe, const Options& options);

}  // namespace fantail::identify
