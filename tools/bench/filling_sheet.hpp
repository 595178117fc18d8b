// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "bench/exercise.hpp"
#include "bench/sheet.hpp"
#include "link/avionics_link.hpp"
#include "sim/canard_tolerances.hpp"

namespace fantail::bench {

/// The inside of a page, as HTML, while an exercise goes on: the sheet of the turns that are over. They are cut as in
/// the whole sheet, by what the exercise has done: on a slow PC that is behind the rocket's clock.
class FillingSheet {
 public:
  FillingSheet(Exercise exercise, const sim::CanardTolerances& tolerances, Heading heading)
      : exercise_{std::move(exercise)}, tolerances_{tolerances}, heading_{std::move(heading)} {}

  /// The next tick. The sheet when another turn is over with it; with the last turn comes the whole sheet instead.
  [[nodiscard]] std::optional<std::string> take(const link::Tick& tick);
  /// The exercise was given up, and `why`: what the turns that are over have shown stays.
  [[nodiscard]] std::string given_up(const std::string& why) const;

 private:
  [[nodiscard]] std::string html(const std::string& given_up_because) const;

  Exercise exercise_;
  sim::CanardTolerances tolerances_;
  Heading heading_;
  link::Recording recording_;
  std::size_t turns_over_ = 0;
};

}  // namespace fantail::bench
