// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "campaign/results.hpp"
#include "flight/model_end.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

/// An end of an interval, rounded outwards, with as many digits as it takes to be on the same side of what is asked
/// for, and not to look like none or all.
std::string end_percent(double share, double (*outwards)(double), const std::optional<double>& required) {
  constexpr int most_digits = 6;
  for (int digits = 1;; ++digits) {
    const double power = std::pow(10.0, digits);
    const double percent = outwards(100.0 * power * share) / power;
    const bool is_like_it = (percent >= 100.0) == (share >= 1.0) && (percent <= 0.0) == (share <= 0.0) &&
                            (!required || (0.01 * percent >= *required) == (share >= *required));
    if (is_like_it || digits == most_digits) {
      return text::brief(percent, digits);
    }
  }
}

std::string runs(std::size_t count) { return text::counted(count, "run"); }

std::string judged(const Report& report) {
  const Analysis& a = report.analysis;
  if (!a.judgement) {
    return {};
  }
  // The heading says it, unless it says that the flights are outside the model.
  const bool is_said = runs_outside_the_model(report) == 0;
  const char* words = *a.judgement == Judgement::undecided ? ", which is within the interval. "
                      : is_said                            ? ". "
                      : *a.judgement == Judgement::met     ? ": met. "
                                                           : ": not met. ";
  return fmt::format("At least {} % is required{}", text::brief(100.0 * *a.required, 3), words);
}

void add_count(std::vector<std::string>& all, const Report& report, std::string_view outcome, const char* words) {
  const auto is = [outcome](const FlownRun& run) { return run.outcome == outcome; };
  const std::vector<FlownRun>& flown = report.flown.runs;
  const auto count = std::ranges::count_if(flown, is);
  if (count > 0) {
    const FlownRun& first = *std::ranges::find_if(flown, is);
    all.push_back(fmt::format("{} {}; counted as not met. The first is run {}: {}.",
                              runs(static_cast<std::size_t>(count)), words, first.run, first.note));
  }
}

/// Of a question for "held": the runs that count for verdict.tilt_end_before_apogee_s alone. Nothing else lets a flight
/// be held whose control ended earlier than report::near_apogee_s. With a space before it; empty: there is none.
std::string allowed_tilt_ends(const Report& report) {
  const Question& question = report.analysis.question;
  report::AllowedTiltEnds ends;
  for (const FlownRun& run : report.flown.runs) {
    const auto& before_s = run.figures[uncontrolled_time_column];
    const bool is_held = run.outcome == report::name(report::Outcome::held);
    ends.add(is_held && before_s.value_or(0.0) > report::near_apogee_s ? before_s : std::nullopt);
  }
  const bool asks_held = question.relation == Relation::is && question.outcome == report::name(report::Outcome::held);
  const std::string sentence = asks_held ? ends.sentence(report.analysis.share.count, "run") : "";
  return sentence.empty() ? "" : fmt::format(" {}.", sentence);
}

/// Such a flight may be held in the simulation all the same. With a space before it; empty: there is none.
std::string begun_on_guide(const Report& report) {
  const auto begins_there = [](const FlownRun& run) { return run.note.starts_with(begun_on_guide_note); };
  const std::vector<FlownRun>& flown = report.flown.runs;
  const auto count = std::ranges::count_if(flown, begins_there);
  if (count == 0) {
    return {};
  }
  const FlownRun& first = *std::ranges::find_if(flown, begins_there);
  return fmt::format(
      " In {} control began inside the launch guide, where moving canards can jam the rocket: check "
      "guide.length_m in the plan. The first is run {}: {}.",
      runs(static_cast<std::size_t>(count)), first.run, first.note);
}

std::vector<flight::Extremes> extremes_of_all(const Report& report) {
  std::vector<flight::Extremes> all;
  std::ranges::transform(report.flown.runs, std::back_inserter(all), extremes_of);
  return all;
}

/// Empty where no run is.
std::string outside_the_model(const Report& report) {
  return flight::outside_model(flight::which_are_beyond(extremes_of_all(report)));
}

/// Which quantity matters most for the figure of the criterion that most runs fail, or of the question: where that is
/// known, a sentence with a space before it.
std::string strongest_influence(const Analysis& a) {
  const bool is_about_figure = a.question.relation != Relation::is;
  if (a.decided_by.empty() || a.influences.empty() || (!is_about_figure && a.failures.empty())) {
    return {};
  }
  const std::size_t figure = a.decided_by.front();
  const std::optional<Estimate>& slope = a.influences.front().slopes[figure];
  const bool decides = is_about_figure || a.failures.front().criterion->figure == figure;
  if (!decides || !slope || slope->low * slope->high <= 0.0 || explains_little(a.fits[figure])) {
    return {};
  }
  return fmt::format(" In a linear fit, \"{}\" has the strongest influence on the {}.",
                     column_words(a.influences.front().name).words, column_words(figure_columns[figure]).words);
}

std::string interval_sentence(const Report& report) {
  if (report.analysis.by_sequence) {
    return "The interval holds however often the share was checked before the campaign stopped (Robbins' confidence "
           "sequence). It is wider than an interval for a fixed number of runs.";
  }
  return "The interval is Wilson's for independent runs.";
}

}  // namespace

std::string percent(double of_100) {
  const double tenths = std::round(10.0 * of_100);
  return of_100 > 0.0 && tenths == 0.0        ? "less than 0.1"
         : of_100 < 100.0 && tenths == 1000.0 ? "more than 99.9"
                                              : text::brief(tenths / 10.0, 1);
}

std::size_t runs_outside_the_model(const Report& report) {
  return static_cast<std::size_t>(std::ranges::count_if(extremes_of_all(report), flight::is_beyond_model));
}

result::Answer answer_of(const Report& report) {
  const std::optional<Judgement>& judgement = report.analysis.judgement;
  if (judgement == Judgement::not_met) {
    return result::Answer::no;
  }
  if (runs_outside_the_model(report) > 0 || judgement == Judgement::undecided) {
    return result::Answer::undecided;
  }
  return judgement ? result::Answer::yes : result::Answer::none;
}

std::string headline(const Report& report) {
  const Analysis& a = report.analysis;
  return outside_the_model(report) + judged(report) +
         fmt::format("{}: {} of {}, {} %; 95 % confidence interval {} to {} %.{}{}{}{}", a.question.words(),
                     a.share.count, runs(a.share.of), percent(100.0 * a.share.value),
                     end_percent(a.share.low, std::floor, a.required), end_percent(a.share.high, std::ceil, a.required),
                     allowed_tilt_ends(report), reasons(a), strongest_influence(a), begun_on_guide(report));
}

std::string reasons(const Analysis& analysis) {
  constexpr std::size_t most = 3;
  std::string all;
  for (const Failure& failure : std::span{analysis.failures}.first(std::min(most, analysis.failures.size()))) {
    all += fmt::format("{}{} in {}", all.empty() ? "" : "; ", failure.criterion->words, runs(failure.runs));
  }
  return all.empty() ? "" : fmt::format(" Why runs fail: {}.", all);
}

std::vector<std::string> remarks(const Report& report) {
  std::vector<std::string> all{
      "The share follows from the spreads in the scenario's file: it is only as accurate as they are.",
      interval_sentence(report)};
  const Campaign& campaign = report.campaign;
  const std::size_t flown = report.flown.runs.size();
  if (campaign.stop && flown < campaign.runs) {
    all.push_back(
        fmt::format("Stopped after {} of {}, by the rule: {}.", flown, runs(campaign.runs), campaign.stop->words()));
  } else if (campaign.stop) {
    all.push_back(fmt::format("All {} were flown before the rule was met: {}. A larger --runs allows more.",
                              runs(campaign.runs), campaign.stop->words()));
  }
  if (report.analysis.drawn_again > 0) {
    all.push_back(
        fmt::format("In {} a draw was outside the range of its field and was drawn again: the law is truncated.",
                    runs(report.analysis.drawn_again)));
  }
  add_count(all, report, "refused", "drew incompatible values and could not be flown");
  add_count(all, report, "not_finite", "gave a figure that is not a number");
  return all;
}

}  // namespace fantail::campaign
