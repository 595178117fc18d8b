// SPDX-License-Identifier: MIT
#include "identify/result/answer.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "identify/result/parts.hpp"
#include "identify/result/residual.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using text::degrees;
using Json = json::Value;

Json frequency_json(const FrequencyResponse& response) {
  if (!response.obstacle.empty()) {
    return {{"obstacle", response.obstacle}};
  }
  const auto number = [](double si, const output::Unit& unit = u::none) {
    return output::json_of(unit, si, json_digits);
  };
  Json lines = Json::array();
  for (const FrequencyLine& each : response.lines) {
    Json line{{"frequency_hz", number(each.frequency_hz)}, {"coherence", number(each.coherence)}};
    if (each.estimate) {
      line["gain_per_s"] = number(each.estimate->gain_per_s);
      line["gain_reach_per_s"] = number(each.estimate->reach_per_s);
      line["phase_deg"] = number(each.estimate->phase_rad, u::deg);
      line["model_gain_per_s"] = number(each.estimate->model_gain_per_s);
      line["model_phase_deg"] = number(each.estimate->model_phase_rad, u::deg);
    }
    lines.push_back(line);
  }
  return {{"instrument", name(response.instrument)},
          {"segments", response.segments},
          {"segment_s", number(response.segment_s)},
          {"least_coherence", least_coherence},
          {"lines", lines}};
}

/// What a document of one result has below its own name, and one of several in a place of the list.
Blocks for_programs(const Found& f, const std::string& place) {
  output::Figures figures = figures_of(f, place);
  std::erase_if(figures.all, [](const output::Figure& one) { return one.value.index() == 0; });
  const auto data = [&](const std::string& key, Json value) {
    return output::Data{key_in(place, key), std::move(value)};
  };
  std::vector<double> times_s = f.result.model.node_time_s;
  for (double& time_s : times_s) {
    time_s += f.window.record.window_begin_s;
  }
  Blocks all{std::move(figures), data("disturbance_deg", list(f.result.model.node_rad, u::deg)),
             data("node_time_s", list(times_s))};
  if (f.result.uncertainty) {
    const Uncertainty& known = *f.result.uncertainty;
    Json intervals = Json::array();
    for (std::size_t k = 2; k < known.interval.size(); ++k) {
      intervals.push_back(output::json_of(u::deg, known.interval[k], json_digits));
    }
    Json correlation = Json::array();
    for (Eigen::Index i = 0; i < known.correlation.rows(); ++i) {
      const Eigen::VectorXd row = known.correlation.row(i);
      correlation.push_back(list({row.begin(), row.end()}));
    }
    all.emplace_back(data("disturbance_sd_deg",
                          list({known.standard_deviation.begin() + 2, known.standard_deviation.end()}, u::deg)));
    all.emplace_back(data("disturbance_interval_deg", std::move(intervals)));
    all.emplace_back(data("correlation", std::move(correlation)));
  }
  if (f.result.frequency_response) {
    all.emplace_back(data("frequency_response", frequency_json(*f.result.frequency_response)));
  }
  std::vector<std::string> said = f.study.warnings;
  std::ranges::copy(remarks(f.window, f.result), std::back_inserter(said));
  all.emplace_back(output::Sentences{key_in(place, "remarks"), std::move(said)});
  return all;
}

output::Figures at_a_glance(const Found& f) {
  output::Figures figures = output::only(figures_of(f), {"alpha", "beta", "mean_abs_angle_error"});
  if (f.result.uncertainty) {
    figures["alpha"].remark = "95 %: " + shown(figures["alpha"], interval_of(f.result, 0));
    figures["beta"].remark = "95 %: " + shown(figures["beta"], interval_of(f.result, 1));
  }
  const auto [least, most] = std::ranges::minmax(f.result.model.node_rad);
  const std::string low = text::fixed(degrees(least), 1);
  const std::string high = text::fixed(degrees(most), 1);
  figures.all.insert(figures.all.begin() + 2, output::Figure{{.label = "disturbance", .unit = u::deg},
                                                             output::Digits{low == high ? low : low + " to " + high},
                                                             "as a canard angle"});
  figures["mean_abs_angle_error"].remark =
      fmt::format("rate: {} deg/s", text::fixed(degrees(f.result.simulation.mean_abs_rate_error_rad_s), 1));
  return figures;
}

Blocks numbers(const Study& study, const WindowFindings& window, const std::string& said) {
  const bool several = window.results.size() > 1;
  std::vector<std::pair<std::string, output::Figures>> methods;
  Blocks all{extent(window.record) + "."};
  if (const std::string lag = lag_sentence(window); !lag.empty()) {
    all.emplace_back(lag);
  }
  for (const Identification& result : window.results) {
    methods.emplace_back(
        fmt::format("{}, {} loop", name(result.method), name(result.loop)),
        output::only(figures_of({study, window, result}),
                     {"alpha", "alpha_interval", "beta", "beta_interval", "servo_lag", "servo_lag_interval",
                      "servo_play", "servo_play_interval", "mean_abs_angle_error", "mean_abs_rate_error",
                      "residual_own_correlation", "residual_correlation_by_chance", "residual_canard_correlation",
                      "residual_canard_correlation_by_chance", "effective_samples", "samples"}));
    const std::string verdict = result.uncertainty ? sentence(result.uncertainty->verdict) : "";
    const bool told_above = !several && study.windows.size() == 1 && determines_both(window);
    if (verdict != said && !verdict.empty() && !told_above && !result.on_grid_edge) {
      all.emplace_back(several ? fmt::format("{}: {}", name(result.method), verdict) : verdict);
    }
  }
  all.emplace_back(output::beside(methods));
  all.emplace_back(node_table(window));
  all.emplace_back("\u00b1: standard deviation. The disturbance is given as an equivalent canard angle.");
  return all;
}

output::Section frequency(const FrequencyResponse& response) {
  output::Section section{"Frequency response", {frequency_sentence(response)}};
  if (!response.lines.empty()) {
    section.blocks.emplace_back(instrument_sentence(response));
    section.blocks.emplace_back(fmt::format(
        "Welch's method: {} segments of {} s that overlap by half, Hann's window. Nothing is drawn where the "
        "coherence is below {}. The model's curve is computed in the same way from the modelled roll rate, so a "
        "changing speed affects both alike.",
        response.segments, text::brief(response.segment_s, 2), text::fixed(least_coherence, 1)));
    add_frequency(section.blocks, response);
  }
  return section;
}

std::vector<std::string> remark_list(const WindowFindings& window) {
  std::vector<std::string> all = window.remarks;
  for (const Identification& result : window.results) {
    for (const std::string& remark : result.remarks) {
      all.push_back(window.results.size() > 1 ? fmt::format("{}: {}", name(result.method), remark) : remark);
    }
  }
  return all;
}

void add_window(output::Document& document, const Study& study, const WindowFindings& window) {
  const Identification& main = main_result(window);
  const bool several = study.windows.size() > 1;
  const std::string of = several ? " of window " + window.record.window : "";
  using enum output::Readers;
  std::vector<output::Section>& sections = document.sections;
  sections.push_back(
      {several ? "Window " + window.record.window : "The roll model", {at_a_glance({study, window, main})}, files});
  sections.push_back({"The numbers" + of, numbers(study, window, several ? "" : document.verdict.sentence)});
  if (main.uncertainty) {
    sections.push_back(
        {"How well each number is known",
         {"If the model is right and the residual is typical, each range contains the true value in 95 of 100 cases.",
          output::Sentences{.all = precision_sentences(main)}},
         files});
  }
  sections.push_back({"Measured and modelled", {}, files});
  add_motion(sections.back().blocks, window);
  sections.push_back(
      {"Residuals",
       {"Measured minus modelled. A good model leaves only noise. Slow waves mean that the disturbance needs "
        "more nodes; spikes at each canard motion mean a lag."},
       files});
  add_residuals(sections.back().blocks, window);
  sections.push_back({"Disturbance and canards", input_pictures(window), files});
  if (main.frequency_response) {
    sections.push_back(frequency(*main.frequency_response));
  }
  if (main.error_map) {
    sections.push_back({"The error over alpha and beta", {error_map_drawing(window, *main.error_map)}, files});
  }
  sections.push_back({"Remarks" + of, {output::Sentences{.all = remark_list(window)}}});
}

/// Of each result: how many nodes, and what programs read.
void add_results(output::Document& document, const Study& study) {
  std::vector<Found> found;
  for (const WindowFindings& window : study.windows) {
    for (const Identification& result : window.results) {
      found.push_back({study, window, result});
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Found& f = found[i];
    const std::string place = found.size() == 1 ? "" : fmt::format("results.{}", i);
    document.sections.push_back({"For programs", for_programs(f, place), output::Readers::programs});
    document.spreadsheets.push_back(
        model_table(found.size() == 1 ? "model" : fmt::format("model_{}", i + 1), f.window.record, f.result));
    if (!f.result.node_trials.empty()) {
      document.sections.push_back({fmt::format("How many nodes ({})", name(f.result.method)),
                                   {"More intervals always fit better. The smallest number is chosen whose error is "
                                    "within 10 % or 0.01 deg of the least error.",
                                    trial_table(key_in(place, "node_curve"), f.result), node_picture(f.result)}});
    }
  }
}

output::Verdict verdict_of(const WindowFindings& window) {
  using enum output::Answer;
  const Identification& result = main_result(window);
  const std::string said = result.uncertainty ? sentence(result.uncertainty->verdict) : "";
  if (!determines_both(window)) {
    return {.answer = undecided, .heading = "This window does not determine both damping and torque", .sentence = said};
  }
  if (result.on_grid_edge) {
    return {.answer = undecided,
            .heading = "The best grid point is on the edge of the grid",
            .sentence =
                "A better point may lie outside it. Search a larger grid (--grid-alpha, --grid-beta), or use "
                "--method continuous."};
  }
  if (const auto doubt = misfit(window.record, result)) {
    return {.answer = undecided,
            .heading = "Damping and torque are found, but the model does not fit well",
            .sentence = *doubt};
  }
  const std::string edge = std::ranges::any_of(window.results, &Identification::on_grid_edge)
                               ? " The best grid point is on the edge of the grid, so only these continuous values "
                                 "count."
                               : "";
  return {.answer = yes,
          .heading = "This window determines damping and torque",
          .sentence = fmt::format("Alpha is {} m2, beta {} m (\u00b1: standard deviation).{}",
                                  with_deviation(result, 0), with_deviation(result, 1), edge)};
}

output::Verdict verdict_of(const Study& study) {
  using enum output::Answer;
  if (study.windows.size() == 1) {
    return verdict_of(study.windows.front());
  }
  const auto good = std::ranges::count_if(study.windows, determines_both);
  const auto doubtful = std::ranges::count_if(study.windows, [](const WindowFindings& window) {
    return misfit(window.record, main_result(window)).has_value();
  });
  const auto on_edge =
      std::ranges::count_if(study.windows, [](const WindowFindings& w) { return main_result(w).on_grid_edge; });
  const auto all = std::ssize(study.windows);
  output::Verdict verdict{.answer = good == all && doubtful == 0 && on_edge == 0 ? yes : undecided,
                          .heading = fmt::format("{} of {} windows {} damping and torque", good, all,
                                                 good == 1 ? "determines" : "determine"),
                          .sentence = ""};
  for (const WindowFindings& window : study.windows) {
    const model::RollModel& model = main_result(window).model;
    verdict.sentence += fmt::format("{}{}: alpha {}, beta {}.", verdict.sentence.empty() ? "" : " ",
                                    window.record.window, constant_text(model.alpha_m2), constant_text(model.beta_m));
  }
  if (doubtful > 0) {
    verdict.sentence += fmt::format(" In {} of them the model does not fit the log well; see the remarks.", doubtful);
  }
  if (on_edge > 0) {
    verdict.sentence += fmt::format(" In {} of them the best grid point is on the edge of the grid.", on_edge);
  }
  return verdict;
}

}  // namespace

std::vector<output::Listed> listed_fields() {
  std::vector<output::Listed> all = listed_found();
  for (const auto& more : {listed_joint(), listed_validation()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

output::Document answer(const Study& study, const output::Made& made) {
  output::Document document{.kind = "identification report",
                            .title = study.data,
                            .subtitle = study.vehicle,
                            .verdict = verdict_of(study),
                            .facts = {{"", "density", study.density}, {"", "speed", study.speed}},
                            .made = made,
                            .json_decimals = json_digits};
  for (const WindowFindings& window : study.windows) {
    add_window(document, study, window);
  }
  document.sections.push_back({"Remarks on the log", {output::Sentences{.all = study.warnings}}});
  add_results(document, study);
  return document;
}

}  // namespace fantail::identify::result
