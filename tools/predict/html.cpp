// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "flight/flight.hpp"
#include "page/page.hpp"
#include "predict/charts.hpp"
#include "predict/results.hpp"
#include "predict/sentences.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::fixed;

constexpr double in_degrees = 180.0 / std::numbers::pi;

page::Tone tone(Judgement judgement) {
  switch (judgement) {
    case Judgement::met: return page::Tone::good;
    case Judgement::not_met: return page::Tone::bad;
    case Judgement::not_judged: break;
  }
  return page::Tone::unsure;
}

page::Tone tone(const Decision& decision) {
  if (decision.go) {
    return decision.cautions.empty() ? page::Tone::good : page::Tone::unsure;
  }
  return std::ranges::any_of(decision.criteria, [](const Criterion& c) { return c.judgement == Judgement::not_met; })
             ? page::Tone::bad
             : page::Tone::unsure;
}

page::Figure figure(std::string label, const Quantiles& s, double scale, int decimals, std::string unit) {
  return {.label = std::move(label),
          .value = fixed(scale * s.p50, decimals),
          .unit = std::move(unit),
          .remark = fmt::format("5 to 95 %: {} to {}", fixed(scale * s.p5, decimals), fixed(scale * s.p95, decimals))};
}

page::Figure figure(std::string label, const Share& s) {
  return {.label = std::move(label),
          .value = fixed(100.0 * s.value, 0),
          .unit = "%",
          .remark = fmt::format("of {}; 95 % interval {} to {}", runs(s.of), fixed(std::floor(100.0 * s.low), 0),
                                percent(s.high))};
}

std::string figures(const Prediction& p) {
  std::vector<page::Figure> all{figure("authority margin", p.authority_margin_rad, in_degrees, 1, "deg"),
                                figure("canards can balance the offset", p.authority)};
  all.push_back(figure("roll is held", p.held));
  if (p.worst_speed) {
    all.push_back(figure(fmt::format("phase margin at {} m/s, the worst speed", fixed(p.worst_speed->speed_m_s, 0)),
                         p.worst_speed->phase_margin_rad, in_degrees, 0, "deg"));
  }
  if (p.settle_rad) {
    all.push_back(figure("roll settles at", *p.settle_rad, in_degrees, 1, "deg"));
    all.push_back(figure("its reference then", *p.settle_reference_rad, in_degrees, 1, "deg"));
  }
  if (p.spin_rate_rad_s) {
    all.push_back(figure("spin without authority, at top speed", *p.spin_rate_rad_s, in_degrees, 0, "deg/s"));
  }
  if (p.apogee_m) {
    all.push_back(figure("apogee", *p.apogee_m, 1.0, 0, "m"));
  }
  if (p.drift_m) {
    all.push_back(figure("drift at apogee", *p.drift_m, 1.0, 0, "m"));
  }
  if (p.saturated_share) {
    all.push_back(figure("control time with canards at their limit", *p.saturated_share, 100.0, 0, "%"));
  }
  return page::figure_row(all);
}

/// The heading says it already.
std::string without_heading(const Decision& decision) {
  std::string text = decision.text.substr(decision.text.find(": ") + 2);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string criteria(const Decision& decision) {
  const std::array<page::Column, 4> columns{{{"criterion"}, {"found"}, {"asked for"}, {""}}};
  std::vector<std::vector<page::Cell>> rows;
  rows.reserve(decision.criteria.size());
  for (const Criterion& c : decision.criteria) {
    rows.push_back({{c.label}, {c.found}, {c.required}, {std::string{label(c.judgement)}, tone(c.judgement)}});
  }
  return page::table(columns, rows) + (decision.advice.empty() ? "" : page::list(decision.advice));
}

std::string roll(const Prediction& p) {
  if (p.band.time_s.empty()) {
    return page::paragraph("No run left the pad.");
  }
  return page::figure(roll_angle_chart(p),
                      flight::rejects_offset(p.flown.plan)
                          ? "Roll angle of the rocket as it truly would be. This law takes its estimate of the fin "
                            "offset off the command, so it settles at the reference where the canards reach that far."
                          : "Roll angle of the rocket as it truly would be. A proportional-derivative loop settles at "
                            "the reference plus the fin offset over the gain, not at the reference.") +
         page::figure(roll_rate_chart(p),
                      "How fast it turns. The band is the spread of the runs at each instant, not one run.");
}

std::string stability(const Prediction& p, const Decision& decision) {
  if (p.over_speed.empty()) {
    return page::paragraph("No phase margin could be computed: control never begins, or its gains are zero.");
  }
  const std::array<page::Column, 4> columns{{{"air speed, m/s", true},
                                             {"phase margin, deg", true},
                                             {"crossover, rad/s", true},
                                             {"gain margin, times", true}}};
  std::vector<std::vector<page::Cell>> rows;
  constexpr std::size_t rows_apart = 4;
  const auto with_ends = [](const Quantiles& s, double scale, int decimals) {
    return fmt::format("{} ({} to {})", fixed(scale * s.p50, decimals), fixed(scale * s.p5, decimals),
                       fixed(scale * s.p95, decimals));
  };
  for (std::size_t i = 0; i < p.over_speed.size(); i += rows_apart) {
    const MarginsAtSpeed& at = p.over_speed[i];
    rows.push_back({{fixed(at.speed_m_s, 0)},
                    {with_ends(at.phase_margin_rad, in_degrees, 0)},
                    {at.crossover_rad_s ? with_ends(*at.crossover_rad_s, 1.0, 1) : "none"},
                    {at.gain_margin ? with_ends(*at.gain_margin, 1.0, 1) : "any"}});
  }
  return page::figure(phase_margin_chart(p, decision.thresholds),
                      fmt::format("How far the loop is from oscillating, from the speed at which control starts to "
                                  "top speed, with a servo lag of {} ms and {} ms of dead time.",
                                  text::brief(1e3 * p.servo_lag_s, 1), text::brief(1e3 * p.delay_s, 1))) +
         page::table(columns, rows) +
         (std::ranges::any_of(p.over_speed, may_swing_with_less)
              ? page::note("Where the loop holds, a gain margin below 1 says with how much less gain it swings.")
              : "");
}

std::string airframes(const Prediction& p) {
  const std::array<std::string, 2> pair{
      page::figure(offset_chart(p), "The fin offset against what the canards can balance."),
      page::figure(airframe_chart(p), "The airframes that were flown, and the identified ones they were drawn from.")};
  return page::side_by_side(pair);
}

std::string repetition(const Prediction& p) {
  return page::paragraph(fmt::format(
      "runs.csv has a row for each run. This command flies one of them again, the first in this case, and writes its "
      "flight report: {}",
      repeat_command(p, "0")));
}

}  // namespace

std::string prediction_html(const Prediction& p, const Decision& decision, std::string_view version) {
  const std::string heading{decision.heading()};
  const std::string changes = p.request.changes.empty() ? "" : ". " + changes_sentence(p);
  const std::string warning = resonance_warning(p);
  const std::string resonance = warning.empty() ? "" : page::section("Roll and pitch", page::paragraph(warning));
  std::vector<page::Page::Finding> left_out;
  for (const std::string& sentence : not_in_verdict(p)) {
    left_out.push_back({.what = "Beside the requirements:", .about = sentence});
  }
  return page::html(
      {.kind = "Fantail launch prediction",
       .title = p.scenario,
       .subtitle = fmt::format("{}, plan {}; {}, seed {}; Fantail {}{}", p.vehicle, p.plan_name, runs(p.runs.size()),
                               p.seed, version, changes),
       .tone = tone(decision),
       .verdict_heading = heading,
       .verdict = without_heading(decision),
       .findings = std::move(left_out),
       .body_html =
           page::section("Median of the runs", figures(p)) + page::section("Requirements", criteria(decision)) +
           page::section("Predicted roll", roll(p)) + page::section("Fin offset and airframe", airframes(p)) +
           resonance + page::section("Stability over speed", stability(p, decision)) +
           page::section("How this was found", page::list(basis(p))) + page::section("Any run again", repetition(p))});
}

}  // namespace fantail::predict
