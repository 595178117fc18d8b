// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "identify/result/formatting.hpp"
#include "identify/result/frequency_page.hpp"
#include "identify/result/json_numbers.hpp"
#include "identify/result/outputs.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/input_file.hpp"
#include "text/output_folder.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using Json = json::Value;
using text::degrees;

constexpr std::string_view csv_header =
    "time_s,roll_angle_deg,model_roll_angle_deg,roll_rate_deg_s,model_roll_rate_deg_s,canard_deg,disturbance_deg";

std::vector<double> on_clock(const Record& record, std::vector<double> time_s) {
  for (double& each : time_s) {
    each += record.window_begin_s;
  }
  return time_s;
}

void add_uncertainty(Json& json, const Uncertainty& u) {
  const double degree = degrees(1.0);
  json["alpha_sd_m2"] = rounded(u.standard_deviation[0]);
  json["beta_sd_m"] = rounded(u.standard_deviation[1]);
  json["disturbance_sd_deg"] = list({u.standard_deviation.begin() + 2, u.standard_deviation.end()}, degree);
  json["alpha_interval_m2"] = pair(u.alpha_profile_m2);
  json["beta_interval_m"] = pair(u.interval[1]);
  json["disturbance_interval_deg"] = Json::array();
  for (std::size_t k = 2; k < u.interval.size(); ++k) {
    json["disturbance_interval_deg"].push_back(pair(u.interval[k], degree));
  }
  json["correlation"] = Json::array();
  for (Eigen::Index i = 0; i < u.correlation.rows(); ++i) {
    const Eigen::VectorXd row = u.correlation.row(i);
    json["correlation"].push_back(list({row.begin(), row.end()}));
  }
  json["effective_samples"] = rounded(u.effective_samples);
  json["degrees_of_freedom"] = rounded(u.degrees_of_freedom);
  json["alpha_identifiable"] = u.alpha_identifiable;
  json["beta_identifiable"] = u.beta_identifiable;
  json["verdict"] = u.verdict;
}

Json frequency_json(const FrequencyResponse& response) {
  if (!response.obstacle.empty()) {
    return Json{{"obstacle", response.obstacle}};
  }
  Json lines = Json::array();
  for (const FrequencyLine& each : response.lines) {
    Json line{{"frequency_hz", rounded(each.frequency_hz)}, {"coherence", rounded(each.coherence)}};
    if (each.estimate) {
      line["gain_per_s"] = rounded(each.estimate->gain_per_s);
      line["gain_reach_per_s"] = rounded(each.estimate->reach_per_s);
      line["phase_deg"] = rounded(degrees(each.estimate->phase_rad));
      line["model_gain_per_s"] = rounded(each.estimate->model_gain_per_s);
      line["model_phase_deg"] = rounded(degrees(each.estimate->model_phase_rad));
    }
    lines.push_back(line);
  }
  return Json{{"instrument", name(response.instrument)},
              {"segments", response.segments},
              {"segment_s", rounded(response.segment_s)},
              {"least_coherence", least_coherence},
              {"lines", lines}};
}

void add_servo(Json& json, const Servo& servo, const Uncertainty& known) {
  json["servo_lag_s"] = rounded(servo.lag_s);
  json["servo_play_deg"] = rounded(degrees(servo.play_rad));
  if (known.lag_s) {
    json["servo_lag_sd_s"] = rounded(known.lag_s->standard_deviation);
    json["servo_lag_interval_s"] =
        pair({.low = std::max(0.0, servo.lag_s - known.lag_s->reach), .high = servo.lag_s + known.lag_s->reach});
  }
  if (known.play_rad) {
    json["servo_play_sd_deg"] = rounded(degrees(known.play_rad->standard_deviation));
    json["servo_play_interval_deg"] = pair({.low = degrees(std::max(0.0, servo.play_rad - known.play_rad->reach)),
                                            .high = degrees(servo.play_rad + known.play_rad->reach)});
  }
}

Json object(const Study& study, const WindowFindings& window, const Identification& result) {
  Json json{{"data", study.data},
            {"window", window.record.window},
            {"window_begin_s", rounded(window.record.window_begin_s)},
            {"method", name(result.method)},
            {"loop", name(result.loop)},
            {"loss", result.robust ? "huber" : "squares"},
            {"samples", result.samples},
            {"seconds", rounded(result.seconds)},
            {"alpha_m2", rounded(result.model.alpha_m2)},
            {"beta_m", rounded(result.model.beta_m)},
            {"disturbance_deg", list(result.model.node_rad, degrees(1.0))},
            {"node_time_s", list(on_clock(window.record, result.model.node_time_s))},
            {"mean_abs_angle_error_deg", rounded(degrees(result.simulation.mean_abs_angle_error_rad))},
            {"mean_abs_rate_error_deg_s", rounded(degrees(result.simulation.mean_abs_rate_error_rad_s))}};
  if (result.robust) {
    json["huber_threshold_deg"] = rounded(degrees(result.robust->threshold_rad));
    json["huber_samples_beyond"] = result.robust->beyond;
  }
  if (result.uncertainty) {
    add_uncertainty(json, *result.uncertainty);
  }
  json["lag_s"] = rounded(window.lag_s);
  json["lag_fitted"] = window.lag_is_fitted;
  if (result.servo) {
    add_servo(json, *result.servo, result.uncertainty ? *result.uncertainty : Uncertainty{});
  } else if (result.uncertainty && result.uncertainty->lag_s) {
    const Spread& spread = *result.uncertainty->lag_s;
    json["lag_sd_s"] = rounded(spread.standard_deviation);
    json["lag_interval_s"] = pair({.low = window.lag_s - spread.reach, .high = window.lag_s + spread.reach});
  }
  if (const auto& tests = result.residual_tests) {
    json["residual_own_correlation"] = rounded(tests->own_correlation);
    json["residual_canard_correlation"] = rounded(tests->canard_correlation);
    json["residual_correlation_by_chance"] = rounded(tests->chance);
    json["residual_canard_correlation_by_chance"] = rounded(tests->canard_chance);
  }
  if (result.frequency_response) {
    json["frequency_response"] = frequency_json(*result.frequency_response);
  }
  json["density"] = study.density;
  json["speed"] = study.speed;
  json["inertia_kg_m2"] = rounded(mean_inertia_kg_m2(window.record, study.airframe));
  json["reference_area_m2"] = rounded(study.airframe.reference_area_m2);
  std::vector<std::string> said = study.warnings;
  const std::vector<std::string> more = remarks(window, result);
  said.insert(said.end(), more.begin(), more.end());
  json["remarks"] = said;
  if (!result.node_trials.empty()) {
    json["node_curve"] = Json::array();
    for (const NodeTrial& trial : result.node_trials) {
      json["node_curve"].push_back({{"intervals", trial.intervals},
                                    {"mean_abs_angle_error_deg", rounded(degrees(trial.mean_abs_angle_error_rad))},
                                    {"alpha_m2", rounded(trial.model.alpha_m2)},
                                    {"beta_m", rounded(trial.model.beta_m)}});
    }
  }
  return json;
}

}  // namespace

std::string as_json(const Study& study, const fantail::result::Made& made) {
  Json all = Json::array();
  for (const WindowFindings& window : study.windows) {
    for (const Identification& result : window.results) {
      all.push_back(object(study, window, result));
    }
  }
  Json whole = all.size() == 1 ? all[0] : Json{{"results", all}};
  const fantail::result::Verdict said = verdict_of(study);
  fantail::result::put_answer(whole, said.answer, said.sentence, made);
  return whole.pretty();
}

std::string as_csv(const Record& record, const RollModel& model, const Simulation& simulation) {
  fmt::memory_buffer out;
  out.reserve((record.size() + 2) * 90);
  fmt::format_to(std::back_inserter(out), "{}\n", csv_header);
  const auto cell = [&](double value, char behind) {
    fmt::format_to(std::back_inserter(out), "{:.6f}{}", std::abs(value) < 0.5e-6 ? 0.0 : value, behind);
  };
  for (std::size_t i = 0; i < record.size(); ++i) {
    cell(record.window_begin_s + record.time_s[i], ',');
    cell(degrees(record.roll_angle_rad[i]), ',');
    cell(degrees(simulation.roll_angle_rad[i]), ',');
    cell(degrees(record.roll_rate_rad_s[i]), ',');
    cell(degrees(simulation.roll_rate_rad_s[i]), ',');
    cell(degrees(simulation.canard_rad[i]), ',');
    cell(degrees(model.disturbance_rad(record.time_s[i])), '\n');
  }
  return fmt::to_string(out);
}

std::vector<std::string> model_csv_names(const Study& study) {
  std::vector<std::string> names;
  for (const WindowFindings& window : study.windows) {
    for (std::size_t k = 0; k < window.results.size(); ++k) {
      names.push_back(fmt::format("model_{}.csv", names.size() + 1));
    }
  }
  return names.size() == 1 ? std::vector<std::string>{"model.csv"} : names;
}

std::vector<std::string> stale_models(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  const auto is_ours = [&folder](const std::string& name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder / name, ignored) &&
           text::read_input(folder / name).starts_with(std::string{csv_header} + '\n');
  };
  std::vector<std::string> stale{"model.csv"};
  for (std::size_t i = 1; i < 3 || is_ours(stale.back()); ++i) {
    stale.push_back(fmt::format("model_{}.csv", i));
  }
  std::erase_if(
      stale, [&](const std::string& name) { return std::ranges::find(names, name) != names.end() || !is_ours(name); });
  return stale;
}

void write_study(const Study& study, const std::filesystem::path& folder, const fantail::result::Made& made) {
  std::vector<text::NamedFile> files{{"report.html", as_html(study)}, {"identification.json", as_json(study, made)}};
  const std::vector<std::string> names = model_csv_names(study);
  std::size_t next = 0;
  for (const WindowFindings& window : study.windows) {
    for (const Identification& result : window.results) {
      files.push_back({names[next++], as_csv(window.record, result.model, result.simulation)});
    }
  }
  text::OutputFolder{folder, {study.data}}.write(files, stale_models(folder, names));
}

}  // namespace fantail::identify::result
