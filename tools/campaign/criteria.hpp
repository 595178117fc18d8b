// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/flown_run.hpp"
#include "campaign/question.hpp"

namespace fantail::campaign {

/// A requirement that a flight must meet to be held.
struct Criterion {
  std::string_view name;                ///< as runs.csv has it
  std::string_view words;               ///< of a flight that does not meet it, a clause
  std::optional<std::size_t> figure{};  ///< of figure_columns: by how much; empty: no figure measures it
  bool low_is_bad = false;              ///< of the figure
};

/// Null for a word that is none.
[[nodiscard]] const Criterion* find_criterion(std::string_view name);

/// The names of all criteria that this flight does not meet; empty when it is held, else at least one.
[[nodiscard]] std::vector<std::string> failed_criteria(const JudgedFlight& judged);

/// How many of the runs that count against a question do not meet a criterion. One run can fail several.
struct Failure {
  const Criterion* criterion;
  std::size_t runs;
};

/// The most frequent first. Empty for a question about a figure: its bound is the only criterion.
[[nodiscard]] std::vector<Failure> failures(const std::vector<FlownRun>& runs, const Question& question);

/// A run and what it is ranked by.
struct RankedRun {
  std::size_t index;                    ///< of the run
  const Criterion* failed_by;           ///< null: it fails none, or the bound of the question
  std::optional<std::size_t> figure{};  ///< of figure_columns; empty: none measures it
};

/// The worst runs first, at most `count`. Runs that count against the question stand before all others. Degrees and
/// seconds cannot be compared, so the criteria take turns, the most frequent first, each with its worst run: one
/// without the figure, then the one that is farthest beyond the limit. `figure`: what the other runs are ranked by.
[[nodiscard]] std::vector<RankedRun> worst_runs(const std::vector<FlownRun>& runs, const Question& question,
                                                std::size_t figure, std::size_t count);

}  // namespace fantail::campaign
