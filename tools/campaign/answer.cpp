// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/core.h>

#include "campaign/results.hpp"
#include "campaign/setup.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

using Json = json::Value;
using result::Cell;
using result::Named;
using result::Worse;
namespace u = result::units;

constexpr auto column_fields = result::fields<Column>({
    {"name", "figure", u::none, 0,
     [](const Column& c) { return Cell{Named{c.name, column_words(c.name).with_unit()}}; },
     "its column in runs.csv.gz; it ends with the unit of the row"},
    {"runs", "runs", u::none, 0, [](const Column& c) { return Cell{std::uint64_t{c.values.size()}}; },
     "runs that have this figure"},
    {"mean", "mean", u::none, 0, [](const Column& c) { return Cell{c.quantiles.mean}; }, "mean of these runs",
     Worse::neither, five_digits},
    {"least", "least", u::none, 0, &Column::least, "least value", Worse::neither, five_digits},
    {"p5", "5 %", u::none, 0, [](const Column& c) { return Cell{c.quantiles.p5}; },
     "value below which 5 % of the runs lie", Worse::neither, five_digits},
    {"p50", "median", u::none, 0, [](const Column& c) { return Cell{c.quantiles.p50}; },
     "value below which half of the runs lie", Worse::neither, five_digits},
    {"p95", "95 %", u::none, 0, [](const Column& c) { return Cell{c.quantiles.p95}; },
     "value below which 95 % of the runs lie", Worse::neither, five_digits},
    {"largest", "largest", u::none, 0, &Column::largest, "largest value", Worse::neither, five_digits},
});

constexpr std::string_view name(Judgement judgement) {
  return judgement == Judgement::met ? "met" : judgement == Judgement::not_met ? "not met" : "undecided";
}

using R = Report;
constexpr auto report_fields = result::fields<R>({
    {"question", "what is counted", u::none, 0, [](const R& r) { return Cell{r.analysis.question.text()}; },
     "condition that a run must meet"},
    {"required", "required", u::share, 1,
     [](const R& r) { return r.analysis.required ? Cell{*r.analysis.required} : Cell{}; },
     "the required share; null: none"},
    {"judgement", "judgement", u::none, 0,
     [](const R& r) {
       return r.analysis.judgement ? Cell{result::Judged{answer_of(r), std::string{name(*r.analysis.judgement)}}}
                                   : Cell{};
     },
     "met, not_met or undecided, for the share alone; null: none is required"},
    {"runs", "runs", u::none, 0, [](const R& r) { return Cell{std::uint64_t{r.flown.runs.size()}}; }, "runs flown"},
    {"runs_asked", "runs at most", u::none, 0, [](const R& r) { return Cell{r.campaign.runs}; }, "runs asked for"},
    {"runs_outside_model", "runs outside the model", u::none, 0,
     [](const R& r) { return Cell{std::uint64_t{runs_outside_the_model(r)}}; },
     "runs in which the roll model is not valid"},
    {"runs_drawn_again", "runs drawn again", u::none, 0,
     [](const R& r) { return Cell{std::uint64_t{r.analysis.drawn_again}}; },
     "runs with a draw outside the range of its field"},
});

Json share_of(const Analysis& a) {
  Json share = result::json_of(u::none, a.share);
  share["interval"] = a.by_sequence ? "confidence_sequence" : "wilson";
  return share;
}

std::string heading(const Report& report) {
  const std::optional<Judgement>& judgement = report.analysis.judgement;
  if (runs_outside_the_model(report) > 0) {
    return "Outside the model";
  }
  return !judgement                         ? "Found"
         : *judgement == Judgement::met     ? "Met"
         : *judgement == Judgement::not_met ? "Not met"
                                            : "Not decided";
}

constexpr auto instant_fields = result::fields<RollBand::Instant>({
    {"time", "time", u::s, 2, &RollBand::Instant::time_s, "after lift-off, in the tunnel after control start"},
    {"roll_angle", "roll angle", u::deg, 1, &RollBand::Instant::roll_rad, "true roll angle of the runs of the band"},
    {"reference", "reference", u::deg, 1, &RollBand::Instant::reference_rad, "commanded roll angle"},
});

std::vector<result::Block> roll(const RollBand& band, std::size_t runs, const result::Table& instants) {
  if (band.instants.empty()) {
    return {};
  }
  result::Picture picture = result::plot(instants, "roll_angle", {.x = "time"}).wide();
  picture.chart.x_label = band.in_tunnel ? "time after control start / s" : "time after lift-off / s";
  page::Series reference{.name = "reference", .role = page::Role::reference, .mark = page::Mark::step};
  for (const RollBand::Instant& instant : band.instants) {
    reference.x.push_back(instant.time_s);
    reference.y.push_back(instant.reference_rad ? text::degrees(*instant.reference_rad)
                                                : std::numeric_limits<double>::quiet_NaN());
  }
  picture.chart.series.push_back(std::move(reference));
  picture.caption = band.runs == runs
                        ? "The true roll angle of all runs, until control ends."
                        : fmt::format("The true roll angle of the first {} that flew, until control ends.",
                                      text::counted(band.runs, "run"));
  return {picture};
}

/// For people; of each run its mean is for programs.
result::Table shown(const result::Table& columns) {
  return result::only(columns, {"name", "runs", "least", "p5", "p50", "p95", "largest"});
}

std::vector<result::Block> distributions(const Analysis& analysis, const result::Table& figures) {
  std::vector<result::Block> all;
  for (const Column& c : analysis.figures) {
    if (c.largest > c.least) {
      all.emplace_back(result::Picture{histogram(c), runs_beyond_histogram(c)});
    }
  }
  all.emplace_back(shown(figures));
  return all;
}

std::vector<result::Block> landings(const std::optional<Landings>& of) {
  if (!of) {
    return {};
  }
  return {result::Picture{landing_map(*of), "Each point is a run; the guide stands at 0, 0. Seen from above."},
          result::Sentences{.all = landing_sentences(*of)}};
}

std::vector<std::string> changes_of(const Campaign& campaign) {
  std::vector<std::string> all;
  all.reserve(campaign.changes.size());
  for (const input::Override& change : campaign.changes) {
    all.push_back(lines_of({change}));
  }
  return all;
}

std::string subtitle(const Report& report) {
  std::string changes;
  for (const std::string& change : changes_of(report.campaign)) {
    changes += (changes.empty() ? ". Changed: " : ", ") + change;
  }
  return fmt::format("{}, plan {}; {}, independent, seed {}{}", report.flown.vehicle, report.flown.plan,
                     text::counted(report.flown.runs.size(), "run"), report.campaign.seed, changes);
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  std::vector<result::Listed> all{result::listed("", report_fields),
                                  result::listed("figures[], quantities[]", column_fields)};
  std::ranges::move(listed_of_runs(), std::back_inserter(all));
  all.push_back(listed_landing());
  all.push_back(result::listed("band.csv", instant_fields));
  return all;
}

result::Document answer(const Report& report) {
  using enum result::Readers;
  const Analysis& a = report.analysis;
  const Campaign& campaign = report.campaign;
  const result::Table figures = result::table("figures", a.figures, column_fields);
  const result::Table quantities = result::table("quantities", a.quantities, column_fields);
  const result::Table instants = result::table("band", report.roll_band.instants, instant_fields);
  return {.kind = "campaign",
          .title = report.flown.scenario,
          .subtitle = subtitle(report),
          .verdict = {.answer = answer_of(report), .heading = heading(report), .sentence = headline(report)},
          .facts = {{"scenario", "", report.flown.scenario},
                    {"vehicle", "", report.flown.vehicle},
                    {"plan", "", report.flown.plan},
                    {"changes", "", changes_of(campaign)},
                    {"version", "", report.made.version},
                    {"seed", "", campaign.seed},
                    {"sampling", "", "independent"},
                    {"stop", "", campaign.stop ? Json{campaign.stop->text()} : Json{}}},
          .sections = {{"Roll angle of the runs", roll(report.roll_band, report.flown.runs.size(), instants), files},
                       {"Outcomes", outcomes(report)},
                       {"Influences", influences(report)},
                       {"Figures of the runs", distributions(a, figures)},
                       {"Slopes of the other figures", {slopes_of_other_figures(a)}, files},
                       {"Where the runs land", landings(report.landings)},
                       {"The worst runs", worst(report)},
                       {"Drawn quantities", {shown(quantities)}, files},
                       {.heading = "How the share settled",
                        .blocks = {result::Picture{convergence_chart(report)}},
                        .folded = "The share over the number of runs"},
                       {"Limits of this result", {result::Sentences{"remarks", remarks(report)}}},
                       {"Repeat", {report.command}},
                       {"For programs",
                        {result::figures("", report, report_fields), result::Data{"share", share_of(a)}, figures,
                         quantities, landing_figures(report.landings.value_or(Landings{})),
                         result::Data{"influences", influences_for_programs(a)}, worst_for_programs(report)},
                        programs}},
          .spreadsheets = {instants},
          .made = report.made};
}

}  // namespace fantail::campaign
