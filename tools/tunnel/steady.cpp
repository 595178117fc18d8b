// SPDX-License-Identifier: MIT
#include "tunnel/steady.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "files/quantities.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

constexpr std::size_t fewest_readings = 5;

struct Run {
  std::size_t first;
  std::size_t last;  ///< one behind
  double fan_rpm;
};

std::vector<Run> runs_of_the_fan(const TunnelLog& log, double tolerance_rpm) {
  std::vector<Run> runs;
  double sum = 0.0;
  for (std::size_t i = 0; i < log.fan_rpm.size(); ++i) {
    if (runs.empty() || std::abs(log.fan_rpm[i] - runs.back().fan_rpm) > tolerance_rpm) {
      runs.push_back({i, i, 0.0});
      sum = 0.0;
    }
    Run& run = runs.back();
    run.last = i + 1;
    sum += log.fan_rpm[i];
    run.fan_rpm = sum / static_cast<double>(run.last - run.first);
  }
  return runs;
}

SteadySegment segment(const TunnelLog& log, const Run& run, std::size_t first) {
  return {.fan_rpm = run.fan_rpm,
          .begin_s = log.time_s[first],
          .end_s = log.time_s[run.last - 1],
          .first = first,
          .count = run.last - first};
}

constexpr double left_over = 0.25;  // of the scatter, when the change counts as done

/// level + change exp(-(t - first) / time_constant)
struct Decay {
  double change = 0.0;
  double time_constant_s = 0.0;
  double scatter = 0.0;  ///< root mean square about it
};

// For one time constant the rest is a straight line in the exponential.
Decay fit(std::span<const double> time_s, std::span<const double> value, double time_constant_s,
          std::span<double> exponential) {
  std::ranges::transform(time_s, exponential.begin(),
                         [&](double t) { return std::exp(-(t - time_s.front()) / time_constant_s); });
  const Line line = fit_line(exponential, value);
  double squares = 0.0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const double error = value[i] - line.offset - line.slope * exponential[i];
    squares += error * error;
  }
  return {.change = line.slope,
          .time_constant_s = time_constant_s,
          .scatter = std::sqrt(squares / static_cast<double>(value.size()))};
}

Decay fit(std::span<const double> time_s, std::span<const double> value) {
  constexpr int trials = 100;
  const double length_s = time_s.back() - time_s.front();
  const double shortest_s = 0.2 * length_s / static_cast<double>(time_s.size());
  std::vector<double> exponential(time_s.size());
  Decay best;
  for (int i = 0; i <= trials; ++i) {
    const double time_constant_s = shortest_s * std::pow(0.5 * length_s / shortest_s, i / double{trials});
    const Decay decay = fit(time_s, value, time_constant_s, exponential);
    if (i == 0 || decay.scatter < best.scatter) {
      best = decay;
    }
  }
  return best;
}

std::optional<NamedStretch> parse_stretch(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::optional<double> begin_s = text::number(text.substr(0, colon));
  if (!begin_s || colon == std::string_view::npos) {
    return begin_s ? std::optional{NamedStretch{.begin_s = *begin_s}} : std::nullopt;
  }
  const std::optional<double> end_s = text::number(text.substr(colon + 1));
  return end_s && *end_s > *begin_s ? std::optional{NamedStretch{*begin_s, end_s}} : std::nullopt;
}

}  // namespace

std::size_t settled_from(std::span<const double> time_s, std::span<const double> value, double least_scatter) {
  constexpr std::size_t fewest = 4;  // level, change, time constant, and one to tell how well they fit
  if (value.size() < fewest) {
    return value.size();
  }
  const Moments end = moments(value.last(std::max<std::size_t>(value.size() / 3, 2)));
  const double scatter = std::max(end.standard_deviation, least_scatter);
  const double step = std::abs(value.front() - end.mean);
  if (step <= 3.0 * scatter) {
    return 0;
  }
  const auto half_done = std::ranges::find_if(value, [&](double v) { return std::abs(v - end.mean) < 0.5 * step; });
  const auto first = static_cast<std::size_t>(half_done - value.begin());
  if (value.size() < first + fewest) {
    return value.size();
  }
  const Decay decay = fit(time_s.subspan(first), value.subspan(first));
  const double allowed = left_over * std::max(decay.scatter, least_scatter);
  if (std::abs(decay.change) <= allowed) {
    return first;
  }
  const double settled_s =
      time_s[first] + (allowed > 0.0 ? decay.time_constant_s * std::log(std::abs(decay.change) / allowed)
                                     : time_s.back() - time_s[first]);
  return static_cast<std::size_t>(std::ranges::lower_bound(time_s, settled_s) - time_s.begin());
}

SteadySegments find_steady(const TunnelLog& log, const SteadyOptions& options) {
  SteadySegments segments;
  const double rounding_m_s = rounding_deviation(rounding_of(log.wind_speed_m_s));
  for (const Run& run : runs_of_the_fan(log, options.rpm_tolerance)) {
    if (run.fan_rpm <= options.rpm_tolerance) {
      continue;  // the fan stands
    }
    const std::size_t count = run.last - run.first;
    const std::span<const double> time_s = std::span{log.time_s}.subspan(run.first, count);
    const std::span<const double> speed_m_s = std::span{log.wind_speed_m_s}.subspan(run.first, count);
    const std::size_t first = run.first + settled_from(time_s, speed_m_s, rounding_m_s);
    const bool long_enough =
        run.last >= first + fewest_readings && log.time_s[run.last - 1] - log.time_s[first] >= options.shortest_s;
    if (long_enough) {
      segments.found.push_back(segment(log, run, first));
    } else {
      segments.left_out.push_back(
          fmt::format("{:.0f} rpm from {:g} to {:g} s: the wind was not steady for {:g} s with at least {} readings "
                      "before the next set point.",
                      run.fan_rpm, time_s.front(), time_s.back(), options.shortest_s, fewest_readings));
    }
  }
  return segments;
}

SteadySegments take_steady(const TunnelLog& log, const std::vector<NamedStretch>& stretches,
                           const SteadyOptions& options) {
  SteadySegments segments;
  const std::vector<Run> runs = runs_of_the_fan(log, options.rpm_tolerance);
  const auto index_at = [&log](double time_s) {
    return static_cast<std::size_t>(std::ranges::lower_bound(log.time_s, time_s) - log.time_s.begin());
  };
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const NamedStretch& stretch = stretches[i];
    const std::size_t first = index_at(stretch.begin_s);
    const auto run = std::ranges::find_if(runs, [first](const Run& one) { return first < one.last; });
    std::size_t last = run == runs.end() ? log.time_s.size() : run->last;
    if (stretch.end_s) {
      last = index_at(*stretch.end_s);
    }
    if (i + 1 < stretches.size()) {
      last = std::min(last, index_at(stretches[i + 1].begin_s));
    }
    if (last < first + 2) {
      throw text::Error{text::ErrorKind::bad_configuration,
                        fmt::format("{}: fewer than two readings in the steady stretch from {:g} s; the log lasts "
                                    "from {:g} to {:g} s",
                                    log.name, stretch.begin_s, log.time_s.front(), log.time_s.back())};
    }
    SteadySegment taken{
        .begin_s = log.time_s[first], .end_s = log.time_s[last - 1], .first = first, .count = last - first};
    if (!log.fan_rpm.empty()) {
      taken.fan_rpm = mean(std::span{log.fan_rpm}.subspan(first, last - first));
    }
    segments.found.push_back(taken);
  }
  return segments;
}

std::optional<std::vector<NamedStretch>> parse_stretches(std::string_view text) {
  std::vector<NamedStretch> all;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const std::optional<NamedStretch> one = parse_stretch(text.substr(begin, comma - begin));
    const bool increasing = one && (all.empty() || one->begin_s >= all.back().end_s.value_or(all.back().begin_s));
    if (!increasing || (!all.empty() && one->begin_s <= all.back().begin_s)) {
      return std::nullopt;
    }
    all.push_back(*one);
    begin = comma + 1;
  }
  return all;
}

double rounding_of(const std::vector<double>& values) {
  double coarsest = 0.0;
  for (const std::string_view unit : {"m/s", "km/h", "mph", "kt", "ft/s"}) {
    for (const double decimal : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001}) {
      const double step = decimal * files::find_unit(unit)->si;
      const auto is_multiple = [step](double value) {
        return std::abs(value / step - std::round(value / step)) < 1e-6;
      };
      if (step > coarsest && std::ranges::all_of(values, is_multiple)) {
        coarsest = step;
      }
    }
  }
  return coarsest;
}

double rounding_deviation(double step) { return step / std::sqrt(12.0); }

}  // namespace fantail::tunnel
