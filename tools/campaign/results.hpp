// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/analysis.hpp"
#include "campaign/landing.hpp"
#include "page/chart.hpp"
#include "result/answer.hpp"
#include "result/document.hpp"
#include "text/layout.hpp"

namespace fantail::campaign {

/// A campaign with all that its results are made from.
/// The true roll of the first runs, flown again, until control ends.
struct RollBand {
  /// Of all that still fly, at least half of them.
  struct Instant {
    double time_s;  ///< after lift-off, in the tunnel after control start
    Quantiles roll_rad;
    std::optional<double> reference_rad;  ///< empty: none of them is under control
  };
  std::size_t runs = 0;
  bool in_tunnel = false;
  std::vector<Instant> instants{};
};

struct Report {
  Campaign campaign{};
  FlownCampaign flown{};
  Analysis analysis{};
  result::Made made{};        ///< with the version of the program
  std::string command{};      ///< that flies it again
  std::string run_command{};  ///< that flies one run again, without its number
  RollBand roll_band{};
  std::optional<Landings> landings{};
  std::vector<std::string> run_folders{};  ///< one a worst run, where its flight report is; empty: it has none
};

/// Is the share that was asked for met? Undecided too where runs lie outside of the model; none without a question.
[[nodiscard]] result::Answer answer_of(const Report& report);
/// How many are faster than the simulation of roll holds for, whatever else they came to.
[[nodiscard]] std::size_t runs_outside_the_model(const Report& report);
/// What was found, in one sentence or two: the share and the interval, or that it is not decided.
[[nodiscard]] std::string headline(const Report& report);
/// Which criteria the runs that count against the question do not meet, how many by which: a sentence with a space
/// before it; empty: none fails, or the question is about a figure.
[[nodiscard]] std::string reasons(const Analysis& analysis);
/// What was left out or went wrong, a sentence each.
[[nodiscard]] std::vector<std::string> remarks(const Report& report);

/// What the figures that decide depend on, with pictures; or why that is unknown.
[[nodiscard]] std::vector<result::Block> influences(const Report& report);
/// Of every figure that influences() does not show, its slope by each quantity.
[[nodiscard]] result::Table slopes_of_other_figures(const Analysis& analysis);
[[nodiscard]] json::Value influences_for_programs(const Analysis& analysis);

/// How many runs have each outcome, and how many fail each criterion.
[[nodiscard]] std::vector<result::Block> outcomes(const Report& report);
/// The worst runs, with their flight reports.
[[nodiscard]] std::vector<result::Block> worst(const Report& report);
[[nodiscard]] result::Table worst_for_programs(const Report& report);
[[nodiscard]] std::vector<result::Listed> listed_of_runs();

/// The unit is that of the row, and the decimals with it.
[[nodiscard]] std::string five_digits(double value);
/// "less than 0.1": a share of which some or not all is left looks like it.
[[nodiscard]] std::string percent(double of_100);

// Its pictures.

/// Calls `look` before each flight.
[[nodiscard]] RollBand roll_band_of(const Campaign& campaign, const FlownCampaign& flown,
                                    const std::function<void()>& look);
/// The share over the number of runs, with the bounds that hold at every look.
[[nodiscard]] page::Chart convergence_chart(const Report& report);
/// How many of the runs are in each of equally wide bins, of a column whose values are not all the same.
/// A few values far from all others are left out, or every other run is in one bin.
[[nodiscard]] page::Chart histogram(const Column& column);
/// How many those are, a sentence; empty: none.
[[nodiscard]] std::string runs_beyond_histogram(const Column& column);
/// A bar for each quantity: by how much one of figure_columns moves with it, largest first, with the 95 % interval.
/// In a narrow one each name stands above its bar.
[[nodiscard]] std::string tornado_svg(const Report& report, std::size_t figure, double width);
/// One of figure_columns over one of the quantities: runs that meet the question, runs that do not.
[[nodiscard]] page::Chart scatter(const Report& report, std::size_t figure, const std::string& quantity);

/// All of it, for every output.
[[nodiscard]] result::Document answer(const Report& report);
[[nodiscard]] std::vector<result::Listed> listed_fields();

/// What a column of runs.csv or a drawn quantity is called where a person reads it, and its unit, which may be empty:
/// "largest hold error" and "deg" of largest_hold_error_deg, "servo: lag, factor" of servo.lag_s_factor, "disturbance:
/// angles, added" and "deg" of disturbance.angles_deg_offset.
struct ColumnWords {
  std::string words;
  std::string unit;

  /// "largest hold error / deg".
  [[nodiscard]] std::string with_unit() const { return unit.empty() ? words : words + " / " + unit; }
};
[[nodiscard]] ColumnWords column_words(std::string_view name);

/// "cut short" of cut_short.
[[nodiscard]] std::string outcome_words(std::string outcome);

/// Analyses a whole campaign that was flown into `folder`, and writes there the flight reports of its worst runs, each
/// in a folder run_N. `required`: a share that is asked for. `look` is called before each of these flights; what it
/// throws ends it. Throws text::OutputError. `threads`: as parallel_for() takes them.
[[nodiscard]] Report conclude(const Campaign& campaign, FlownCampaign flown, const Question& question,
                              std::optional<double> required, const result::Made& made,
                              const std::filesystem::path& folder, unsigned threads, const std::function<void()>& look);

}  // namespace fantail::campaign
