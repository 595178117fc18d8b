// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "identify/result/formatting.hpp"
#include "identify/result/joint_outputs.hpp"
#include "identify/result/json_numbers.hpp"
#include "identify/result/outputs.hpp"
#include "identify/result/uncertainty.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::identify::result {
namespace {

using Json = json::Value;
using text::brief;
using text::degrees;
using text::fixed;

const Identification& shared(const JointWindow& window) { return window.window.results.front(); }

std::string together_text(const Constants& c, Eigen::Index which) {
  return value_with_deviation(c.value(which), std::sqrt(c.covariance(which, which)));
}

double correlation(const Constants& c) {
  return c.covariance(0, 1) / std::sqrt(c.covariance(0, 0) * c.covariance(1, 1));
}

std::string error_deg(const Identification& result) {
  return fixed(degrees(result.simulation.mean_abs_angle_error_rad), 3);
}

Json object(const JointWindow& window) {
  const Identification& result = shared(window);
  const Uncertainty& own = *window.own.uncertainty;
  return {{"data", window.data},
          {"window", window.window.record.window},
          {"samples", result.samples},
          {"information_share", rounded(window.information_share)},
          {"disturbance_deg", list(result.model.node_rad, degrees(1.0))},
          {"mean_abs_angle_error_deg", rounded(degrees(result.simulation.mean_abs_angle_error_rad))},
          {"own_alpha_m2", rounded(window.own.model.alpha_m2)},
          {"own_alpha_interval_m2", pair(own.alpha_profile_m2)},
          {"own_beta_m", rounded(window.own.model.beta_m)},
          {"own_beta_interval_m", pair(own.interval[1])},
          {"own_mean_abs_angle_error_deg", rounded(degrees(window.own.simulation.mean_abs_angle_error_rad))},
          {"remarks", remarks(window.window, window.own)}};
}

}  // namespace

bool JointFindings::determines_both() const {
  return is_identifiable(interval_of(together, 0)) && is_identifiable(interval_of(together, 1));
}

double JointFindings::largest_difference() const {
  double largest = 0.0;
  for (const JointWindow& window : windows) {
    const Uncertainty& own = *window.own.uncertainty;
    if (own.alpha_identifiable && own.beta_identifiable) {
      const Eigen::Vector2d away = constants_of(window.own).value - together.value;
      largest = std::max(largest, away.cwiseQuotient(together.value).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

bool JointFindings::are_of_one_rocket() const {
  const bool all_known = std::ranges::all_of(windows, [](const JointWindow& window) {
    return window.own.uncertainty->alpha_identifiable && window.own.uncertainty->beta_identifiable;
  });
  return agreement.agree() || (all_known && largest_difference() < no_matter);
}

std::string name(const JointWindow& window) { return window.data + ", " + window.window.record.window; }

std::string heading_of(const JointFindings& f) {
  if (!f.determines_both()) {
    return "Together these windows do not determine both damping and torque";
  }
  return f.are_of_one_rocket() ? "These windows have one damping and one torque in common"
                               : "These windows disagree about damping and torque";
}

namespace {

std::string difference_sentence(const JointFindings& f) {
  const std::string figures = fmt::format("chi-square {}; of windows of one rocket 95 in 100 stay below {}",
                                          fixed(f.agreement.chi_square, 1), fixed(f.agreement.limit, 1));
  if (f.agreement.agree()) {
    return fmt::format("By themselves the windows differ no more than their noise explains ({}).", figures);
  }
  const std::string more =
      fmt::format("By themselves the windows differ by more than their noise explains ({})", figures);
  return f.are_of_one_rocket()
             ? fmt::format(
                   "{}, but no alpha or beta by more than {} % from the common one. The common intervals do not "
                   "cover that difference.",
                   more, brief(100.0 * f.largest_difference(), 2))
             : more +
                   ": the rocket, the air or a sensor was not the same, or the model lacks something. The common "
                   "intervals do not cover that.";
}

}  // namespace

std::vector<std::string> conclusions(const JointFindings& f) {
  constexpr double nearly_all = 0.9;
  std::vector<std::string> all{difference_sentence(f)};
  if (!f.determines_both()) {
    all.emplace_back("Alpha or beta is not known within a factor of four.");
  }
  for (const JointWindow& window : f.windows) {
    if (window.information_share >= nearly_all) {
      all.push_back(fmt::format("{} % of what is known of alpha and beta is from {}; the others hardly count.",
                                fixed(100.0 * window.information_share, 0), name(window)));
    }
  }
  return all;
}

std::string as_text(const JointFindings& f, std::size_t columns) {
  std::string out = fmt::format("{} windows: one roll model\n  vehicle    {}\n  density    {}\n  speed      {}\n",
                                f.windows.size(), f.vehicle, f.density, f.speed);
  for (const std::string& warning : f.warnings) {
    out += fmt::format("  Note: {}\n", warning);
  }
  std::size_t width = 24;
  for (const JointWindow& window : f.windows) {
    width = std::max(width, name(window).size() + 2);
  }
  text::Table table{{{""}, {"alpha"}, {"beta"}, {"share", 1}, {"mean angle error", 2}}};
  const auto first = [width](const std::string& cell) { return fmt::format("  {:<{}}", cell, width); };
  const auto wide = [](const std::string& cell) { return fmt::format("{:<20}", cell); };
  const auto share = [](const std::string& cell) { return fmt::format("{:<10}", cell); };
  const auto errors = [](const std::string& own, const std::string& common) {
    return fmt::format("{:<12}{}", own, common);
  };
  table.row({first("+-: standard deviation"), wide("alpha / m2"), wide("beta / m"), share("share"),
             "mean angle error / deg"});
  table.row({first("by itself"), wide(""), wide(""), share(""), errors("by itself", "in common")});
  for (const JointWindow& window : f.windows) {
    table.row({first(name(window)), wide(with_deviation(window.own, 0)), wide(with_deviation(window.own, 1)),
               share(fixed(100.0 * window.information_share, 0) + " %"),
               errors(error_deg(window.own), error_deg(shared(window)))});
  }
  table.row({first("in common"), wide(together_text(f.together, 0)), together_text(f.together, 1)});
  table.row(
      {first("  95 %"), wide(interval_text(interval_of(f.together, 0))), interval_text(interval_of(f.together, 1))});
  out += "\n" + table.text(columns);
  out += "  Each window has a disturbance, a first angle and a first rate of its own.\n\n";
  out += "  " + heading_of(f) + ".\n";
  for (const std::string& sentence : conclusions(f)) {
    out += "  " + sentence + "\n";
  }
  for (const JointWindow& window : f.windows) {
    for (const std::string& remark : remarks(window.window, window.own)) {
      out += fmt::format("  {}: {}\n", name(window), remark);
    }
  }
  return out;
}

fantail::result::Answer answer(const JointFindings& f) {
  using enum fantail::result::Answer;
  return f.determines_both() && f.are_of_one_rocket() ? yes : undecided;
}

std::string as_json(const JointFindings& f, const fantail::result::Made& made) {
  const Constants& c = f.together;
  Json windows = Json::array();
  for (const JointWindow& window : f.windows) {
    windows.push_back(object(window));
  }
  std::vector<std::string> said = f.warnings;
  const std::vector<std::string> concluded = conclusions(f);
  said.insert(said.end(), concluded.begin(), concluded.end());
  Json whole{{"shared", Json::array({"alpha", "beta"})},
             {"alpha_m2", rounded(c.value(0))},
             {"beta_m", rounded(c.value(1))},
             {"alpha_sd_m2", rounded(std::sqrt(c.covariance(0, 0)))},
             {"beta_sd_m", rounded(std::sqrt(c.covariance(1, 1)))},
             {"alpha_beta_correlation", rounded(correlation(c))},
             {"degrees_of_freedom", rounded(c.degrees_of_freedom)},
             {"alpha_interval_m2", pair(interval_of(c, 0))},
             {"beta_interval_m", pair(interval_of(c, 1))},
             {"chi_square", rounded(f.agreement.chi_square)},
             {"chi_square_limit", rounded(f.agreement.limit)},
             {"agree", f.agreement.agree()},
             {"verdict", heading_of(f)},
             {"density", f.density},
             {"speed", f.speed},
             {"inertia_kg_m2", rounded(f.airframe.inertia_kg_m2)},
             {"reference_area_m2", rounded(f.airframe.reference_area_m2)},
             {"remarks", said},
             {"windows", windows}};
  fantail::result::put_answer(whole, answer(f), heading_of(f) + ".", made);
  return whole.pretty();
}

std::vector<std::string> model_csv_names(const JointFindings& f) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= f.windows.size(); ++i) {
    names.push_back(fmt::format("model_{}.csv", i));
  }
  return names;
}

void write_joint(const JointFindings& f, const std::filesystem::path& folder, const fantail::result::Made& made) {
  std::vector<text::NamedFile> files{{"report.html", as_html(f)}, {"identification.json", as_json(f, made)}};
  const std::vector<std::string> names = model_csv_names(f);
  std::vector<std::filesystem::path> inputs;
  for (std::size_t i = 0; i < f.windows.size(); ++i) {
    const Identification& result = shared(f.windows[i]);
    files.push_back({names[i], as_csv(f.windows[i].window.record, result.model, result.simulation)});
    inputs.emplace_back(f.windows[i].data);
  }
  text::OutputFolder{folder, inputs}.write(files, stale_models(folder, names));
}

}  // namespace fantail::identify::result
