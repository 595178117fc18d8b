// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/core.h>

#include "identify/result/charts.hpp"
#include "identify/result/formatting.hpp"
#include "identify/result/frequency_page.hpp"
#include "identify/result/outputs.hpp"
#include "identify/result/residual.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using text::degrees;

std::string figures(const WindowFindings& window) {
  const Identification& result = main_result(window);
  const auto range = [&](std::size_t number) {
    return result.uncertainty ? "95 %: " + interval_text(interval_of(result, number)) : std::string{};
  };
  const std::vector<double>& nodes = result.model.node_rad;
  const auto [low, high] = std::ranges::minmax(nodes);
  const std::string least = text::fixed(degrees(low), 1);
  const std::string most = text::fixed(degrees(high), 1);
  return page::figure_row(std::vector<page::Figure>{
      {"damping alpha", constant_text(result.model.alpha_m2), "m\u00b2", range(0)},
      {"torque constant beta", constant_text(result.model.beta_m), "m", range(1)},
      {"disturbance", least == most ? least : least + " to " + most, "deg", "as an equivalent canard angle"},
      {"mean angle error", text::fixed(degrees(result.simulation.mean_abs_angle_error_rad), 2), "deg",
       fmt::format("rate: {} deg/s", text::fixed(degrees(result.simulation.mean_abs_rate_error_rad_s), 1))}});
}

std::string numbers_table(const WindowFindings& window) {
  const bool any_known = std::ranges::any_of(window.results, [](const auto& r) { return r.uncertainty.has_value(); });
  std::vector<page::Column> columns{{any_known ? "\u00b1: standard deviation" : "", false}};
  std::size_t nodes = 0;
  for (const Identification& result : window.results) {
    const std::string who = fmt::format("{}, {} loop", name(result.method), name(result.loop));
    columns.push_back({who, true});
    columns.push_back({"95 %", true});
    nodes = std::max(nodes, result.model.node_rad.size());
  }
  std::vector<std::vector<page::Cell>> rows;
  for (std::size_t k = 0; k < nodes + 2; ++k) {
    std::vector<page::Cell> row{{k == 0   ? "damping alpha / m\u00b2"
                                 : k == 1 ? "torque constant beta / m"
                                          : "disturbance / deg, " + node_label(window, k - 2)}};
    for (const Identification& result : window.results) {
      const bool known = k < result.model.node_rad.size() + 2 && result.uncertainty;
      row.push_back({printable(k < 2 ? with_deviation(result, k) : node_value(window, result, k - 2))});
      row.push_back({known ? interval_text(interval_of(result, k), k < 2 ? 1.0 : degrees(1.0)) : ""});
    }
    rows.push_back(std::move(row));
  }
  if (std::ranges::any_of(window.results, [](const Identification& r) { return r.servo.has_value(); })) {
    std::vector<page::Cell> lag{{"servo lag / ms, fitted"}};
    std::vector<page::Cell> play{{"servo play / deg, fitted"}};
    for (const Identification& r : window.results) {
      const Uncertainty& known = r.uncertainty ? *r.uncertainty : Uncertainty{};
      const Servo servo = r.servo.value_or(Servo{.lag_s = 0.0, .play_rad = 0.0});
      lag.insert(lag.end(), {{printable(servo_lag_text(r))}, {servo_interval(servo.lag_s, known.lag_s, 1000.0)}});
      play.insert(play.end(),
                  {{printable(servo_play_text(r))}, {servo_interval(servo.play_rad, known.play_rad, degrees(1.0))}});
    }
    rows.push_back(std::move(lag));
    rows.push_back(std::move(play));
  }
  std::vector<page::Cell> angle{{"mean angle error / deg"}};
  std::vector<page::Cell> rate{{"mean rate error / deg/s"}};
  std::vector<page::Cell> own{{"rate residual, correlation with itself"}};
  std::vector<page::Cell> canards{{"rate residual, correlation with the canards"}};
  std::vector<page::Cell> worth{{"effective samples"}};
  for (const Identification& result : window.results) {
    own.insert(own.end(), {{residual_text(result, &ResidualTests::own_correlation)}, {""}});
    canards.insert(canards.end(), {{residual_text(result, &ResidualTests::canard_correlation)}, {""}});
    worth.insert(worth.end(), {{effective_text(result)}, {""}});
    angle.insert(angle.end(), {{text::fixed(degrees(result.simulation.mean_abs_angle_error_rad), 3)}, {""}});
    rate.insert(rate.end(), {{text::fixed(degrees(result.simulation.mean_abs_rate_error_rad_s), 2)}, {""}});
  }
  rows.push_back(std::move(angle));
  rows.push_back(std::move(rate));
  rows.push_back(std::move(own));
  rows.push_back(std::move(canards));
  rows.push_back(std::move(worth));
  return page::table(columns, rows);
}

std::string precision_section(const WindowFindings& window) {
  const Identification& result = main_result(window);
  if (!result.uncertainty) {
    return "";
  }
  return page::section(
      "How well each number is known",
      page::paragraph("If the model is right and the residual is typical, such a range contains the true value in "
                      "95 of 100 cases.") +
          page::list(precision_sentences(result)));
}

std::string chart_sections(const WindowFindings& window) {
  std::string motion = page::figure(motion_chart(window, Motion::angle));
  motion += page::figure(motion_chart(window, Motion::rate));
  const std::vector<std::string> left_over{page::figure(residual_chart(window, Motion::angle)),
                                           page::figure(residual_chart(window, Motion::rate))};
  std::string out = page::section("Measured and modelled", motion);
  out += page::section("Residuals",
                       page::paragraph("Measured minus modelled. A good model leaves only noise. Slow waves mean that "
                                       "the disturbance needs more nodes; spikes at each canard motion mean a lag.") +
                           page::side_by_side(left_over));
  std::vector<std::string> inputs{
      page::figure(page::svg(disturbance_chart(window)),
                   "The disturbance as an equivalent canard angle; the band is its 95 % interval.")};
  const page::Chart canards = canard_chart(window);
  if (!canards.series.empty()) {
    inputs.push_back(page::figure(canards, "The mean canard angle."));
  }
  return out + page::section("Disturbance and canards", page::side_by_side(inputs));
}

std::string search_sections(const WindowFindings& window) {
  std::string out;
  const auto mapped =
      std::ranges::find_if(window.results, [](const Identification& r) { return r.error_map.has_value(); });
  if (mapped != window.results.end()) {
    const page::HeatMap map = error_map_chart(window, *mapped->error_map);
    page::HeatMap narrow = map;
    narrow.width = page::half_page;
    narrow.height = 300.0;
    out += page::section(
        "The error over alpha and beta",
        page::figure(page::svg(map), page::svg(narrow),
                     "Each cell shows the mean angle error with the disturbance that fits best. A long dark valley "
                     "means that many pairs of alpha and beta fit the log almost equally well."));
  }
  for (const Identification& result : window.results) {
    if (!result.node_trials.empty()) {
      out += page::section(fmt::format("How many nodes ({})", name(result.method)),
                           page::paragraph("More intervals always fit better. The fewest are chosen whose error is "
                                           "within 10 % or 0.01 deg of the least error.") +
                               page::figure(node_curve_chart(result)));
    }
  }
  return out;
}

std::string remark_list(const Study& study, const WindowFindings& window) {
  std::vector<std::string> all = study.warnings;
  all.insert(all.end(), window.remarks.begin(), window.remarks.end());
  for (const Identification& result : window.results) {
    for (const std::string& remark : result.remarks) {
      all.push_back(window.results.size() > 1 ? fmt::format("{}: {}", name(result.method), remark) : remark);
    }
  }
  if (window.lag_is_fitted || window.lag_s != 0.0) {
    all.push_back(fmt::format("Canard angles are used {} ms {} than they are logged{}.",
                              text::brief(1000.0 * std::abs(window.lag_s), 1), window.lag_s < 0.0 ? "earlier" : "later",
                              fitted_lag(window)));
  }
  return all.empty() ? "" : page::section("Remarks", page::list(all));
}

std::string window_section(const Study& study, const WindowFindings& window) {
  std::string out = figures(window) + numbers_table(window);
  if (study.windows.size() > 1) {
    const Identification& result = main_result(window);
    out = page::section("Window " + window.record.window,
                        page::paragraph(extent(window.record)) +
                            (result.uncertainty ? page::paragraph(sentence(result.uncertainty->verdict)) : "") + out);
  } else {
    out = page::section("The roll model", out);
  }
  const auto& response = main_result(window).frequency_response;
  return out + precision_section(window) + chart_sections(window) + (response ? frequency_section(*response) : "") +
         search_sections(window) + remark_list(study, window);
}

fantail::result::Verdict verdict_of(const WindowFindings& window) {
  using enum fantail::result::Answer;
  const Identification& result = main_result(window);
  const std::string said = result.uncertainty ? sentence(result.uncertainty->verdict) : "";
  if (!determines_both(window)) {
    return {.answer = undecided, .heading = "This window does not determine both damping and torque", .sentence = said};
  }
  if (const auto doubt = misfit(window.record, result)) {
    return {.answer = undecided, .heading = "Damping and torque, but the model does not fit well", .sentence = *doubt};
  }
  return {.answer = yes, .heading = "This window determines damping and torque", .sentence = said};
}

}  // namespace

fantail::result::Verdict verdict_of(const Study& study) {
  using enum fantail::result::Answer;
  if (study.windows.size() == 1) {
    return verdict_of(study.windows.front());
  }
  const auto good = std::ranges::count_if(study.windows, determines_both);
  const auto doubtful = std::ranges::count_if(study.windows, [](const WindowFindings& window) {
    return misfit(window.record, main_result(window)).has_value();
  });
  const auto all = std::ssize(study.windows);
  fantail::result::Verdict verdict{.answer = good == all && doubtful == 0 ? yes : undecided,
                                   .heading = fmt::format("{} of {} windows determine damping and torque", good, all),
                                   .sentence = ""};
  for (const WindowFindings& window : study.windows) {
    const RollModel& model = main_result(window).model;
    verdict.sentence += fmt::format("{}{}: alpha {}, beta {}.", verdict.sentence.empty() ? "" : " ",
                                    window.record.window, constant_text(model.alpha_m2), constant_text(model.beta_m));
  }
  if (doubtful > 0) {
    verdict.sentence += fmt::format(" In {} of them the model does not fit the log well; see the remarks.", doubtful);
  }
  return verdict;
}

std::string as_html(const Study& study) {
  page::Page page;
  page.kind = "Fantail identification report";
  page.title = study.data;
  page.subtitle = printable(fmt::format("{}; density {}; speed {}", study.vehicle, study.density, study.speed));
  if (study.windows.size() == 1) {
    const WindowFindings& window = study.windows.front();
    page.subtitle += fmt::format("; window {}, {}", window.record.window, extent(window.record));
  }
  const fantail::result::Verdict verdict = verdict_of(study);
  page.tone = fantail::result::tone(verdict);
  page.verdict_heading = verdict.heading;
  page.verdict = verdict.sentence;
  for (const WindowFindings& window : study.windows) {
    page.body_html += window_section(study, window);
  }
  return page::html(page);
}

}  // namespace fantail::identify::result
