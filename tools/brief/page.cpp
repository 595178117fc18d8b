// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "brief/brief.hpp"
#include "brief/sentences.hpp"
#include "hal/signal_pattern.hpp"
#include "text/number.hpp"

namespace fantail::brief {
namespace {

using text::fixed;

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string rows(const Rows& list) {
  std::string all;
  for (const auto& [label, value] : list) {
    all += fmt::format("<dt>{}</dt><dd>{}</dd>\n", page::printed(label), page::printed(value));
  }
  return "<dl>\n" + all + "</dl>\n";
}

std::string rocket(const Brief& of) {
  const std::string size = of.length_m && of.diameter_m
                               ? fmt::format("{} m long, {} mm in diameter", text::brief(*of.length_m, 2),
                                             text::brief(1e3 * *of.diameter_m, 0))
                               : "not stated in the vehicle file";
  return page::section(
      "Rocket", rows({{"Size", size},
                      {"Lift-off mass", text::brief(of.mass_kg, 2) + " kg"},
                      {"Total impulse", fmt::format("{} N s, class {}", fixed(of.impulse_n_s, 0), of.motor_class)},
                      {"Guide", fmt::format("{} m, {}", text::brief(of.guide_length_m, 1), lean(of))},
                      {"Speed at guide exit", fixed(of.nominal.guide_exit.speed_m_s, 1) + " m/s over ground"},
                      {"Top speed", fixed(of.nominal.top_speed_m_s, 0) + " m/s over ground"},
                      {"Apogee", fixed(of.nominal.apogee_m, 0) + " m above the site"},
                      {"Roll control", of.nominal.roll}}));
}

std::string wind_section(const Brief& of) {
  return page::section("Wind", rows({{"Flown here", wind_flown(of)}}) + page::list(wind_sentences(of)) +
                                   "<p class=\"blank\">Limit set by the team: <i></i> m/s</p>\n");
}

std::string sentences(const std::string& heading, const std::vector<std::string>& all) {
  return page::section(heading, page::list(all));
}

std::string strip(std::string_view pattern) {
  std::string boxes;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '#') {
      boxes += fmt::format("<path d=\"M{} 0h6v10h-6z\"/>", 6 * i);
    }
  }
  return fmt::format("<svg class=\"strip\" viewBox=\"0 0 {} 10\" role=\"img\" aria-label=\"{}\">{}</svg>",
                     6 * pattern.size(), pattern, boxes);
}

std::string signal_table() {
  std::string all;
  for (const SignalMeaning& one : signal_meanings()) {
    const hal::SignalPattern pattern = hal::pattern(one.signal);
    all += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", page::printed(one.phase),
                       strip(pattern.light), strip(pattern.sound), page::printed(one.meaning));
  }
  return page::section(
      "Light and buzzer, two seconds of each",
      "<div class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"Light and "
      "buzzer\"><table>\n<thead><tr><th>State</th><th>Light</th><th>Buzzer</th><th>Meaning</th></tr></thead>\n"
      "<tbody>\n" +
          all + "</tbody></table></div>\n");
}

/// "3 FAIL, 4 PASS": how many of each, in the order in which they first come.
std::string counts(const Rules& rules) {
  std::vector<std::pair<std::string, std::size_t>> all;
  for (const Rules::Clause& clause : rules.clauses) {
    const auto found = std::ranges::find(all, clause.outcome, [](const auto& one) { return one.first; });
    if (found == all.end()) {
      all.emplace_back(clause.outcome, 1);
    } else {
      ++found->second;
    }
  }
  std::string text;
  for (const auto& [outcome, count] : all) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, outcome);
  }
  return text;
}

/// Those that do not pass come first: the sheet has room for few lines.
std::string clauses(const Rules& rules) {
  std::string all;
  for (const bool passes : {false, true}) {
    for (const Rules::Clause& clause : rules.clauses) {
      if ((clause.outcome == "PASS") == passes) {
        all += fmt::format("{}{} {}", all.empty() ? "" : " \u00b7 ", clause.id, clause.outcome);
      }
    }
  }
  return all;
}

std::string few_lines(const std::string& text) { return fmt::format("<p class=\"few\">{}</p>\n", page::printed(text)); }

std::string rules(const Brief& of) {
  if (!of.rules) {
    return page::section("Rules", page::paragraph("rules: not checked"));
  }
  const Rules& all = *of.rules;
  return page::section(
      "Rules", few_lines(fmt::format("{}: {}.{}{}", all.pack, counts(all), all.flown.empty() ? "" : " ", all.flown)) +
                   few_lines(clauses(all)) + few_lines(all.caution));
}

constexpr const char* signatures =
    "<section class=\"blanks\">\n"
    "<p>Date</p><p>Weather, wind m/s</p><p>Pad crew</p><p>Range safety officer</p>\n"
    "</section>\n";

}  // namespace

std::string page_html(const Brief& of, const result::Made& made) {
  const core::AbortInput abort = of.plan.run.abort_input;
  const std::vector<std::string> columns{
      "<div>" + rocket(of) + wind_section(of) + sentences("Where it comes down", landing_sentences(of)) + "</div>",
      "<div>" + sentences("When canards may move", gate_sentences(of)) +
          sentences("What ends control", end_sentences(of)) +
          page::section("Abort input", page::paragraph(abort_sentence(abort))) +
          sentences("To disarm", disarm_sentences(abort)) + "</div>"};
  page::Page page{.kind = "Fantail \u00b7 brief for the range safety officer",
                  .title = of.vehicle,
                  .subtitle = fmt::format("Scenario {}, plan {}", of.scenario, of.plan_name),
                  .tone = page::Tone::bad,
                  .verdict_heading = "Simulated only",
                  .verdict = fmt::format("{} {}", never_flown, doubts(of)),
                  .stamped = true,
                  .body_html = "<div class=\"sheet\">\n" + page::side_by_side(columns) + signal_table() + rules(of) +
                               signatures + "</div>\n"};
  if (made.command != page::made_by_command()) {
    page.command = made.command;
  }
  return page::html(page);
}

}  // namespace fantail::brief
