// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/criteria.hpp"
#include "campaign/question.hpp"
#include "result/field.hpp"

namespace fantail::campaign {

using result::Share;  ///< its interval: Wilson, 1927; sensible also where all or none did

/// Without anything to count nothing is known: 0 to 1.
[[nodiscard]] Share share(std::size_t count, std::size_t of);

/// Between two values a point lies on the straight line, so that the least is 0 % and the largest 100 %.
using Quantiles = result::Spread;

/// Of at least one value.
[[nodiscard]] Quantiles quantiles(std::vector<double> values);

/// At each place of the tracks, as long as at least this share of them reaches it, 0 to 1.
[[nodiscard]] std::vector<Quantiles> quantiles_over(std::span<const std::span<const double>> tracks,
                                                    double least_share);

/// A figure and where it lies with 95 % probability.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// How the result goes with the quantities, along straight lines.
struct Sensitivity {
  /// Of each quantity, the standardised regression coefficient: by how many of its standard deviations the result moves
  /// with one of the quantity's, the others held. Its sign says in which sense. All are empty where
  /// quantities depend on each other so closely that one cannot change without another, or where one run alone decides.
  std::vector<std::optional<Estimate>> slopes{};
  double explained = 0.0;  ///< by the straight lines of all quantities together: R^2, adjusted for their number
};

/// `quantities`: one list a quantity, each as long as `result`, no value the same in all runs; `result` neither. There
/// are at least ten runs, and ten times as many as quantities. The intervals are those of the jackknife, so they ask
/// neither for a straight line nor for noise that is the same everywhere.
[[nodiscard]] Sensitivity sensitivity(const std::vector<std::vector<double>>& quantities,
                                      const std::vector<double>& result);

/// What the share of the runs says about a required one.
enum class Judgement : std::uint8_t {
  met,        ///< the whole interval is at or above it
  not_met,    ///< all of it is below
  undecided,  ///< it lies within
};

/// The values of one column of runs.csv.
struct Column {
  std::string name{};
  std::vector<double> values{};  ///< of the runs that have one, in their order
  Quantiles quantiles{};         ///< of a column with values, as the next two
  double least = 0.0;
  double largest = 0.0;
};

/// How much a drawn quantity matters.
struct QuantityInfluence {
  std::string name{};
  std::vector<std::optional<Estimate>> slopes{};  ///< of each of figure_columns; empty where nothing is known
};

/// How well straight lines explain one of figure_columns.
struct Fit {
  std::string why_none{};  ///< there are no slopes, a sentence; empty: there are
  std::size_t runs = 0;    ///< that have the figure; of many, the first ones
  double explained = 0.0;  ///< Sensitivity::explained
};

/// Then the slopes do not show what the figure depends on.
[[nodiscard]] inline bool explains_little(const Fit& fit) { return fit.explained < 0.1; }

/// The share after so many runs, with bounds that hold however often one looks.
struct Looked {
  std::uint64_t runs = 0;
  double share = 0.0;
  Bounds bounds{};
};

struct Analysis {
  Question question{};
  Share share{};                     ///< its interval is Wilson's, or that of the rule by which the campaign stopped
  bool by_sequence = false;          ///< the latter
  std::optional<double> required{};  ///< share
  std::optional<Judgement> judgement{};
  std::vector<std::pair<std::string, std::size_t>> outcomes{};  ///< the most frequent first
  std::vector<Column> figures{};                                ///< those that some run has
  std::vector<Column> quantities{};
  std::vector<Failure> failures{};  ///< of runs that count against a question about an outcome
  /// Of figure_columns, those that decide: of the question, or of the criteria that most runs fail, at most three. The
  /// hold error where no run fails; none where no figure measures any of these criteria.
  std::vector<std::size_t> decided_by{};
  std::vector<QuantityInfluence> influences{};  ///< of the first of these figures, the steepest slope first
  std::vector<Fit> fits{};                      ///< of each of figure_columns
  std::vector<RankedRun> worst{};               ///< the worst first
  std::vector<Looked> looked{};
  std::size_t drawn_again = 0;  ///< runs of which a draw left what a field allows
};

/// By their slopes of one of figure_columns, whatever their sign; those without a slope last.
[[nodiscard]] std::vector<QuantityInfluence> steepest_first(std::vector<QuantityInfluence> influences,
                                                            std::size_t figure);

/// `flown` has a run at least. `required`: a share that is asked for.
[[nodiscard]] Analysis analyse(const FlownCampaign& flown, const Campaign& campaign, const Question& question,
                               std::optional<double> required);

}  // namespace fantail::campaign
