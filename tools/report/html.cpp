// SPDX-License-Identifier: MIT
#include "report/html.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "report/escape.hpp"
#include "report/html_tables.hpp"
#include "report/numbers.hpp"
#include "report/overview_svg.hpp"
#include "report/page_assets.hpp"
#include "report/plot_data.hpp"
#include "report/words.hpp"

namespace fantail::report {
namespace {

std::string head(const Flight& flight) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{} \u00b7 Fantail flight report</title>\n"
      "<style>{}</style>\n<style>{}</style>\n</head>\n",
      escape_html(flight.scenario), uplot_css, page_css);
}

// A formula does not break across lines.
std::string with_formula(std::string text) {
  static constexpr std::string_view formula = "R + u_d/kp";
  if (const std::size_t at = text.find(formula); at != std::string::npos) {
    text.replace(at, formula.size(), "<span class=\"formula\">R + u_d/kp</span>");
  }
  return text;
}

std::string run_words(const Flight& flight) {
  std::vector<std::string> parts;
  if (!flight.vehicle.empty()) {
    parts.push_back(fmt::format("vehicle <b>{}</b>", escape_html(flight.vehicle)));
  }
  if (!flight.plan_name.empty()) {
    parts.push_back(fmt::format("plan <b>{}</b>", escape_html(flight.plan_name)));
  }
  if (flight.seed) {
    parts.push_back(fmt::format("seed {}", *flight.seed));
  }
  if (!flight.version.empty()) {
    parts.push_back("Fantail " + escape_html(flight.version));
  }
  std::string words = fmt::format("{}", fmt::join(parts, ", "));
  if (words.starts_with('v') || words.starts_with('p') || words.starts_with('s')) {
    words.front() = static_cast<char>(words.front() - 'a' + 'A');
  }
  return words;
}

std::string opening(const Flight& flight, const Verdict& verdict) {
  const std::string imposed = imposed_roll_words(flight);
  return fmt::format(
      "<header>\n<p class=\"kind\">Fantail flight report</p>\n<h1>{}</h1>\n"
      "<p class=\"run\">{}</p>\n</header>\n"
      "<section class=\"verdict {}\">\n<h2>{}</h2>\n<p>{}</p>\n{}</section>\n",
      escape_html(flight.scenario), run_words(flight), name(verdict.outcome), words(verdict.outcome),
      with_formula(with_minus(escape_html(verdict.text))),
      imposed.empty() ? "" : "<p class=\"imposed\">" + with_minus(escape_html(imposed)) + "</p>\n");
}

}  // namespace

std::string html(const Flight& flight, const Figures& figures, const Verdict& verdict) {
  std::string page = head(flight);
  page += "<body>\n<main>\n" + opening(flight, verdict);
  page += "<section>\n<h2>Figures</h2>\n" + figure_list(flight, figures) + "</section>\n";
  page += "<section id=\"plots\">\n<h2>The flight</h2>\n" + phase_legend(flight);
  page +=
      "<figure id=\"overview\">" + overview_svg(flight) + "<figcaption>Roll angle over time</figcaption></figure>\n";
  page += "</section>\n<div class=\"columns\">\n";
  page += "<section>\n<h2>Events</h2>\n" + event_table(flight) + "</section>\n";
  page += "<section>\n<h2>Phases</h2>\n" + phase_table(flight) + canard_table(flight) + "</section>\n</div>\n";
  if (flight.seed || !flight.notes.empty()) {
    page += fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", flight.seed ? "What was assumed" : "About the log",
                        assumption_list(flight));
  }
  page +=
      "<footer><p>Every tick is in <b>flight.csv</b>, every figure in <b>summary.json</b>, beside this page. The plots "
      "leave out most samples but no peak. Plots drawn with uPlot (MIT licence, in the source of this "
      "page).</p></footer>\n"
      "</main>\n";
  page +=
      "<script type=\"application/json\" id=\"flight-data\">" + escape_script_json(plot_data(flight)) + "</script>\n";
  page += fmt::format("<script>\n/*\n{}*/\n{}</script>\n<script>\n{}</script>\n</body>\n</html>\n", uplot_licence,
                      uplot_js, page_js);
  return page;
}

}  // namespace fantail::report
