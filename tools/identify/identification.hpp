// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "identify/closed_loop/loop.hpp"
#include "identify/model/least_squares.hpp"
#include "identify/model/roll_model.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify {

/// Nodes at an even distance over the record: `intervals` of them between `intervals` + 1 nodes; 0: a constant.
struct EvenNodes {
  std::size_t intervals = 1;
};
/// The number of intervals from 1 to `most` beyond which one more is not worthwhile.
struct AutomaticNodes {
  std::size_t most = 6;
};
/// Times in seconds, one table of them, or even ones, or as many as it takes.
using NodeChoice = std::variant<model::NodeTimes, EvenNodes, AutomaticNodes>;

struct Options {
  NodeChoice nodes = EvenNodes{1};  ///< times count from the begin of the record
  result::Method method = result::Method::continuous;
  std::optional<closed_loop::Control> closed_loop{};  ///< empty: open loop
  model::Grid grid{};
  model::Start start = model::Start::measured;
  model::Loss loss = model::Loss::squares;  ///< Huber's: continuous, open loop, a lag that is known, Start::fitted
  bool with_uncertainty = true;
  bool with_error_map = true;  ///< also for the continuous method, for the picture, which shows its answer
};

/// Finds alpha, beta and the disturbance in a record. Throws text::Error (bad_data) when there are fewer samples
/// than unknowns, or when the record's speed is nowhere above zero; (bad_configuration) for nodes that no sample lies
/// between.
[[nodiscard]] result::Identification identify(const model::Record& record, const model::Airframe& airframe,
                                              const Options& options);

}  // namespace fantail::identify
