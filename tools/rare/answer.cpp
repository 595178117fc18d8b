// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/results.hpp"
#include "flight/fly_command.hpp"
#include "page/chart.hpp"
#include "rare/margin.hpp"
#include "rare/sentences.hpp"

namespace fantail::rare {
namespace {

using result::Cell;
namespace u = result::units;

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
    {"by_events", "failed without a figure", u::none, 0, &Study::events,
     "flights of the first level that failed by something that no figure measures; the probability leaves them out"},
    {"events_at_most", "failures without a figure, at most", u::none, 9,
     [](const Study& s) { return Cell{events_bound(s)}; }, "95 % upper bound for the probability of those"},
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

constexpr std::size_t quantities_shown = 4;

/// A quantity of a mode.
struct QuantityOfMode {
  const Mode* mode;
  const Quantity* quantity;
};
const char* direction(const Quantity& quantity) {
  return !quantity.is_one_way() ? "either way" : quantity.mean_sigmas > 0.0 ? "higher" : "lower";
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
    {"distance", "distance", u::none, 2, [](const QuantityOfMode& q) { return Cell{q.quantity->far_sigmas()}; },
     "how far it is from its mean in these flights (root of the mean square), in standard deviations of its law; 1 in "
     "all flights"},
    {"direction", "direction", u::none, 0,
     [](const QuantityOfMode& q) { return Cell{std::string{direction(*q.quantity)}}; },
     "higher or lower than its mean, or either way"},
});

Cell words_or_none(const std::string& words) { return words.empty() ? Cell{} : Cell{words}; }
constexpr auto found_fields = result::fields<Found>({
    {"margin", "margin", u::none, 4, [](const Found& f) { return f.margin >= just_failed ? Cell{} : Cell{f.margin}; },
     "margin of the flight; below 0 it fails; null: no figure measures by what it fails, or it is just at a limit"},
    {"outcome", "outcome", u::none, 0, [](const Found& f) { return words_or_none(f.outcome); },
     "outcome of the flight, flown again alone"},
    {"seed", "seed", u::none, 0, [](const Found& f) { return Cell{f.point.seed}; }, "its seed"},
    {"changes", "values", u::none, 0, [](const Found& f) { return Cell{fmt::format("{}", fmt::join(f.changes, " "))}; },
     "values that were drawn for it"},
    {"folder", "folder", u::none, 0, [](const Found& f) { return words_or_none(f.folder); },
     "folder of its flight report; null: it was not flown"},
});

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
             ? "Margin: how far the figure that is nearest to its limit is from it, in standard deviations of that "
               "figure over 100 plain flights. Below 0 a flight fails."
             : "Margin: distance of the figure from its bound, in its unit. Below 0 a flight fails.";
}

std::string command_of(const Study& study, const Found& found) {
  std::vector<std::string> changes;
  for (const input::Override& change : study.options.campaign.changes) {
    changes.push_back(campaign::lines_of({change}));
  }
  changes.insert(changes.end(), found.changes.begin(), found.changes.end());
  changes.push_back(fmt::format("seed={}", found.point.seed));
  return flight::fly_command(study.options.campaign.scenario, changes);
}

result::Links links_of(const Study& study) {
  result::Links links;
  const auto add = [&](const Found& found, const std::string& name) {
    links.all.push_back(
        {.href = found.folder.empty() ? "" : found.folder + "/report.html",
         .text = name,
         .about = fmt::format(": {}{}", campaign::outcome_words(found.outcome),
                              found.margin >= just_failed ? "" : fmt::format(", margin {:.4g}", found.margin))});
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
  return {links_of(study), "To fly the likeliest failure again: " + command_of(study, *study.likeliest)};
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
      if (mode.quantities[i].has_moved()) {
        quantities.push_back({&mode, &mode.quantities[i]});
      }
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
