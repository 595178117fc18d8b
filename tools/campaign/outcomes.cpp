// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "campaign/results.hpp"
#include "json/value.hpp"
#include "text/number.hpp"

// The outcomes of the runs, the criteria that they fail, and the worst of them.
namespace fantail::campaign {
namespace {

using Json = json::Value;
using result::Cell;
using result::Named;
using result::Worse;
namespace u = result::units;

struct Outcome {
  std::string name;
  std::size_t runs;
  double share;
};
constexpr auto outcome_fields = result::fields<Outcome>({
    {"outcome", "outcome", u::none, 0, [](const Outcome& o) { return Cell{outcome_words(o.name)}; },
     "verdict of the flight report in one word"},
    {"runs", "runs", u::none, 0, &Outcome::runs, "runs with it"},
    {"share", "share", u::percent, 1, &Outcome::share, "their share of all runs", Worse::neither, percent},
});

/// Of all runs.
struct Reason {
  Failure failure;
  std::size_t of;
};
constexpr auto reason_fields = result::fields<Reason>({
    {"criterion", "criterion", u::none, 0,
     [](const Reason& r) {
       return Cell{Named{std::string{r.failure.criterion->name}, std::string{r.failure.criterion->words}}};
     },
     "name of the criterion, as failed_by in runs.csv.gz"},
    {"runs", "runs", u::none, 0, [](const Reason& r) { return Cell{std::uint64_t{r.failure.runs}}; },
     "runs that fail it; one run can fail several"},
    {"share", "share", u::percent, 1,
     [](const Reason& r) { return Cell{static_cast<double>(r.failure.runs) / static_cast<double>(r.of)}; },
     "their share of all runs", Worse::neither, percent},
    {"figure", "figure", u::none, 0,
     [](const Reason& r) {
       const auto& figure = r.failure.criterion->figure;
       return figure ? Cell{Named{std::string{figure_columns[*figure]}, column_words(figure_columns[*figure]).words}}
                     : Cell{};
     },
     "its column in runs.csv.gz; null if no figure measures it"},
});

/// One of the runs that are shown.
struct WorstRun {
  const FlownRun* flown;
  RankedRun ranked;
  std::string folder;

  [[nodiscard]] std::optional<double> value() const {
    return ranked.figure ? flown->figures[*ranked.figure] : std::nullopt;
  }
};
Cell words_or_none(std::string_view words) { return words.empty() ? Cell{} : Cell{std::string{words}}; }
constexpr auto worst_fields = result::fields<WorstRun>({
    {"run", "run", u::none, 0, [](const WorstRun& w) { return Cell{w.flown->run}; }, "its number"},
    {"seed", "seed", u::none, 0, [](const WorstRun& w) { return Cell{w.flown->seed}; }, "seed of its random streams"},
    {"outcome", "outcome", u::none, 0, [](const WorstRun& w) { return Cell{w.flown->outcome}; },
     "verdict of its flight report in one word"},
    {"failed_by", "failed by", u::none, 0,
     [](const WorstRun& w) { return words_or_none(w.ranked.failed_by != nullptr ? w.ranked.failed_by->name : ""); },
     "criterion by which it is among the worst; null: none, or the bound of the question"},
    {"figure", "figure", u::none, 0,
     [](const WorstRun& w) { return words_or_none(w.ranked.figure ? figure_columns[*w.ranked.figure] : ""); },
     "column in runs.csv.gz of the figure by which it is ranked"},
    {"value", "value", u::none, 0, [](const WorstRun& w) { return w.value() ? Cell{*w.value()} : Cell{}; },
     "value of this figure", Worse::neither, five_digits},
    {"note", "note", u::none, 0, [](const WorstRun& w) { return words_or_none(w.flown->note); },
     "reason why there is no outcome of a flight"},
    {"folder", "folder", u::none, 0, [](const WorstRun& w) { return words_or_none(w.folder); },
     "folder of its flight report; null for a run that was not flown"},
});

std::vector<WorstRun> runs_shown(const Report& report) {
  std::vector<WorstRun> all;
  for (std::size_t i = 0; i < report.analysis.worst.size(); ++i) {
    const RankedRun& ranked = report.analysis.worst[i];
    all.push_back({&report.flown.runs[ranked.index], ranked, report.run_folders[i]});
  }
  return all;
}

/// ", the tilt limit ended control early; uncontrolled time before apogee 4.2 s".
std::string how_bad(const WorstRun& one) {
  std::string all = one.ranked.failed_by != nullptr ? fmt::format(", {}", one.ranked.failed_by->words) : "";
  if (const std::optional<double> value = one.value()) {
    const ColumnWords figure = column_words(figure_columns[*one.ranked.figure]);
    all += fmt::format("{}{} {}{}{}", all.empty() ? ", " : "; ", figure.words, five_digits(*value),
                       figure.unit.empty() ? "" : " ", figure.unit);
  }
  return all;
}

/// Where some run fails by it: when an end of control is early, and which outcomes come of it.
std::string what_is_early(const Report& report) {
  const bool is_there = std::ranges::any_of(report.analysis.failures, [](const Failure& failure) {
    return failure.criterion->name == "tilt" || failure.criterion->name == "control_end";
  });
  return !is_there ? ""
                   : std::string{report.roll_band.in_tunnel
                                     ? " Early: before the plan's control time was over."
                                     : " Early: more than 0.5 s before apogee (the tilt limit: more than "
                                       "verdict.tilt_end_before_apogee_s), or at any time where the ascent failed or "
                                       "apogee is not known."} +
                         " After an early end a run is cut short if it then turned by at most 10 deg, else not held. A "
                         "failed ascent, or a roll lost before, takes precedence.";
}

}  // namespace

std::string five_digits(double value) { return text::brief(value, std::max(0, result::decimals_for(value, 5))); }

std::vector<result::Block> outcomes(const Report& report) {
  std::vector<Outcome> all;
  Json counts;
  for (const auto& [name, count] : report.analysis.outcomes) {
    all.push_back({name, count, static_cast<double>(count) / static_cast<double>(report.analysis.share.of)});
    counts[name] = count;
  }
  std::vector<Reason> reasons;
  for (const Failure& failure : report.analysis.failures) {
    reasons.push_back({failure, report.analysis.share.of});
  }
  std::vector<result::Block> blocks{result::table({}, all, outcome_fields), result::Data{"outcomes", counts}};
  if (!reasons.empty()) {
    blocks.emplace_back("Criteria that runs fail. One run can fail several." + what_is_early(report));
  }
  blocks.emplace_back(result::table("failures", reasons, reason_fields));
  return blocks;
}

std::vector<result::Block> worst(const Report& report) {
  result::Links links;
  for (const WorstRun& one : runs_shown(report)) {
    const FlownRun& run = *one.flown;
    links.all.push_back({.href = one.folder.empty() ? "" : one.folder + "/report.html",
                         .text = fmt::format("run {}", run.run),
                         .about = fmt::format(": {}{}{}{}", outcome_words(run.outcome), how_bad(one),
                                              run.note.empty() ? "" : "; ", run.note)});
  }
  std::vector<result::Block> all{links, "To fly any run again, with its flight report: " + report.run_command + " RUN"};
  if (report.analysis.failures.size() > 1) {
    all.insert(all.begin(), "The worst run of each criterion, the most frequent criterion first, then the next worst.");
  }
  return all;
}

result::Table worst_for_programs(const Report& report) {
  return result::table("worst_runs", runs_shown(report), worst_fields);
}

std::vector<result::Listed> listed_of_runs() {
  return {result::listed("failures[]", reason_fields), result::listed("worst_runs[]", worst_fields)};
}

}  // namespace fantail::campaign
