// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "page/page.hpp"
#include "report/figures.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using page::Role;
using text::brief;
using text::degrees;
using text::fixed;

constexpr const char* old_name = "old plan";
constexpr const char* new_name = "new plan";

page::Series series(const char* name, Role role) { return {.name = name, .role = role}; }

template <typename ValueOf>
page::Series over_speed(const Judged& judged, const char* name, Role role, ValueOf value_of) {
  page::Series line = series(name, role);
  for (const LoopAtSpeed& at : judged.loop) {
    line.x.push_back(at.speed_m_s);
    line.y.push_back(value_of(at));
  }
  return line;
}

template <typename ValueOf>
page::Series over_time(const flight::Flight& flight, const char* name, Role role, ValueOf value_of) {
  page::Series line = series(name, role);
  for (const flight::Row& row : flight.rows) {
    if (row.phase == core::Phase::controlling) {
      line.x.push_back(row.time_s);
      line.y.push_back(degrees(value_of(row)));
    }
  }
  return line;
}

std::string loop_figures(const Tuning& t) {
  const auto margin = [](const LoopAtSpeed& at) { return degrees(at.least_phase_margin_rad); };
  const auto bandwidth = [](const LoopAtSpeed& at) {
    return at.crossover_rad_s.value_or(std::numeric_limits<double>::quiet_NaN());
  };
  const double asked_deg = degrees(t.request.phase_margin_rad);
  const page::Chart margins{.label = "Least phase margin over air speed, by both plans",
                            .x_label = "air speed / (m/s)",
                            .y_label = "phase margin / deg",
                            .width = page::half_page,
                            .series = {over_speed(t.before, old_name, Role::measured, margin),
                                       over_speed(*t.after, new_name, Role::model, margin)},
                            .levels = {{.value = asked_deg,
                                        .label = fmt::format("{} degrees asked for", brief(asked_deg, 1)),
                                        .role = Role::limit}}};
  const page::Chart bandwidths{.label = "Crossover over air speed, by both plans",
                               .x_label = "air speed / (m/s)",
                               .y_label = "crossover / (rad/s)",
                               .width = page::half_page,
                               .series = {over_speed(t.before, old_name, Role::measured, bandwidth),
                                          over_speed(*t.after, new_name, Role::model, bandwidth)}};
  const std::array<std::string, 2> pair{
      page::figure(margins, "How far the linear loop is from oscillating: the least of the spread at each speed."),
      page::figure(bandwidths, "The bandwidth: where the loop's gain is one, for the vehicle as it is.")};
  return page::paragraph(loop_sentence(t)) + page::side_by_side(pair);
}

std::string step_figures(const Tuning& t) {
  const auto roll_of = [](const flight::Flight& flight) {
    return [zero_rad = report::true_zero_rad(flight)](const flight::Row& row) {
      return row.truth->roll_angle_rad - zero_rad;
    };
  };
  const auto command = [](const flight::Row& row) { return row.command_rad; };
  page::Series reference = over_time(t.after->flight, "reference", Role::reference,
                                     [](const flight::Row& row) { return row.reference_rad; });
  reference.mark = page::Mark::step;
  const page::Chart angles{
      .label = "Roll angle over time, by both plans",
      .x_label = "time after lift-off / s",
      .y_label = "roll angle / deg",
      .series = {over_time(t.before.flight, old_name, Role::measured, roll_of(t.before.flight)),
                 over_time(t.after->flight, new_name, Role::model, roll_of(t.after->flight)), reference}};
  const page::Chart commands{.label = "Canard command over time, by both plans",
                             .x_label = "time after lift-off / s",
                             .y_label = "command / deg",
                             .series = {over_time(t.before.flight, old_name, Role::measured, command),
                                        over_time(t.after->flight, new_name, Role::model, command)}};
  return page::figure(angles, "The vehicle as it is, flown by both plans without excitation.") +
         page::figure(commands, "What the law asked of the canards.");
}

page::Figure noise(const char* label, const Judged& judged) {
  return {.label = label,
          .value = judged.noise_rad ? fixed(degrees(*judged.noise_rad), 3) : "not known",
          .unit = judged.noise_rad ? "deg" : "",
          .remark = "standard deviation of the command"};
}

std::string noise_figures(const Tuning& t) {
  const std::array<page::Figure, 2> pair{noise(old_name, t.before), noise(new_name, *t.after)};
  return page::figure_row(pair) +
         page::note(
             "About its mean over a fifth of a second, outside of the first second of control and after each "
             "step, in the flights above: what moves the servos for noise alone.");
}

std::string flights_table(const Tuning& t) {
  const std::array<page::Column, 7> columns{{{"rocket", true},
                                             {"damping, m2", true},
                                             {"torque, m", true},
                                             {"old plan, mean error, deg", true},
                                             {"new plan, mean error, deg", true},
                                             {"old plan"},
                                             {"new plan"}}};
  const auto error = [](const Flown& flown) {
    const auto found = compared(flown);
    return found ? page::Cell{.text = fixed(degrees(found->mean_rad), 2),
                              .below = fmt::format("at most {}", fixed(degrees(found->largest_rad), 1))}
                 : page::Cell{.text = "no control"};
  };
  std::vector<std::vector<page::Cell>> rows;
  std::size_t number = 0;
  for (const Pair& pair : t.pairs) {
    rows.push_back({{fmt::format("{}", number++)},
                    {fixed(pair.damping_m2, 2)},
                    {fixed(pair.torque_m, 2)},
                    error(pair.before),
                    error(pair.after),
                    {std::string{report::display_name(pair.before.outcome)}},
                    {std::string{report::display_name(pair.after.outcome)}}});
  }
  return page::table(columns, rows);
}

}  // namespace

std::string tuning_html(const Tuning& t, const std::string& plan_file) {
  const std::string outside = model_sentence(t);
  page::Page all{.kind = "Fantail tuning",
                 .title = t.scenario,
                 .subtitle = fmt::format("{}; {}; Fantail {}", t.vehicle, t.request.command, t.request.version),
                 .tone = result::tone(answer(t))};
  if (!t.after) {
    all.verdict_heading = "No gains";
    all.verdict = outside + (outside.empty() ? "" : " ") + t.why_none;
    all.body_html =
        page::section("The plan as it is", page::paragraph(loop_sentence(t)) +
                                               (t.alternative.empty() ? "" : page::paragraph(t.alternative)));
    return page::html(all);
  }
  all.verdict_heading = t.is_better()     ? "Proposed"
                        : t.is_proposed() ? "Written, but no better in flight"
                                          : "Not proposed";
  all.verdict = fmt::format("{}{}Gains of {} (the plan has {}). {}", outside, outside.empty() ? "" : " ",
                            law_words(t.after->plan), law_words(t.before.plan), flights_sentence(t));
  for (const std::string& sentence : remarks(t)) {
    all.verdict += " " + sentence;
  }
  all.verdict += t.alternative.empty() ? "" : " " + t.alternative;
  all.facts = {{"plan", plan_file}};
  all.body_html = page::section("Margin and bandwidth", loop_figures(t)) +
                  page::section("Steps as flown", step_figures(t)) +
                  page::section("Noise at the servos", noise_figures(t)) +
                  page::section("Flights over the spread", flights_table(t)) +
                  page::section("How this was found", page::list(basis(t)));
  return page::html(all);
}

}  // namespace fantail::tune
