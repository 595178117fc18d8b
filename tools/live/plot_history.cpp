// SPDX-License-Identifier: MIT
#include "live/plot_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "telemetry/panel.hpp"

namespace fantail::live {
namespace {

using Json = json::Value;

// An integer is shorter than "12.30". The law believes nothing that is larger.
Json hundredths(double value) {
  return std::abs(value) < 1e12 ? Json{static_cast<std::int64_t>(std::llround(100.0 * value))} : Json{};
}

}  // namespace

std::optional<double> reference_in_force(const telemetry::State& state) {
  return state.phase == core::Phase::controlling ? state.reference_rad : std::nullopt;
}

Sample sample_of(const telemetry::State& state, const std::optional<double>& canard_rad) {
  using telemetry::degrees;
  return {degrees(state.roll_angle_rad),
          degrees(reference_in_force(state)),
          degrees(state.roll_rate_rad_s),
          degrees(state.command_rad),
          degrees(canard_rad),
          state.height_m,
          state.speed_m_s};
}

void PlotHistory::add(hal::Microseconds time, std::span<const std::optional<double>> sample) {
  if (!stretches_.empty() && time <= stretches_.back().end) {
    return;
  }
  if (untold_ == 0 || time - stretches_.back().begin >= stretch) {
    stretches_.push_back({.begin = time, .end = time, .extremes = std::vector<std::optional<Extremes>>(signal_count_)});
    untold_ += 1;
  }
  Stretch& now = stretches_.back();
  now.end = time;
  for (std::size_t i = 0; i < signal_count_; ++i) {
    if (sample[i] && std::isfinite(*sample[i])) {
      widen(now.extremes[i], *sample[i]);
    }
  }
  while (time - stretches_.front().end > kept_) {
    stretches_.pop_front();
  }
  untold_ = std::min(untold_, stretches_.size());
}

void PlotHistory::clear() {
  stretches_.clear();
  untold_ = 0;
}

void PlotHistory::widen(std::optional<Extremes>& extremes, double value) {
  if (!extremes) {
    extremes = {.low = value, .high = value};
  } else if (value < extremes->low) {
    extremes->low = value;
    extremes->low_came_first = false;
  } else if (value > extremes->high) {
    extremes->high = value;
    extremes->low_came_first = true;
  }
}

Json PlotHistory::json_of(const Stretch& one) {
  Json row = Json::array({one.begin.count() / 1000, one.end.count() / 1000});
  for (const auto& extremes : one.extremes) {
    const bool low_first = !extremes || extremes->low_came_first;
    row.push_back(extremes ? hundredths(low_first ? extremes->low : extremes->high) : Json{});
    row.push_back(extremes ? hundredths(low_first ? extremes->high : extremes->low) : Json{});
  }
  return row;
}

Json PlotHistory::take_news() {
  Json news = Json::array();
  for (std::size_t i = stretches_.size() - untold_; i < stretches_.size(); ++i) {
    news.push_back(json_of(stretches_[i]));
  }
  untold_ = 0;
  return news;
}

Json PlotHistory::all_told() const {
  Json all = Json::array();
  for (std::size_t i = 0; i + untold_ < stretches_.size(); ++i) {
    all.push_back(json_of(stretches_[i]));
  }
  return all;
}

}  // namespace fantail::live
