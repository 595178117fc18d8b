// SPDX-License-Identifier: MIT
#include "identify/result/validation_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "identify/result/charts.hpp"
#include "identify/result/formatting.hpp"
#include "identify/result/json_numbers.hpp"
#include "identify/result/outputs.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::identify::result {
namespace {

using Json = json::Value;
using text::brief;
using text::degrees;
using text::fixed;

const Identification& held(const ValidatedWindow& window) { return window.window.results.front(); }

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// A line of the comparison: of the known model, and of the window's own.
struct Line {
  std::string label;
  std::string known;
  std::string own;
};

std::string known_value(const Validation& v, Eigen::Index which) {
  const Constants& c = v.model.constants;
  return v.model.covariance_is_known ? value_with_deviation(c.value(which), std::sqrt(c.covariance(which, which)))
                                     : constant_text(c.value(which));
}

std::vector<Line> lines(const Validation& v, const ValidatedWindow& window) {
  const model::Record& record = window.window.record;
  const auto angle = [&](const Identification& r) {
    return fixed(degrees(rms(record.roll_angle_rad, r.simulation.roll_angle_rad)), 3);
  };
  const auto rate = [&](const Identification& r) {
    return fixed(degrees(rms(record.roll_rate_rad_s, r.simulation.roll_rate_rad_s)), 2);
  };
  const auto explained = [&](const Identification& r) {
    return fixed(std::floor(1e4 * explained_share(record, r.simulation)) / 100.0, 2) + " %";  // 99.999 is not all
  };
  const Identification& known = held(window);
  return {{"damping alpha / m2", known_value(v, 0), with_deviation(window.own, 0)},
          {"torque constant beta / m", known_value(v, 1), with_deviation(window.own, 1)},
          {"angle error / deg, rms", angle(known), angle(window.own)},
          {"rate error / deg/s, rms", rate(known), rate(window.own)},
          {"variance of the rate explained", explained(known), explained(window.own)}};
}

std::string heading(const ValidatedWindow& window) {
  return !window.can_tell() ? "This window cannot tell"
         : window.holds()   ? "The model holds"
                            : "The model does not hold";
}

std::string figures(const ValidatedWindow& window) {
  return fmt::format("chi-square {}; of models that are right 95 in 100 stay below {}",
                     fixed(window.agreement.chi_square, 1), fixed(window.agreement.limit, 1));
}

Json object(const Validation& v, const ValidatedWindow& window) {
  const model::Record& record = window.window.record;
  const auto errors = [&](const Identification& r) {
    return Json{{"alpha_m2", rounded(r.model.alpha_m2)},
                {"beta_m", rounded(r.model.beta_m)},
                {"disturbance_deg", list(r.model.node_rad, degrees(1.0))},
                {"rms_angle_error_deg", rounded(degrees(rms(record.roll_angle_rad, r.simulation.roll_angle_rad)))},
                {"rms_rate_error_deg_s", rounded(degrees(rms(record.roll_rate_rad_s, r.simulation.roll_rate_rad_s)))},
                {"explained_share", rounded(explained_share(record, r.simulation))}};
  };
  return {{"window", record.window},
          {"samples", record.size()},
          {"model", errors(held(window))},
          {"own", errors(window.own)},
          {"own_alpha_interval_m2", pair(window.own.uncertainty->alpha_profile_m2)},
          {"own_beta_interval_m", pair(window.own.uncertainty->interval[1])},
          {"chi_square", rounded(window.agreement.chi_square)},
          {"chi_square_limit", rounded(window.agreement.limit)},
          {"can_tell", window.can_tell()},
          {"holds", window.can_tell() ? Json{window.holds()} : Json{}},
          {"verdict", verdict(v, window)},
          {"remarks", remarks(window.window, window.own)}};
}

std::string section_of(const Validation& v, const ValidatedWindow& window) {
  std::vector<std::vector<page::Cell>> rows;
  for (const Line& line : lines(v, window)) {
    rows.push_back({{printable(line.label)}, {printable(line.known)}, {printable(line.own)}});
  }
  std::string out = page::table(
      std::vector<page::Column>{{"\u00b1: standard deviation", false}, {"the model", true}, {"by itself", true}}, rows);
  out += page::note("By itself: what this window says when alpha and beta are fitted to it, too.");
  out += page::figure(motion_chart(window.window, Motion::angle)) +
         page::figure(motion_chart(window.window, Motion::rate));
  out += page::side_by_side(std::vector{page::figure(residual_chart(window.window, Motion::angle)),
                                        page::figure(residual_chart(window.window, Motion::rate))});
  const std::vector<std::string> said = remarks(window.window, window.own);
  return page::section("Window " + window.window.record.window,
                       page::paragraph(extent(window.window.record)) +
                           (v.windows.size() > 1 ? page::paragraph(verdict(v, window)) : "") + out +
                           (said.empty() ? "" : page::list(said)));
}

}  // namespace

bool ValidatedWindow::can_tell() const {
  return own.uncertainty->alpha_identifiable && own.uncertainty->beta_identifiable;
}

double ValidatedWindow::largest_difference() const {
  const model::RollModel& known = held(*this).model;
  return std::max(std::abs(known.alpha_m2 / own.model.alpha_m2 - 1.0), std::abs(known.beta_m / own.model.beta_m - 1.0));
}

bool ValidatedWindow::holds() const { return agreement.agree() || largest_difference() < no_matter; }

double explained_share(const model::Record& record, const model::Simulation& simulation) {
  const std::vector<double>& measured = record.roll_rate_rad_s;
  const double mean = std::accumulate(measured.begin(), measured.end(), 0.0) / static_cast<double>(measured.size());
  const double left = rms(measured, simulation.roll_rate_rad_s);
  const double all = rms(measured, std::vector<double>(measured.size(), mean));
  return 1.0 - left * left / (all * all);
}

std::string verdict(const Validation& v, const ValidatedWindow& window) {
  const std::string difference = fmt::format("its alpha and beta are up to {} % from what this window says by itself",
                                             brief(100.0 * window.largest_difference(), 2));
  if (!window.can_tell()) {
    return fmt::format("This window cannot tell whether the model holds: {}.", window.own.uncertainty->verdict);
  }
  const std::string doubt =
      v.model.covariance_is_known ? "" : " The file does not say how well its model is known; it was taken for exact.";
  if (window.agreement.agree()) {
    return fmt::format("The model holds: {}, no more than noise explains ({}).{}", difference, figures(window), doubt);
  }
  return fmt::format("The model {}: {}, more than noise explains ({}){}.{}", window.holds() ? "holds" : "does not hold",
                     difference, figures(window), window.holds() ? ", but too little to matter" : "", doubt);
}

std::string as_text(const Validation& v) {
  std::string out =
      fmt::format("{}: the model of {} held against it\n  vehicle    {}\n  density    {}\n  speed      {}\n", v.data,
                  v.model.source, v.vehicle, v.density, v.speed);
  for (const std::string& warning : v.warnings) {
    out += fmt::format("  Note: {}\n", warning);
  }
  for (const ValidatedWindow& window : v.windows) {
    out += fmt::format("\nwindow {}: {}\n  {:<33}{:<20}{}\n", window.window.record.window, extent(window.window.record),
                       "+-: standard deviation", "the model", "by itself");
    for (const Line& line : lines(v, window)) {
      out += fmt::format("  {:<33}{:<20}{}\n", line.label, line.known, line.own);
    }
    out += "  " + verdict(v, window) + "\n";
    for (const std::string& remark : remarks(window.window, window.own)) {
      out += fmt::format("  {}\n", remark);
    }
  }
  return out;
}

fantail::result::Answer answer(const Validation& v) {
  using enum fantail::result::Answer;
  const auto all = [&](auto is_so) { return std::ranges::all_of(v.windows, is_so); };
  const bool told = all([](const ValidatedWindow& w) { return w.can_tell(); });
  const bool good = told && all([](const ValidatedWindow& w) { return w.holds(); });
  return good ? yes : told ? no : undecided;
}

namespace {

std::string sentence_of(const Validation& v) {
  if (v.windows.size() == 1) {
    return verdict(v, v.windows.front());
  }
  std::string all;
  for (const ValidatedWindow& window : v.windows) {
    all += fmt::format("{}{}: {}.", all.empty() ? "" : " ", window.window.record.window, heading(window));
  }
  return all;
}

}  // namespace

std::string as_json(const Validation& v, const fantail::result::Made& made) {
  Json windows = Json::array();
  for (const ValidatedWindow& window : v.windows) {
    windows.push_back(object(v, window));
  }
  Json whole{{"data", v.data},
             {"model", v.model.source},
             {"alpha_m2", rounded(v.model.constants.value(0))},
             {"beta_m", rounded(v.model.constants.value(1))},
             {"model_uncertainty_known", v.model.covariance_is_known},
             {"reference_area_m2", rounded(v.airframe.reference_area_m2)},
             {"inertia_kg_m2", rounded(v.airframe.inertia_kg_m2)},
             {"density", v.density},
             {"speed", v.speed},
             {"remarks", v.warnings},
             {"windows", windows}};
  fantail::result::put_answer(whole, answer(v), sentence_of(v), made);
  return whole.pretty();
}

std::string as_html(const Validation& v) {
  page::Page page;
  page.kind = "Fantail validation report";
  page.title = v.data;
  page.subtitle = printable(
      fmt::format("the model of {}; {}; density {}; speed {}", v.model.source, v.vehicle, v.density, v.speed));
  page.tone = fantail::result::tone(answer(v));
  page.verdict_heading = v.windows.size() == 1                       ? heading(v.windows.front())
                         : answer(v) == fantail::result::Answer::yes ? "The model holds in all windows"
                                                                     : "The model does not hold in all windows";
  page.verdict = sentence_of(v);
  for (const ValidatedWindow& window : v.windows) {
    page.body_html += section_of(v, window);
  }
  if (!v.warnings.empty()) {
    page.body_html += page::section("Remarks", page::list(v.warnings));
  }
  return page::html(page);
}

std::vector<std::string> model_csv_names(const Validation& v) {
  std::vector<std::string> names{"model.csv"};
  for (std::size_t i = 2; i <= v.windows.size(); ++i) {
    names.push_back(fmt::format("model_{}.csv", i));
  }
  return names;
}

void write_validation(const Validation& v, const std::filesystem::path& folder, const fantail::result::Made& made) {
  std::vector<text::NamedFile> files{{"report.html", as_html(v)}, {"validation.json", as_json(v, made)}};
  const std::vector<std::string> names = model_csv_names(v);
  for (std::size_t i = 0; i < v.windows.size(); ++i) {
    const ValidatedWindow& window = v.windows[i];
    files.push_back({names[i], as_csv(window.window.record, held(window).model, held(window).simulation)});
  }
  text::OutputFolder{folder, {v.data, v.model.source}}.write(files, stale_models(folder, names));
}

}  // namespace fantail::identify::result
