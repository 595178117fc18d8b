// SPDX-License-Identifier: MIT
#include "sim/prescribed_flight.hpp"

#include <utility>

namespace fantail::sim {
namespace {

MonotoneCurve curve(const std::vector<PathSample>& samples, double PathSample::* member) {
  std::vector<double> times_s;
  std::vector<double> values;
  times_s.reserve(samples.size());
  values.reserve(samples.size());
  for (const PathSample& sample : samples) {
    times_s.push_back(sample.time_s);
    values.push_back(sample.*member);
  }
  return {std::move(times_s), std::move(values)};
}

/// The trapezoidal rule between the samples.
MonotoneCurve way_across(const std::vector<PathSample>& samples) {
  std::vector<double> times_s;
  std::vector<double> ways_m;
  const PathSample* before = &samples.front();
  double way_m = 0.0;
  for (const PathSample& sample : samples) {
    way_m += 0.5 * (before->across_m_s + sample.across_m_s) * (sample.time_s - before->time_s);
    times_s.push_back(sample.time_s);
    ways_m.push_back(way_m);
    before = &sample;
  }
  return {std::move(times_s), std::move(ways_m)};
}

std::optional<MonotoneCurve> axial_curve(const std::vector<PathSample>& samples) {
  std::vector<double> times_s;
  std::vector<double> values;
  for (const PathSample& sample : samples) {
    if (!sample.axial_specific_force_m_s2) {
      return std::nullopt;
    }
    times_s.push_back(sample.time_s);
    values.push_back(*sample.axial_specific_force_m_s2);
  }
  return MonotoneCurve{std::move(times_s), std::move(values)};
}

}  // namespace

PrescribedFlight::PrescribedFlight(const PrescribedPath& path)
    : liftoff_s_{path.liftoff_s},
      burnout_s_{path.burnout_s},
      apogee_s_{path.apogee_s},
      height_{curve(path.samples, &PathSample::height_m)},
      up_{curve(path.samples, &PathSample::up_m_s)},
      across_{curve(path.samples, &PathSample::across_m_s)},
      way_across_{way_across(path.samples)},
      along_axis_{curve(path.samples, &PathSample::along_axis_m_s)},
      density_{curve(path.samples, &PathSample::density_kg_m3)},
      tilt_{curve(path.samples, &PathSample::tilt_rad)},
      axial_{axial_curve(path.samples)} {
  look(path.samples.front().time_s - 1.0);
}

void PrescribedFlight::advance_to(double time_s) {
  look(time_s);
  const auto note = [time_s](std::optional<double>& event, const std::optional<double>& when) {
    if (!event && when && time_s >= *when) {
      event = time_s;
    }
  };
  note(events_.liftoff_s, liftoff_s_);
  note(events_.burnout_s, burnout_s_);
  note(events_.apogee_s, apogee_s_);
  is_over_ = time_s >= height_.times_s().back();
}

void PrescribedFlight::look(double time_s) {
  height_m_ = height_.at(time_s).value;
  speed_m_s_ = along_axis_.at(time_s).value;
  density_kg_m3_ = density_.at(time_s).value;
  const MonotoneCurve::Here tilt = tilt_.at(time_s);
  tilt_rad_ = tilt.value;
  // The rocket leans towards -y of its frame: its axis is (sine, cosine) and its y (-cosine, sine), across and up.
  const auto [sine, cosine] = sine_cosine(tilt.value);
  const MonotoneCurve::Here across = across_.at(time_s);
  const MonotoneCurve::Here up = up_.at(time_s);
  across_m_ = way_across_.at(time_s).value;
  across_m_s_ = across.value;
  up_m_s_ = up.value;
  const double across_m_s2 = across.slope_per_s;
  const double up_m_s2 = up.slope_per_s + gravity_m_s2;
  specific_force_m_s2_ = {.x = sine * across_m_s2 + cosine * up_m_s2, .y = sine * up_m_s2 - cosine * across_m_s2};
  if (axial_) {
    specific_force_m_s2_.x = axial_->at(time_s).value;
  }
  rate_rad_s_ = {.z = -tilt.slope_per_s};
  angular_acceleration_rad_s2_ = {.z = -tilt.curvature_per_s2};
}

}  // namespace fantail::sim
