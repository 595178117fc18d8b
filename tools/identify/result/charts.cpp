// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include <fmt/core.h>

#include "identify/result/parts.hpp"
#include "identify/result/words.hpp"
#include "page/heat_map.hpp"
#include "text/degrees.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using fantail::result::Picture;
using page::Chart;
using page::Role;
using page::Series;
using text::degrees;

Role role(std::size_t method) { return method == 0 ? Role::model : Role::second_model; }

std::string model_name(const WindowFindings& window, const Identification& result) {
  return window.results.size() == 1 ? "model" : fmt::format("model, {}", name(result.method));
}

// A curve over the samples of a record, interrupted at its gaps.
Series curve(const Record& record, std::string name, Role role, const std::vector<double>& radians) {
  Series series{.name = std::move(name), .role = role};
  std::size_t next_segment = 1;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double t = record.window_begin_s + record.time_s[i];
    if (next_segment < record.segment_begin.size() && record.segment_begin[next_segment] == i) {
      series.x.push_back(0.5 * (series.x.back() + t));
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
      ++next_segment;
    }
    series.x.push_back(t);
    series.y.push_back(degrees(radians[i]));
  }
  return series;
}

Chart over_time(const std::string& label, const std::string& y_label) {
  Chart chart;
  chart.label = label;
  chart.x_label = "time / s";
  chart.y_label = y_label;
  return chart;
}

enum class Motion : std::uint8_t { angle, rate };

struct Signal {
  const char* name;
  const char* unit;
  std::vector<double> Record::* measured;
  std::vector<double> Simulation::* modelled;
};

Signal signal(Motion motion) {
  return motion == Motion::angle ? Signal{"angle", "deg", &Record::roll_angle_rad, &Simulation::roll_angle_rad}
                                 : Signal{"rate", "deg/s", &Record::roll_rate_rad_s, &Simulation::roll_rate_rad_s};
}

struct Estimate {
  double value_rad;
  double deviation_rad;
};

Estimate disturbance_at(const Identification& result, double time_s) {
  const double value = result.model.disturbance_rad(time_s);
  if (!result.uncertainty) {
    return {value, 0.0};
  }
  const NodeShare share = node_share(result.model.node_time_s, time_s);
  const double left = 1.0 - share.right_share;
  const double right = share.right_share;
  const Uncertainty& u = *result.uncertainty;
  const double a = left * u.standard_deviation[share.left + 2];
  const double b = right * u.standard_deviation[share.right + 2];
  const double together =
      u.correlation(static_cast<Eigen::Index>(share.left) + 2, static_cast<Eigen::Index>(share.right) + 2);
  return {value, std::sqrt(std::fmax(0.0, a * a + b * b + 2.0 * together * a * b))};
}

Chart motion_chart(const WindowFindings& window, Motion motion) {
  const auto [name, unit, measured, modelled] = signal(motion);
  Chart chart = over_time(fmt::format("roll {}, measured and modelled", name), fmt::format("roll {} / {}", name, unit));
  chart.series.push_back(curve(window.record, "measured", Role::measured, window.record.*measured));
  for (std::size_t k = 0; k < window.results.size(); ++k) {
    const Identification& result = window.results[k];
    chart.series.push_back(curve(window.record, model_name(window, result), role(k), result.simulation.*modelled));
  }
  return chart;
}

Chart residual_chart(const WindowFindings& window, Motion motion) {
  const auto [name, unit, measured, modelled] = signal(motion);
  Chart chart = over_time(fmt::format("residual of the roll {}", name), fmt::format("{} residual / {}", name, unit));
  chart.width = page::half_page;
  for (std::size_t k = 0; k < window.results.size(); ++k) {
    const Identification& result = window.results[k];
    std::vector<double> difference = window.record.*measured;
    std::ranges::transform(difference, result.simulation.*modelled, difference.begin(), std::minus{});
    chart.series.push_back(curve(window.record, model_name(window, result), role(k), difference));
  }
  chart.levels.push_back({.value = 0.0});
  return chart;
}

Chart canard_chart(const WindowFindings& window) {
  Chart chart = over_time("canard angle", "canard angle / deg");
  chart.width = page::half_page;
  if (!window.record.canard_rad.empty()) {
    chart.series.push_back(curve(window.record, "measured", Role::measured, window.record.canard_rad));
  }
  for (std::size_t k = 0; k < window.results.size(); ++k) {
    const Identification& result = window.results[k];
    if (result.loop == Loop::closed) {
      chart.series.push_back(curve(window.record, model_name(window, result), role(k), result.simulation.canard_rad));
    }
  }
  return chart;
}

Chart disturbance_chart(const WindowFindings& window) {
  constexpr int points = 200;
  constexpr double normal_975 = 1.96;
  Chart chart = over_time("disturbance, as an equivalent canard angle", "disturbance / deg");
  chart.width = page::half_page;
  const double length_s = window.record.time_s.back();
  for (std::size_t k = 0; k < window.results.size(); ++k) {
    const Identification& result = window.results[k];
    Series line{.name = model_name(window, result), .role = role(k)};
    page::Area band{.name = "95 % interval", .role = role(k)};
    for (int i = 0; i <= points; ++i) {
      const double t = length_s * i / points;
      const Estimate there = disturbance_at(result, t);
      const double reach = normal_975 * there.deviation_rad;
      line.x.push_back(window.record.window_begin_s + t);
      line.y.push_back(degrees(there.value_rad));
      band.x.push_back(line.x.back());
      band.low.push_back(degrees(there.value_rad - reach));
      band.high.push_back(degrees(there.value_rad + reach));
    }
    if (result.uncertainty) {
      chart.areas.push_back(std::move(band));
    }
    chart.series.push_back(std::move(line));
  }
  return chart;
}

}  // namespace

void add_motion(Blocks& to, const WindowFindings& window) {
  to.emplace_back(Picture{motion_chart(window, Motion::angle)});
  to.emplace_back(Picture{motion_chart(window, Motion::rate)});
}

void add_residuals(Blocks& to, const WindowFindings& window) {
  to.emplace_back(Picture{residual_chart(window, Motion::angle)});
  to.emplace_back(Picture{residual_chart(window, Motion::rate)});
}

Blocks input_pictures(const WindowFindings& window) {
  Blocks all{
      Picture{disturbance_chart(window), "The disturbance as an equivalent canard angle, with its 95 % interval."}};
  if (const Chart canards = canard_chart(window); !canards.series.empty()) {
    all.emplace_back(Picture{canards, "The mean canard angle."});
  }
  return all;
}

Picture node_picture(const Identification& result) {
  Chart chart;
  chart.label = "mean angle error over the number of intervals of the disturbance";
  chart.x_label = "intervals of the disturbance";
  chart.y_label = "mean angle error / deg";
  chart.width = page::half_page;
  chart.equal_x_ticks_at_points = true;
  Series curve{.name = "mean angle error", .role = Role::model, .mark = page::Mark::line_and_points};
  double most = 0.0;
  for (const NodeTrial& trial : result.node_trials) {
    curve.x.push_back(static_cast<double>(trial.intervals));
    curve.y.push_back(degrees(trial.mean_abs_angle_error_rad));
    most = std::fmax(most, curve.y.back());
  }
  chart.series.push_back(std::move(curve));
  chart.levels.push_back(
      {.value = static_cast<double>(result.model.node_rad.size() - 1), .label = "chosen", .upright = true});
  chart.y_range = page::Range{0.0, 1.1 * most};
  return {chart};
}

fantail::result::Drawing error_map_drawing(const WindowFindings& window, const ErrorMap& errors) {
  page::HeatMap map;
  map.label = "mean angle error over alpha and beta";
  map.x_label = "alpha / m\u00b2";
  map.y_label = "beta / m";
  map.value_label = "mean angle error / deg";
  map.x = errors.alpha_m2;
  map.y = errors.beta_m;
  for (const double error_rad : errors.mean_abs_angle_error_rad) {
    map.value.push_back(degrees(error_rad));
  }
  for (const Identification& result : window.results) {
    const RollModel& model = result.model;
    if (model.alpha_m2 >= map.x.front() && model.alpha_m2 <= map.x.back() && model.beta_m >= map.y.front() &&
        model.beta_m <= map.y.back()) {
      map.spots.push_back({.x = model.alpha_m2, .y = model.beta_m, .label = std::string{name(result.method)}});
    }
  }
  page::HeatMap narrow = map;
  narrow.width = page::half_page;
  narrow.height = 300.0;
  const std::string off = map.spots.size() < window.results.size() ? " The grid's best point is outside." : "";
  return {
      page::svg(map), page::svg(narrow),
      "Each cell shows the mean angle error with the disturbance that fits best. A long dark valley means that many "
      "pairs of alpha and beta fit the log almost equally well." +
          off};
}

}  // namespace fantail::identify::result
