// SPDX-License-Identifier: MIT
#include "campaign/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "campaign/results.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

constexpr std::size_t most_worst_runs = 5;
constexpr std::size_t most_deciding = 3;
constexpr std::size_t most_looks = 200;
constexpr std::size_t most_influence_runs = 20'000;  // beyond, the intervals are narrow enough
constexpr std::size_t fewest_influence_runs = 100;   // of fewer, too few intervals hold the truth

Column column(std::string name, std::vector<double> values) {
  Column all{.name = std::move(name), .values = std::move(values)};
  if (!all.values.empty()) {
    all.quantiles = quantiles(all.values);
    const auto [least, largest] = std::ranges::minmax(all.values);
    all.least = least;
    all.largest = largest;
  }
  return all;
}

std::vector<std::pair<std::string, std::size_t>> outcomes(const std::vector<FlownRun>& runs) {
  std::map<std::string, std::size_t> counts;
  for (const FlownRun& run : runs) {
    ++counts[run.outcome];
  }
  std::vector<std::pair<std::string, std::size_t>> sorted{counts.begin(), counts.end()};
  std::ranges::stable_sort(sorted, std::greater{}, &std::pair<std::string, std::size_t>::second);
  return sorted;
}

std::vector<Looked> looks(const std::vector<FlownRun>& runs, const Question& question) {
  std::vector<Looked> all;
  const std::size_t step = std::max<std::size_t>(1, runs.size() / most_looks);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    count += question.is_met_by(runs[i]) ? 1U : 0U;
    if ((i + 1) % step == 0 || i + 1 == runs.size()) {
      all.push_back({.runs = i + 1,
                     .share = static_cast<double>(count) / static_cast<double>(i + 1),
                     .bounds = confidence_sequence(count, i + 1)});
    }
  }
  return all;
}

bool varies(const std::vector<double>& values) {
  return std::ranges::any_of(values, [&](double value) { return value != values.front(); });
}

/// What the runs that have a figure drew, and what it was.
struct Sample {
  std::vector<std::size_t> quantities{};  ///< those that vary
  std::vector<std::vector<double>> drawn{};
  std::vector<double> result{};
};

Sample sample_of(const FlownCampaign& flown, std::size_t figure) {
  Sample sample;
  std::vector<const FlownRun*> used;
  for (const FlownRun& run : flown.runs) {
    if (run.figures[figure] && used.size() < most_influence_runs) {
      used.push_back(&run);
      sample.result.push_back(*run.figures[figure]);
    }
  }
  for (std::size_t i = 0; i < flown.quantities.size() && !used.empty(); ++i) {
    std::vector<double> drawn;
    std::ranges::transform(used, std::back_inserter(drawn), [i](const FlownRun* run) { return run->numbers[i]; });
    if (varies(drawn)) {
      sample.quantities.push_back(i);
      sample.drawn.push_back(std::move(drawn));
    }
  }
  return sample;
}

/// Why a sample says nothing; empty when it does.
std::string too_little(const Sample& sample, std::size_t figure) {
  const std::size_t fewest = std::max(fewest_influence_runs, 10 * sample.quantities.size());
  if (sample.result.size() < fewest) {
    return fmt::format("The {} is known for {}; {} are needed to show its dependence on the drawn quantities.",
                       column_words(figure_columns[figure]).words, text::counted(sample.result.size(), "run"), fewest);
  }
  if (sample.quantities.empty() || !varies(sample.result)) {
    return fmt::format("{} is the same in all runs.", sample.quantities.empty()
                                                          ? "Every drawn quantity"
                                                          : "The " + column_words(figure_columns[figure]).words);
  }
  return {};
}

/// Analysis::decided_by, of its question and its failures.
std::vector<std::size_t> decided_by(const Analysis& analysis) {
  if (analysis.question.relation != Relation::is) {
    return {analysis.question.figure};
  }
  if (analysis.failures.empty()) {
    return {0};
  }
  std::vector<std::size_t> all;
  for (const Failure& failure : analysis.failures) {
    const std::optional<std::size_t>& figure = failure.criterion->figure;
    if (figure && all.size() < most_deciding && std::ranges::find(all, *figure) == all.end()) {
      all.push_back(*figure);
    }
  }
  return all;
}

void add_influences(Analysis& analysis, const FlownCampaign& flown) {
  for (const std::string& name : flown.quantities) {
    analysis.influences.push_back(
        {.name = name, .slopes = std::vector<std::optional<Estimate>>(figure_columns.size())});
  }
  for (std::size_t figure = 0; figure < figure_columns.size(); ++figure) {
    const Sample sample = sample_of(flown, figure);
    Fit& fit = analysis.fits.emplace_back(Fit{.why_none = too_little(sample, figure), .runs = sample.result.size()});
    if (!fit.why_none.empty()) {
      continue;
    }
    const Sensitivity found = sensitivity(sample.drawn, sample.result);
    for (std::size_t i = 0; i < sample.quantities.size(); ++i) {
      analysis.influences[sample.quantities[i]].slopes[figure] = found.slopes[i];
    }
    fit.explained = found.explained;
  }
  if (!analysis.decided_by.empty()) {
    analysis.influences = steepest_first(std::move(analysis.influences), analysis.decided_by.front());
  }
}

}  // namespace

std::vector<QuantityInfluence> steepest_first(std::vector<QuantityInfluence> influences, std::size_t figure) {
  std::ranges::stable_sort(influences, std::greater{}, [figure](const QuantityInfluence& of) {
    return of.slopes[figure] ? std::abs(of.slopes[figure]->value) : -1.0;
  });
  return influences;
}

Analysis analyse(const FlownCampaign& flown, const Campaign& campaign, const Question& question,
                 std::optional<double> required) {
  const std::vector<FlownRun>& runs = flown.runs;
  const auto met = static_cast<std::size_t>(
      std::ranges::count_if(runs, [&](const FlownRun& run) { return question.is_met_by(run); }));
  Analysis analysis{.question = question,
                    .share = share(met, runs.size()),
                    .by_sequence = campaign.stop.has_value(),
                    .required = required,
                    .outcomes = outcomes(runs),
                    .looked = looks(runs, question)};
  if (analysis.by_sequence) {
    const Bounds bounds = confidence_sequence(met, runs.size());
    analysis.share.low = bounds.low;
    analysis.share.high = bounds.high;
  }
  if (required) {
    analysis.judgement = analysis.share.low >= *required   ? Judgement::met
                         : analysis.share.high < *required ? Judgement::not_met
                                                           : Judgement::undecided;
  }
  for (std::size_t i = 0; i < figure_columns.size(); ++i) {
    std::vector<double> values;
    for (const FlownRun& run : runs) {
      if (run.figures[i]) {
        values.push_back(*run.figures[i]);
      }
    }
    if (!values.empty()) {
      analysis.figures.push_back(column(std::string{figure_columns[i]}, std::move(values)));
    }
  }
  for (std::size_t i = 0; i < flown.quantities.size(); ++i) {
    std::vector<double> values;
    std::ranges::transform(runs, std::back_inserter(values), [i](const FlownRun& run) { return run.numbers[i]; });
    analysis.quantities.push_back(column(flown.quantities[i], std::move(values)));
  }
  analysis.failures = failures(runs, question);
  analysis.decided_by = decided_by(analysis);
  add_influences(analysis, flown);
  analysis.worst =
      worst_runs(runs, question, analysis.decided_by.empty() ? 0 : analysis.decided_by.front(), most_worst_runs);
  analysis.drawn_again =
      static_cast<std::size_t>(std::ranges::count_if(runs, [](const FlownRun& run) { return run.drawn_again > 0; }));
  return analysis;
}

}  // namespace fantail::campaign
