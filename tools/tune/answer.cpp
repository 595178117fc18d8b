// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "json/value.hpp"
#include "report/verdict.hpp"
#include "text/degrees.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using result::Cell;
using Json = json::Value;
namespace u = result::units;

Cell value(bool is, float number) { return is ? Cell{static_cast<double>(number)} : Cell{}; }

using J = Judged;
constexpr auto plan_fields = result::fields<J>({
    {"proportional_gain", "kp", u::none, 3,
     [](const J& j) { return Cell{static_cast<double>(j.plan.controller.proportional_gain)}; }, "proportional gain"},
    {"derivative_gain", "kd", u::s, 3,
     [](const J& j) { return Cell{static_cast<double>(j.plan.controller.derivative_gain_s)}; }, "derivative gain"},
    {"integral_gain_per_s", "integral gain, 1/s", u::none, 3,
     [](const J& j) {
       return value(j.plan.offset.rejection == core::OffsetRejection::integral, j.plan.offset.integral_gain_per_s);
     },
     "integral gain; null for another kind of law"},
    {"observer_bandwidth", "observer", u::rad_s, 2,
     [](const J& j) {
       return value(j.plan.offset.rejection == core::OffsetRejection::observer, j.plan.offset.observer_bandwidth_rad_s);
     },
     "bandwidth of the observer; null for another kind of law"},
    {"least_phase_margin", "least phase margin", u::deg, 1, [](const J& j) { return Cell{j.least.phase_margin_rad}; },
     "the least phase margin over spread and speeds"},
    {"at_speed", "at", u::m_s, 0, [](const J& j) { return Cell{j.least.speed_m_s}; }, "the speed with that margin"},
    {"settling", "settles in", u::s, 2, &J::settling_s,
     "the slowest step of the linear loop at median and top speed; null: longer than 10 s"},
    {"command_noise", "noise of the command", u::deg, 3, &J::noise_rad,
     "standard deviation of the command about its mean over a fifth of a second, once settled"},
});

constexpr auto loop_fields = result::fields<LoopAtSpeed>({
    {"speed", "air speed", u::m_s, 0, &LoopAtSpeed::speed_m_s, "air speed"},
    {"least_phase_margin", "least phase margin", u::deg, 0, &LoopAtSpeed::least_phase_margin_rad,
     "the least phase margin over the spread"},
    {"crossover", "crossover", u::rad_s, 1, &LoopAtSpeed::crossover_rad_s,
     "where the gain of the loop is one, for the vehicle as it is"},
});

constexpr auto sum_fields = result::fields<Sum>({
    {"flights", "flights", u::none, 0, &Sum::flights, "flights by this plan"},
    {"held", "held", u::none, 0, &Sum::held, "flights that held their roll"},
    {"off_command", "off the command", u::none, 0, &Sum::off_command, "steady flights that rest off their command"},
    {"outside_model", "outside the model", u::none, 0, &Sum::outside_model, "steady flights outside of the roll model"},
    {"settled", "settled", u::none, 0, &Sum::is_settled,
     "whether the errors are those of settled roll in every flight; else of all time under control"},
    {"mean_error", "mean error", u::deg, 2, &Sum::mean_rad, "mean of the flights' mean distances from the reference"},
    {"largest_error", "largest error", u::deg, 1, &Sum::largest_rad,
     "largest distance from the reference in any flight"},
});

Cell mean_error(const Flown& flown) {
  const auto error = compared(flown);
  return error ? Cell{error->mean_rad} : Cell{};
}
Cell largest_error(const Flown& flown) {
  const auto error = compared(flown);
  return error ? Cell{error->largest_rad} : Cell{};
}
Cell outcome(const Flown& flown) { return std::string{report::name(flown.outcome)}; }

using P = Pair;
constexpr auto pair_fields = result::fields<P>({
    {"seed", "seed", u::none, 0, &P::seed, "seed of both flights"},
    {"alpha", "damping", u::m2, 2, &P::damping_m2, "damping of the rocket"},
    {"beta", "torque", u::m, 2, &P::torque_m, "canard torque of the rocket"},
    {"before.mean_error", "old plan, mean error", u::deg, 2, [](const P& p) { return mean_error(p.before); },
     "mean distance from the reference"},
    {"before.largest_error", "at most", u::deg, 1, [](const P& p) { return largest_error(p.before); },
     "largest distance from the reference"},
    {"before.saturated", "at the limit", u::share, 0, [](const P& p) { return Cell{p.before.saturated_share}; },
     "share of the time under control with the command at its limit"},
    {"before.outcome", "old plan", u::none, 0, [](const P& p) { return outcome(p.before); }, "its verdict in a word"},
    {"after.mean_error", "new plan, mean error", u::deg, 2, [](const P& p) { return mean_error(p.after); },
     "mean distance from the reference"},
    {"after.largest_error", "at most", u::deg, 1, [](const P& p) { return largest_error(p.after); },
     "largest distance from the reference"},
    {"after.saturated", "at the limit", u::share, 0, [](const P& p) { return Cell{p.after.saturated_share}; },
     "share of the time under control with the command at its limit"},
    {"after.outcome", "new plan", u::none, 0, [](const P& p) { return outcome(p.after); }, "its verdict in a word"},
});

using T = Tuning;
constexpr auto tuning_fields = result::fields<T>({
    {"lowest_speed", "lowest speed", u::m_s, 0, [](const T& t) { return Cell{t.speeds.range.lowest_m_s}; },
     "lowest speed under control, 20 m/s or the speed at which control begins, if lower"},
    {"median_speed", "median speed", u::m_s, 0, [](const T& t) { return Cell{t.speeds.median_m_s}; },
     "median speed under control"},
    {"highest_speed", "highest speed", u::m_s, 0, [](const T& t) { return Cell{t.speeds.range.highest_m_s}; },
     "highest speed under control"},
    {"spread", "spread", u::none, 2, [](const T& t) { return Cell{t.request.spread}; },
     "factor by which damping and torque may differ from the vehicle's"},
    {"largest_offset", "fin offset", u::deg, 1, &T::largest_offset_rad, "size of the scenario's fin offset"},
    {"canards_balance", "canards can balance", u::deg, 1, &T::reach_rad, "offset that the canards can balance"},
});

Json schedule(const core::GainSchedulePlan& plan) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < plan.speeds_count; ++i) {
    rows.push_back({{"speed_m_s", json::rounded(static_cast<double>(plan.speeds_m_s[i]))},
                    {"factor", json::rounded(static_cast<double>(plan.factors[i]))}});
  }
  return rows;
}

void add_plan(std::vector<result::Block>& blocks, const std::string& key, const Judged& judged) {
  blocks.emplace_back(result::figures(key, judged, plan_fields));
  blocks.emplace_back(result::table(key + ".over_speed", judged.loop, loop_fields));
  blocks.emplace_back(result::Data{key + ".gain_schedule", schedule(judged.plan.gain_schedule)});
}

std::vector<result::Block> for_programs(const T& t) {
  std::vector<result::Block> all{result::figures("", t, tuning_fields), result::table("flights", t.pairs, pair_fields)};
  add_plan(all, "before", t.before);
  if (t.after) {
    add_plan(all, "after", *t.after);
    all.emplace_back(result::figures("flown_before", t.flown_before(), sum_fields));
    all.emplace_back(result::figures("flown_after", t.flown_after(), sum_fields));
  } else {
    all.emplace_back(result::Data{"after", {}});
  }
  return all;
}

/// Both plans below each other, or the old one alone.
std::vector<result::Block> law(const T& t) {
  std::vector<result::Block> all;
  std::vector<Judged> plans{t.before};
  if (t.after) {
    all.emplace_back(fmt::format("Gains of {} (the plan has {}).", law_words(t.after->plan), law_words(t.before.plan)));
    plans.push_back(*t.after);
  }
  all.emplace_back(loop_sentence(t));
  for (const std::string& sentence : t.after ? remarks(t) : std::vector<std::string>{}) {
    all.emplace_back(sentence);
  }
  result::Table both = result::table({}, plans, plan_fields);
  both.columns.insert(both.columns.begin(), result::Column{.key = "plan", .label = "plan"});
  for (std::size_t i = 0; i < both.rows.size(); ++i) {
    both.rows[i].insert(both.rows[i].begin(), std::string{i == 0 ? "old plan" : "new plan"});
  }
  all.emplace_back(std::move(both));
  return all;
}

result::Answer answer_of(const T& t) {
  return t.is_old_enough()                            ? result::Answer::undecided
         : !t.is_proposed()                           ? result::Answer::no
         : t.is_better() && model_sentence(t).empty() ? result::Answer::yes
                                                      : result::Answer::undecided;
}

result::Verdict verdict(const T& t) {
  const std::string outside = model_sentence(t) + (model_sentence(t).empty() ? "" : " ");
  std::vector<std::string> beside{t.alternative, next_step(t)};
  std::erase(beside, "");
  return {.answer = answer_of(t),
          .heading = t.is_old_enough() ? "Keep the present plan"
                     : !t.after        ? "No gains"
                     : t.is_better()   ? "Proposed"
                     : t.is_proposed() ? "Written, but no better in flight"
                                       : "Not proposed",
          .sentence = outside + (t.after ? flights_sentence(t) : present_plan(t) + t.why_none),
          .beside = std::move(beside)};
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  return {result::listed("", tuning_fields), result::listed("before, after", plan_fields),
          result::listed("before.over_speed[], after.over_speed[]", loop_fields),
          result::listed("flown_before, flown_after", sum_fields), result::listed("flights[]", pair_fields)};
}

result::Document answer(const T& t, const std::string& plan_file, const result::Made& made) {
  using enum result::Readers;
  const auto or_null = [](const std::string& text) { return json::text_or_null(text); };
  result::Document document{.kind = "tuning",
                            .title = t.scenario,
                            .subtitle = fmt::format("{}{}; Fantail {}", t.vehicle == t.scenario ? "" : t.vehicle + "; ",
                                                    t.request.command, made.version),
                            .verdict = verdict(t),
                            .facts = {{"scenario", "", t.scenario},
                                      {"vehicle", "", t.vehicle},
                                      {"version", "", made.version},
                                      {"command", "", t.request.command},
                                      {"proposed", "", t.is_proposed()},
                                      {"better", "", t.is_better()},
                                      {"why_none", "", or_null(t.why_none)},
                                      {"plan", t.after ? "plan" : "", or_null(plan_file)},
                                      {"alternative", "", or_null(t.alternative)},
                                      {"outside_model", "", or_null(model_sentence(t))}},
                            .sections = {{t.after ? "The law" : "The plan as it is", law(t)}},
                            .made = made};
  if (t.after) {
    document.sections.push_back({"Margin and bandwidth", loop_pictures(t), files});
  }
  document.sections.push_back({"Bode diagram", bode_diagram(t), files});
  if (t.after) {
    document.sections.push_back({"Roll as flown", step_pictures(t), files});
    document.sections.push_back(
        {"Flights over the spread", {result::numbered(result::table({}, t.pairs, pair_fields), "rocket")}, files});
    document.sections.push_back({"How this was found", {result::Sentences{.all = basis(t)}}});
  }
  document.sections.push_back({"For programs", for_programs(t), programs});
  return document;
}

}  // namespace fantail::tune
