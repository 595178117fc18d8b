// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/model/roll_model.hpp"
#include "identify/result/findings.hpp"
#include "identify/study.hpp"

namespace fantail::identify {

// What changes over a flight while a model holds it constant, or counts with it.

/// A vehicle's roll inertia since ignition, put on the log's clock by the burn-out that the log shows. Empty where it
/// shows none; `warnings` then says that the inertia at lift-off is used.
[[nodiscard]] sim::RollInertiaCourse inertia_on_clock(const logs::RollLog& log,
                                                      const sim::RollInertiaCourse& since_ignition,
                                                      std::vector<std::string>& warnings);

/// Which roll inertia a window was identified with, where it is not the same throughout the flight.
[[nodiscard]] std::optional<std::string> remark_on_inertia(const model::Record& record,
                                                           const sim::RollInertiaCourse& course);

/// How much alpha and beta grow with the Mach number within a window, where that is worth a word. `grows`: as Question.
[[nodiscard]] std::optional<std::string> remark_on_mach(const model::Record& record, const std::optional<bool>& grows);

/// Everything that an alternative to what was found is held against.
struct DoubtCase {
  const model::Record& record;
  const model::Airframe& airframe;
  model::Start start;
  const result::Identification& found;
};

/// Of the reach of a 95 % interval: beyond it lies one estimate of a hundred. A doubt is raised no more often.
inline constexpr double one_of_hundred = 1.31;

/// Whether a model has another alpha or beta by more than they are said to be known, and by more than anybody needs to
/// know them.
[[nodiscard]] bool matters(const DoubtCase& c, const model::RollModel& other);

/// A node between each two, and for a constant one at either end; and whether a record has samples enough for them.
[[nodiscard]] model::NodeTimes twice_as_many(const model::Record& record, const model::NodeTimes& nodes);
[[nodiscard]] bool has_room_for(const model::Record& record, const model::NodeTimes& nodes);

/// "alpha 22.9 m2 instead of 20.1, beta 9.02 m instead of 8.21".
[[nodiscard]] std::string change(const model::RollModel& from, const model::RollModel& to);

/// A sentence where the canard column seems to come at another time than the gyro's. Where twice as many nodes of the
/// disturbance leave another lag, it says that either may be the cause.
[[nodiscard]] std::optional<std::string> lag_doubt(const DoubtCase& c);

/// The same for a lag beyond that which --fit-lag finds, up to 0.2 s. So far away the estimate from the slopes of the
/// canards tells nothing: each lag is tried, and one has to halve the error of the roll rate.
[[nodiscard]] std::optional<std::string> long_lag_doubt(const DoubtCase& c);

/// Sentences on what is likely wrong with a log or a model although the fit has converged, each with what to change:
/// the unit of the canard column; a lag of it, missing nodes, where another model with just that fits significantly
/// better and gives another alpha or beta (these in the open loop, and only where beta is known to be positive);
/// residuals that neither explains.
[[nodiscard]] std::vector<std::string> doubts(const model::Record& record, const model::Airframe& airframe,
                                              model::Start start, const result::Identification& found);

}  // namespace fantail::identify
