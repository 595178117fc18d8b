// SPDX-License-Identifier: MIT
#include "identify/make_record.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "logs/interpolator.hpp"
#include "sim/compressibility.hpp"
#include "text/error.hpp"

namespace fantail::identify {
namespace {

using input::about;
using logs::RollLog;
using text::Error;
using text::ErrorKind;
using Indices = std::vector<std::size_t>;

constexpr std::size_t least_samples = 3;

[[noreturn]] void refuse(const RollLog& log, const std::string& why) {
  throw Error{ErrorKind::bad_data, log.name + ": " + why};
}

std::string label(const Window& window) {
  if (!window.name.empty()) {
    return window.name;
  }
  return (window.from_s ? about(*window.from_s) : "") + ":" + (window.to_s ? about(*window.to_s) : "");
}

// Distance from which on two samples have a gap between them.
double gap_s(const RollLog& log, const RecordOptions& options) {
  return log.time_s.size() < 2 ? options.longest_gap_s
                               : std::max(options.longest_gap_s, 5.0 * logs::usual_interval_s(log.time_s));
}

Indices samples_inside(const RollLog& log, const Window& window, double longest_gap_s) {
  const double first = log.time_s.front();
  const double last = log.time_s.back();
  const double from = window.from_s.value_or(first);
  const double to = window.to_s.value_or(last);
  if (from > to) {
    throw Error{ErrorKind::bad_configuration,
                fmt::format("window {}: begins at {} s, after its end at {} s", label(window), about(from), about(to))};
  }
  if (from < first - longest_gap_s || to > last + longest_gap_s) {
    refuse(log, fmt::format("window {}: {} s to {} s is outside the data, which run from {} s to {} s", label(window),
                            about(from), about(to), about(first), about(last)));
  }
  Indices inside;
  for (std::size_t i = 0; i < log.time_s.size(); ++i) {
    if (log.time_s[i] >= from && log.time_s[i] <= to) {
      inside.push_back(i);
    }
  }
  return inside;
}

// Where the stretches without a gap begin, and only those long enough to say something.
struct Segments {
  Indices samples;
  Indices segment_begin;
};

Segments long_segments(const RollLog& log, const Indices& samples, double longest_gap_s) {
  Segments kept;
  for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end) {
    for (end = begin + 1; end < samples.size(); ++end) {
      if (log.time_s[samples[end]] - log.time_s[samples[end - 1]] > longest_gap_s) {
        break;
      }
    }
    if (end - begin >= least_samples) {
      kept.segment_begin.push_back(kept.samples.size());
      kept.samples.insert(kept.samples.end(), samples.begin() + static_cast<std::ptrdiff_t>(begin),
                          samples.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }
  return kept;
}

std::vector<double> column_at(const RollLog& log, const std::vector<double>& column, const Indices& samples,
                              const char* name) {
  if (column.empty()) {
    refuse(log, fmt::format("the column {} is missing or has no numbers", name));
  }
  std::vector<double> out;
  for (const std::size_t i : samples) {
    if (std::isnan(column[i])) {
      refuse(log, fmt::format("{} has no number at {} s", name, about(log.time_s[i])));
    }
    out.push_back(column[i]);
  }
  return out;
}

// For columns that only some need: all or nothing.
std::vector<double> column_if_complete(const std::vector<double>& column, const Indices& samples) {
  std::vector<double> out;
  if (!column.empty()) {
    std::ranges::for_each(samples, [&](std::size_t i) { out.push_back(column[i]); });
  }
  return std::ranges::any_of(out, [](double v) { return std::isnan(v); }) ? std::vector<double>{} : out;
}

std::vector<double> speeds(const RollLog& log, const Indices& samples, const RecordOptions& options) {
  if (options.speed_m_s) {
    return std::vector<double>(samples.size(), *options.speed_m_s);
  }
  if (log.speed_m_s.empty()) {
    refuse(log, "no speed: the column speed_m_s is missing or has no numbers; if it was not measured, give --speed");
  }
  std::vector<double> speed = column_at(log, log.speed_m_s, samples, "speed_m_s");
  // On board, speed is the integral of acceleration; in a tunnel there is none, and it drifts about zero.
  constexpr double standing_m_s = 1.0;
  if (std::ranges::max(speed) < standing_m_s) {
    refuse(log, fmt::format("no speed: speed_m_s is never above {} m/s in this window. On board it comes from the "
                            "acceleration, which a wind tunnel lacks. Give --speed, or --truth for a simulated log; "
                            "`fantail tunnel steps` takes it from tunnel.csv",
                            about(std::max(0.0, std::ranges::max(speed)))));
  }
  return speed;
}

std::vector<double> densities(const RollLog& log, const Indices& samples, const RecordOptions& options) {
  const bool everywhere_the_same = options.atmosphere.model == sim::DensityModel::constant;
  if (options.density_kg_m3 || everywhere_the_same) {
    return std::vector<double>(samples.size(), options.density_kg_m3.value_or(options.atmosphere.constant_kg_m3));
  }
  if (log.height_m.empty()) {
    refuse(log, "no column height_m to compute the air density from; give the density, as in --density 1.2");
  }
  std::vector<double> density = column_at(log, log.height_m, samples, "height_m");
  for (double& value : density) {
    value = options.atmosphere.density_kg_m3(value + options.site_elevation_m);
  }
  return density;
}

// A log without heights is one near the ground.
void add_mach(model::Record& record, const RollLog& log, const Indices& samples, const RecordOptions& options) {
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double logged_m = log.height_m.empty() ? 0.0 : log.height_m[samples[k]];
    const double height_m = options.site_elevation_m + (std::isfinite(logged_m) ? logged_m : 0.0);
    record.mach.push_back(std::abs(record.speed_m_s[k]) / options.atmosphere.speed_of_sound_m_s(height_m));
    if (options.grows_with_mach) {  // alpha and beta only count times the density
      record.density_kg_m3[k] *= sim::compressibility_factor(sim::Compressibility::prandtl_glauert, record.mach.back());
    }
  }
  record.grows_with_mach = options.grows_with_mach;
}

// The canards' column `lag_s` later; samples for which there is none are left out.
void take_later(const RollLog& log, double lag_s, double longest_gap_s, Indices& samples,
                std::vector<double>& canard_rad) {
  logs::Interpolator interpolator{log.time_s, longest_gap_s};
  std::erase_if(samples, [&](std::size_t i) {
    const auto place = interpolator.at(log.time_s[i] + lag_s);
    canard_rad[i] = place ? place->of(log.canard_rad) : 0.0;
    return !place;
  });
}

// Over a sample either way: how the canards' angle changes when the lag does.
void differentiate(const RollLog& log, double lag_s, double longest_gap_s, Indices& samples,
                   std::vector<double>& rate_rad_s) {
  const double reach_s = logs::usual_interval_s(log.time_s);
  std::vector<double> before = log.canard_rad;
  take_later(log, lag_s - reach_s, longest_gap_s, samples, before);
  take_later(log, lag_s + reach_s, longest_gap_s, samples, rate_rad_s);
  for (const std::size_t i : samples) {
    rate_rad_s[i] = (rate_rad_s[i] - before[i]) / (2.0 * reach_s);
  }
}

}  // namespace

model::Record make_record(const RollLog& log, const Window& window, const RecordOptions& options) {
  const double longest_gap_s = gap_s(log, options);
  const bool with_canards = !log.canard_rad.empty();
  if (!with_canards && options.canard_needed) {
    refuse(log, "the column canard_deg is missing or has no numbers");
  }
  Indices inside = samples_inside(log, window, longest_gap_s);
  std::vector<double> canard_rad = log.canard_rad;
  std::vector<double> canard_rate_rad_s(options.lag_is_fitted ? log.canard_rad.size() : 0);
  if (with_canards && options.lag_s != 0.0) {
    take_later(log, options.lag_s, longest_gap_s, inside, canard_rad);
  }
  if (with_canards && options.lag_is_fitted) {
    differentiate(log, options.lag_s, longest_gap_s, inside, canard_rate_rad_s);
  }
  const auto [samples, segment_begin] = long_segments(log, inside, longest_gap_s);
  if (samples.size() < least_samples) {
    refuse(log, fmt::format("window {}: at least {} samples without a gap between them are needed; there are {} "
                            "samples",
                            label(window), least_samples, inside.size()));
  }

  model::Record record;
  record.window = label(window);
  record.window_begin_s = log.time_s[samples.front()];
  record.segment_begin = segment_begin;
  for (const std::size_t i : samples) {
    record.time_s.push_back(log.time_s[i] - record.window_begin_s);
    if (!options.roll_inertia.empty()) {
      record.roll_inertia_kg_m2.push_back(sim::roll_inertia_kg_m2(options.roll_inertia, log.time_s[i]));
    }
    record.in_control.push_back(log.phase.empty() || log.phase[i] == core::Phase::controlling);
    if (!with_canards) {
      continue;
    }
    record.canard_rad.push_back(canard_rad[i]);
    if (options.lag_is_fitted) {
      record.canard_rate_rad_s.push_back(canard_rate_rad_s[i]);
    }
    if (std::isnan(record.canard_rad.back())) {
      refuse(log, fmt::format("canard_deg has no number at {} s", about(log.time_s[i])));
    }
  }
  record.roll_angle_rad = column_at(log, log.roll_angle_rad, samples, "roll_angle_deg");
  record.roll_rate_rad_s = column_at(log, log.roll_rate_rad_s, samples, "roll_rate_deg_s");
  record.speed_m_s = speeds(log, samples, options);
  record.density_kg_m3 = densities(log, samples, options);
  add_mach(record, log, samples, options);
  record.reference_rad = column_if_complete(log.reference_rad, samples);
  record.excitation_rad = column_if_complete(log.excitation_rad, samples);
  record.offset_estimate_rad = column_if_complete(log.offset_estimate_rad, samples);
  record.law_speed_m_s = column_if_complete(log.estimated_speed_m_s, samples);
  if (log.speed_bound_from_s) {
    record.law_speed_is_bound_s = *log.speed_bound_from_s - record.window_begin_s;
  }
  return record;
}

}  // namespace fantail::identify
