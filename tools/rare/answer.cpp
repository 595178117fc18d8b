// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/criteria.hpp"
#include "campaign/results.hpp"
#include "page/chart.hpp"
#include "rare/study.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::rare {
namespace {

using result::Answer;
using result::Cell;
using result::Worse;
using text::fixed;
namespace u = result::units;

/// Two digits, and people's words for it.
std::string chance(double probability) {
  if (probability >= 0.01) {
    return fmt::format("{} %", text::brief(100.0 * probability, 1));
  }
  const double digits = std::pow(10.0, std::floor(std::log10(1.0 / probability)) - 1.0);
  const double of = std::round(1.0 / probability / digits) * digits;
  std::string grouped = fmt::format("{:.0f}", of);
  for (int at = static_cast<int>(grouped.size()) - 3; at > 0; at -= 3) {
    grouped.insert(static_cast<std::size_t>(at), " ");
  }
  return "1 in " + grouped;
}

std::string of_flights(double probability) {
  return chance(probability) + (probability >= 0.01 ? " of flights" : " flights");
}

constexpr auto study_fields = result::fields<Study>({
    {"probability", "probability", u::none, 9,
     [](const Study& s) { return s.estimate.end == End::found ? Cell{s.estimate.probability} : Cell{}; },
     "probability that a flight fails the question; null: not found"},
    {"low_95", "95 % interval from", u::none, 9,
     [](const Study& s) { return s.estimate.end == End::found ? Cell{s.estimate.low} : Cell{}; },
     "lower end of its 95 % interval; null: not found"},
    {"high_95", "95 % interval to", u::none, 9,
     [](const Study& s) { return s.estimate.end == End::found ? Cell{s.estimate.high} : Cell{}; },
     "upper end of its 95 % interval; null: not found"},
    {"coefficient_of_variation", "coefficient of variation", u::none, 3,
     [](const Study& s) { return Cell{s.estimate.coefficient_of_variation}; },
     "standard deviation of the probability over the probability"},
    {"flights", "flights", u::none, 0, [](const Study& s) { return Cell{std::uint64_t{s.estimate.points}}; },
     "flights of the search"},
    {"failed", "failed flights", u::none, 0,
     [](const Study& s) { return Cell{std::uint64_t{s.estimate.failing.size()}}; },
     "flights of the last level that failed"},
    {"by_events", "failed without a figure", u::share, 3, &Study::events_share,
     "share of these that failed by something that no figure measures"},
    {"events_unseen", "failures without a figure, at most", u::none, 9,
     [](const Study& s) { return s.events_unseen ? Cell{*s.events_unseen} : Cell{}; },
     "95 % bound for failures without a figure, of which no plain flight had one; null: some had"},
    {"with_heavier_tails", "with heavier tails", u::none, 9,
     [](const Study& s) { return s.with_heavier_tails ? Cell{*s.with_heavier_tails} : Cell{}; },
     "about this probability if every normal law had the tails of Student's t with five degrees of freedom; null: not "
     "known"},
});

constexpr auto level_fields = result::fields<Level>({
    {"samples", "flights", u::none, 0, &Level::samples, "samples of the level"},
    {"threshold", "margin", u::none, 4, &Level::threshold, "margin below which the next level goes on"},
    {"share", "share below", u::percent, 1, [](const Level& l) { return Cell{l.share}; },
     "share of the samples with at most this margin"},
    {"variation", "variation", u::percent, 1, [](const Level& l) { return Cell{l.coefficient_of_variation}; },
     "coefficient of variation of the share, with the correlation of the chains"},
    {"accepted", "moves accepted", u::percent, 0,
     [](const Level& l) { return l.accepted ? Cell{*l.accepted} : Cell{}; },
     "share of the moves that stayed below the level's margin; null: plain samples"},
});

/// A quantity of a mode.
struct QuantityOfMode {
  const Mode* mode;
  const Quantity* quantity;
};
std::string words_of(const std::string& criterion) {
  const campaign::Criterion* found = campaign::find_criterion(criterion);
  return found == nullptr ? "the bound of the question is not met" : std::string{found->words};
}
constexpr auto quantity_fields = result::fields<QuantityOfMode>({
    {"criterion", "failed by", u::none, 0,
     [](const QuantityOfMode& q) { return Cell{result::Named{q.mode->criterion, words_of(q.mode->criterion)}}; },
     "by what these flights fail, as failed_by in runs.csv of a campaign; or the question"},
    {"share", "of failures", u::percent, 0, [](const QuantityOfMode& q) { return Cell{q.mode->share}; },
     "their share of the failed flights"},
    {"quantity", "quantity", u::none, 0,
     [](const QuantityOfMode& q) {
       return Cell{result::Named{q.quantity->name, campaign::column_words(q.quantity->name).words}};
     },
     "what was drawn, as in runs.csv of a campaign"},
    {"mean", "mean", u::none, 2, [](const QuantityOfMode& q) { return Cell{q.quantity->mean_sigmas}; },
     "mean over these flights, in standard deviations of its law; 0 in all flights"},
    {"deviation", "deviation", u::none, 2, [](const QuantityOfMode& q) { return Cell{q.quantity->deviation_sigmas}; },
     "standard deviation over these flights, in that of its law; 1 in all flights"},
});

Cell words_or_none(const std::string& words) { return words.empty() ? Cell{} : Cell{words}; }
constexpr auto found_fields = result::fields<Found>({
    {"margin", "margin", u::none, 4, &Found::margin, "margin of the flight; below 0 it fails"},
    {"outcome", "outcome", u::none, 0, [](const Found& f) { return words_or_none(f.outcome); },
     "outcome of the flight, flown again alone"},
    {"seed", "seed", u::none, 0, [](const Found& f) { return Cell{f.point.seed}; }, "its seed"},
    {"changes", "values", u::none, 0, [](const Found& f) { return Cell{fmt::format("{}", fmt::join(f.changes, " "))}; },
     "values that were drawn for it"},
    {"folder", "folder", u::none, 0, [](const Found& f) { return words_or_none(f.folder); },
     "folder of its flight report; null: it was not flown"},
});

constexpr std::size_t quantities_shown = 4;

/// "disturbance -3.2, trim 1.5 either way"; empty: no quantity moved much.
std::string how_it_is_lost(const Mode& mode) {
  constexpr double worth_saying = 0.5;
  std::string all;
  for (std::size_t i = 0; i < std::min<std::size_t>(mode.quantities.size(), 3); ++i) {
    const Quantity& quantity = mode.quantities[i];
    const bool one_way = std::abs(quantity.mean_sigmas) > 0.7 * quantity.far_sigmas();
    if (one_way ? std::abs(quantity.mean_sigmas) >= worth_saying : quantity.far_sigmas() >= 1.0 + worth_saying) {
      all += fmt::format("{}{} {}", all.empty() ? "" : ", ", campaign::column_words(quantity.name).words,
                         one_way ? fmt::format("{:+.1f}", quantity.mean_sigmas)
                                 : fmt::format("{:.1f} either way", quantity.far_sigmas()));
    }
  }
  return all;
}

/// " By: control never began 62 % (imu: rate bias 3.3 either way), ...".
std::string modes_text(const Study& study) {
  constexpr std::size_t most = 3;
  std::string all;
  for (std::size_t i = 0; i < std::min(most, study.modes.size()); ++i) {
    const Mode& mode = study.modes[i];
    const std::string how = how_it_is_lost(mode);
    all += fmt::format("{}{}, {} %{}", all.empty() ? " It fails by: " : "; ", words_of(mode.criterion),
                       fixed(100.0 * mode.share, 0), how.empty() ? "" : " (" + how + ")");
  }
  return all.empty() ? "" : all + ". In brackets: standard deviations from the mean of all flights.";
}

Answer answer_of(const Study& study) {
  const Estimate& found = study.estimate;
  if (!study.options.at_most) {
    return Answer::none;
  }
  if (found.end == End::always_fails) {
    return Answer::no;
  }
  if (found.end != End::found) {
    return Answer::undecided;
  }
  const double required = *study.options.at_most;
  return found.low > required                                                      ? Answer::no
         : found.high <= required && study.events_unseen.value_or(0.0) <= required ? Answer::yes
                                                                                   : Answer::undecided;
}

std::string heading(const Study& study) {
  switch (study.estimate.end) {
    case End::found: return chance(study.estimate.probability);
    case End::never_fails: return "No failure found";
    case End::always_fails: return "Every flight fails";
    case End::does_not_advance: break;
  }
  return "Not found";
}

std::string sentence(const Study& study) {
  const Estimate& found = study.estimate;
  const std::string question = study.options.question.words();
  const std::string flights = text::counted(found.points, "flight");
  switch (found.end) {
    case End::found: {
      std::string all =
          fmt::format("\"{}\" fails in {} (probability {:.2g}, 95 % interval {:.2g} to {:.2g}), by {}.", question,
                      of_flights(found.probability), found.probability, found.low, found.high, flights);
      if (study.events_unseen && *study.events_unseen > found.low) {
        all += fmt::format(
            " Failures that no figure announces are not in it: none of {} plain flights had one, so they can be as "
            "frequent as {}.",
            found.plain_margins.size(), chance(*study.events_unseen));
      }
      all += modes_text(study);
      return all;
    }
    case End::never_fails:
      return fmt::format(
          "In {} no failure of \"{}\" was reached: the search ended at a margin that {} fall below. A failure "
          "that no "
          "margin announces would not be seen.",
          flights, question, of_flights(found.probability));
    case End::always_fails: return fmt::format("All of {} fail \"{}\": this is not rare.", flights, question);
    case End::does_not_advance: break;
  }
  return fmt::format(
      "The search for failures of \"{}\" stopped after {}. More than half of the flights of a level have the same "
      "margin, "
      "{:.4g}, so no flight leads to the next. {} fall below the last level that was reached.",
      question, flights, found.stuck_at, of_flights(found.probability));
}

std::vector<std::string> limits(const Study& study) {
  const Estimate& found = study.estimate;
  std::vector<std::string> all{
      "The probability follows from the tables [[spread]] of the scenario, far out in their tails, where no "
      "measurement "
      "reaches. What the file does not vary is exactly as it says."};
  if (study.with_heavier_tails) {
    all.push_back(fmt::format(
        "If every normal law had the tails of Student's t distribution with five degrees of freedom, it would be about "
        "{} (probability {:.1g}). This is estimated from the direction of the failures, not flown.",
        chance(*study.with_heavier_tails), *study.with_heavier_tails));
  } else if (found.end == End::found && found.levels.size() > 1) {
    all.emplace_back("Heavier tails than these can make failures more frequent; by how much is not estimated here.");
  }
  if (study.options.question.relation == campaign::Relation::is) {
    all.emplace_back(
        "The search follows hold error, rest error, Mach number and gyro bias. Failures by something without a figure, "
        "such "
        "as canards that oscillate, are found by chance only.");
  }
  if (study.events_share > 0.0) {
    const std::string share = fixed(100.0 * study.events_share, 0);
    if (study.options.question.relation == campaign::Relation::is) {
      all.back() += fmt::format(" {} % of the failed flights failed so.", share);
    } else {
      all.push_back(share + " % of the failed flights have no such figure.");
    }
  }
  if (!study.discrete.empty()) {
    all.push_back(
        fmt::format("{} {} drawn from rows of a table: no row is rarer than 1 in the number of rows, and the "
                    "margin jumps from row to row.",
                    fmt::join(study.discrete, ", "), study.discrete.size() == 1 ? "is" : "are"));
  }
  if (found.end == End::found && found.levels.size() == 1) {
    all.emplace_back("This is not rare: `fantail campaign` answers it with the same flights, and shows more.");
  }
  return all;
}

page::Chart curve_of(const Study& study) {
  page::Series curve{.name = "margin"};
  for (const auto& [margin, probability] : study.estimate.curve) {
    curve.x.push_back(margin);
    curve.y.push_back(std::log10(probability));
  }
  std::ranges::reverse(curve.x);
  std::ranges::reverse(curve.y);
  return {.label = "Probability of a margin of at most so much",
          .x_label = "margin",
          .y_label = "log10 of the probability",
          .series = {curve},
          .levels = {{.value = 0.0, .label = "fails below", .upright = true, .role = page::Role::limit}}};
}

std::string margin_words(const Study& study) {
  return study.options.question.relation == campaign::Relation::is
             ? "Margin: the smallest of 1 - figure / limit over largest hold error, rest error, Mach number and gyro "
               "bias. Below 0 a flight fails; -1 is a failure without a figure."
             : "Margin: distance of the figure from its bound, in its unit. Below 0 a flight fails.";
}

std::string shell_line(const Study& study, const Found& found) {
  std::string line = "fantail fly " + text::shell_word(study.options.campaign.scenario);
  for (const input::Override& change : study.options.campaign.changes) {
    line += " --set " + text::shell_word(campaign::lines_of({change}));
  }
  for (const std::string& change : found.changes) {
    line += " --set " + text::shell_word(change);
  }
  return line + fmt::format(" --seed {}", found.point.seed);
}

result::Links links_of(const Study& study) {
  result::Links links;
  const auto add = [&](const Found& found, const std::string& name) {
    links.all.push_back(
        {.href = found.folder.empty() ? "" : found.folder + "/report.html",
         .text = name,
         .about = fmt::format(": {}, margin {:.4g}", campaign::outcome_words(found.outcome), found.margin)});
  };
  if (study.likeliest) {
    add(*study.likeliest, "likeliest failure");
  }
  for (std::size_t i = 0; i < study.worst.size(); ++i) {
    add(study.worst[i], fmt::format("worst flight {}", i + 1));
  }
  return links;
}

std::vector<result::Block> flown_again(const Study& study) {
  if (!study.likeliest) {
    return {};
  }
  return {links_of(study), "To fly the likeliest failure again: " + shell_line(study, *study.likeliest)};
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  return {result::listed("", study_fields), result::listed("levels[]", level_fields),
          result::listed("quantities[]", quantity_fields), result::listed("likeliest[], worst[]", found_fields)};
}

result::Document answer(const Study& study) {
  std::vector<QuantityOfMode> quantities;
  for (const Mode& mode : study.modes) {
    for (std::size_t i = 0; i < std::min(quantities_shown, mode.quantities.size()); ++i) {
      quantities.push_back({&mode, &mode.quantities[i]});
    }
  }
  const auto likeliest = study.likeliest ? std::vector{*study.likeliest} : std::vector<Found>{};
  std::vector<result::Block> way{result::table("levels", study.estimate.levels, level_fields), margin_words(study)};
  if (!study.estimate.curve.empty()) {
    way.insert(way.begin(), result::Picture{curve_of(study), "How probable a margin is, from level to level."});
  }
  using enum result::Readers;
  return {
      .kind = "rare failures",
      .title = study.scenario,
      .subtitle = study.options.question.words(),
      .verdict = {.answer = answer_of(study),
                  .heading = heading(study),
                  .sentence = sentence(study),
                  .not_in_it = limits(study),
                  .not_in_it_heading = "Limits of this result:"},
      .facts = {{"scenario", "scenario", study.scenario},
                {"vehicle", "vehicle", study.vehicle},
                {"plan", "plan", study.plan},
                {"question", "question", study.options.question.text()},
                {"changes", "changed", study.made.changes},
                {"seed", "seed", study.options.campaign.seed},
                {"version", "version", study.made.version},
                {"command", "command", study.made.command}},
      .sections = {{"Flown again alone", flown_again(study)},
                   {"What failed flights have in common", {result::table("quantities", quantities, quantity_fields)}},
                   {"Levels of the search", std::move(way)},
                   {"The study", {result::figures("", study, study_fields)}, programs},
                   {"Likeliest", {result::table("likeliest", likeliest, found_fields)}, programs},
                   {"Worst", {result::table("worst", study.worst, found_fields)}, programs}},
      .made = study.made,
      .json_decimals = -8};
}

}  // namespace fantail::rare
