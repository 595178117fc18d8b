// SPDX-License-Identifier: MIT
#include "campaign/criteria.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "flight/model_end.hpp"
#include "text/degrees.hpp"

namespace fantail::campaign {
namespace {

constexpr std::size_t column(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(figure_columns, name) - figure_columns.begin());
}

static_assert(report::held_error_rad == text::radians(10.0), "the words below have it");
static_assert(uncontrolled_time_column == column("uncontrolled_time_before_apogee_s"));
// A cause stands before its consequences, and of equally frequent ones it is named first.
constexpr std::array criteria{
    Criterion{"ascent", "the ascent failed"},
    Criterion{"gate", "the plan's gate never opened"},
    Criterion{"no_control", "control never began"},
    Criterion{"tilt", "the tilt limit ended control early", uncontrolled_time_column},
    Criterion{"control_end", "control ended early, not by tilt", uncontrolled_time_column},
    Criterion{"mach", "too fast for the roll model", top_mach_column},
    Criterion{"stability", "the rocket was not stable", top_mach_column + 1, true},
    Criterion{"angle_of_attack", "angle of attack beyond the roll model", top_mach_column + 2},
    Criterion{"gyro_range", "roll faster than the gyro's range"},
    Criterion{"authority", "fin offset beyond the canard limit", column("authority_margin_deg"), true},
    Criterion{"oscillation", "canards oscillated or the loop was unstable"},
    Criterion{"hold_error", "hold error above 10 deg", column("largest_hold_error_deg")},
    Criterion{"rest_error", "rest error above its limit", column("rest_error_deg")},
    Criterion{"trajectory_end", "the trajectory ended before apogee"},
    Criterion{"not_judged", "roll not judged"},
    Criterion{"refused", "drawn values not allowed together"},
    Criterion{"not_finite", "a figure is not a number"}};

bool is_unstable(const flight::Flight& flight) {
  return std::ranges::any_of(flight.loop_margins, [](const auto& margin) { return margin.phase_margin_rad <= 0.0; });
}

bool fails(const FlownRun& run, const Criterion& criterion) {
  return std::ranges::find(run.failed_by, criterion.name) != run.failed_by.end();
}

/// Runs of which the worst come first.
struct Ranking {
  const Criterion* criterion;
  std::optional<std::size_t> figure;
  bool low_is_bad;
  std::vector<std::size_t> indices{};

  void sort(const std::vector<FlownRun>& runs, std::size_t count) {
    const auto place = [&](std::size_t index) {
      const std::optional<double> value = figure ? runs[index].figures[*figure] : std::nullopt;
      return std::tuple{value.has_value(), (low_is_bad ? 1.0 : -1.0) * value.value_or(0.0), index};
    };
    const auto kept = static_cast<std::ptrdiff_t>(std::min(count, indices.size()));
    std::ranges::partial_sort(indices, indices.begin() + kept, {}, place);
    indices.resize(static_cast<std::size_t>(kept));
  }
};

}  // namespace

const Criterion* find_criterion(std::string_view name) {
  const auto* const found = std::ranges::find(criteria, name, &Criterion::name);
  return found == criteria.end() ? nullptr : found;
}

std::vector<std::string> failed_criteria(const JudgedFlight& judged) {
  using report::Outcome;
  const flight::Flight& flight = judged.flight;
  const report::Figures& f = judged.figures;
  const Outcome outcome = judged.verdict.outcome;
  if (outcome == Outcome::held) {
    return {};
  }
  std::vector<std::string> all;
  const auto add = [&all](bool is_failed, const char* name) {
    if (is_failed) {
      all.emplace_back(name);
    }
  };
  add(outcome == Outcome::ascent_failed, "ascent");
  const bool closed = !judged.opening && !flight.phase_changes.empty() &&
                      flight.phase_changes.back().reason == core::PhaseReason::gate_never_opened;
  add(closed, "gate");
  add(outcome == Outcome::no_control && !closed, "no_control");
  add(judged.verdict.ended_by_tilt, "tilt");
  add(judged.verdict.ended_early && !judged.verdict.ended_by_tilt, "control_end");
  add(is_beyond(flight::ModelEnd::mach, flight.extremes), "mach");
  add(is_beyond(flight::ModelEnd::stability, flight.extremes), "stability");
  add(is_beyond(flight::ModelEnd::attack, flight.extremes), "angle_of_attack");
  add(flight.unmeasured.spin_from_s.has_value(), "gyro_range");
  add(f.at_limit_since_s && f.offset_beyond_limit, "authority");
  add(f.oscillation || is_unstable(flight), "oscillation");
  add(f.largest_hold_error_rad.value_or(0.0) > report::held_error_rad, "hold_error");
  add(outcome == Outcome::off_command || f.rest_error_rad.value_or(0.0) > flight.rest_limit_rad, "rest_error");
  add(outcome == Outcome::not_judged, "not_judged");
  add(outcome == Outcome::cut_short && !judged.verdict.ended_early, "trajectory_end");
  return all;
}

std::vector<Failure> failures(const std::vector<FlownRun>& runs, const Question& question) {
  std::vector<Failure> all;
  for (const Criterion& criterion : criteria) {
    const auto count = static_cast<std::size_t>(std::ranges::count_if(
        runs, [&](const FlownRun& run) { return question.is_failed_by(run) && fails(run, criterion); }));
    if (question.relation == Relation::is && count > 0) {
      all.push_back({&criterion, count});
    }
  }
  std::ranges::stable_sort(all, std::greater{}, &Failure::runs);
  return all;
}

std::vector<RankedRun> worst_runs(const std::vector<FlownRun>& runs, const Question& question, std::size_t figure,
                                  std::size_t count) {
  std::vector<Ranking> rankings;
  for (const Failure& failure : failures(runs, question)) {
    rankings.push_back({failure.criterion, failure.criterion->figure, failure.criterion->low_is_bad});
  }
  const std::size_t by_criterion = rankings.size();
  const bool low_is_bad = question.relation == Relation::at_least;
  rankings.push_back({nullptr, figure, low_is_bad});  // that fail, by the bound of the question
  rankings.push_back({nullptr, figure, low_is_bad});  // the others
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool is_failed = question.is_failed_by(runs[i]);
    for (std::size_t r = 0; r < by_criterion && is_failed; ++r) {
      if (fails(runs[i], *rankings[r].criterion)) {
        rankings[r].indices.push_back(i);
      }
    }
    rankings[by_criterion + (is_failed ? 0 : 1)].indices.push_back(i);
  }
  for (Ranking& ranking : rankings) {
    ranking.sort(runs, 2 * count);  // others can take as many of them as there are
  }
  std::vector<RankedRun> all;
  const auto take_one = [&](Ranking& ranking) {
    const auto is_free = [&](std::size_t index) {
      return std::ranges::find(all, index, &RankedRun::index) == all.end();
    };
    const auto next = std::ranges::find_if(ranking.indices, is_free);
    if (next == ranking.indices.end() || all.size() == count) {
      return false;
    }
    all.push_back({*next, ranking.criterion, ranking.figure});
    return true;
  };
  for (bool took = true; took;) {
    took = false;
    for (std::size_t r = 0; r < by_criterion; ++r) {
      took = take_one(rankings[r]) || took;
    }
  }
  for (std::size_t r = by_criterion; r < rankings.size(); ++r) {
    while (take_one(rankings[r])) {
    }
  }
  return all;
}

}  // namespace fantail::campaign
