// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "identify/result/parts.hpp"
#include "text/degrees.hpp"

namespace fantail::identify::result {
namespace {

using fantail::result::Picture;
using page::Chart;
using page::Role;
using page::Series;

double decibels(double gain) { return 20.0 * std::log10(gain); }

// Nothing is drawn where the coherence is too low.
template <typename Value>
Series curve(const FrequencyResponse& response, const char* name, Role role, page::Mark mark, const Value& value) {
  Series series{.name = name, .role = role, .mark = mark};
  for (const FrequencyLine& line : response.lines) {
    series.x.push_back(line.frequency_hz);
    series.y.push_back(line.estimate ? value(*line.estimate) : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

Chart over_frequency(const FrequencyResponse& response, const char* label, const char* y_label) {
  Chart chart;
  chart.label = label;
  chart.x_label = "frequency / Hz";
  chart.y_label = y_label;
  chart.x_range = page::Range{0.0, response.lines.back().frequency_hz};
  return chart;
}

// One area for each stretch of lines with an estimate; the first has the name in the legend.
std::vector<page::Area> bands(const FrequencyResponse& response) {
  std::vector<page::Area> all;
  bool open = false;
  for (const FrequencyLine& line : response.lines) {
    if (!line.estimate) {
      open = false;
      continue;
    }
    if (!open) {
      all.push_back({.name = all.empty() ? "95 % interval" : "", .role = Role::measured});
      open = true;
    }
    // An interval that reaches zero ends at a twentieth of the estimate: 26 dB below it.
    constexpr double least_share = 0.05;
    const FrequencyEstimate& e = *line.estimate;
    all.back().x.push_back(line.frequency_hz);
    all.back().low.push_back(decibels(std::fmax(e.gain_per_s - e.reach_per_s, least_share * e.gain_per_s)));
    all.back().high.push_back(decibels(e.gain_per_s + e.reach_per_s));
  }
  return all;
}

Chart gain_chart(const FrequencyResponse& response) {
  Chart chart = over_frequency(response, "gain from the canards to the roll rate", "gain / dB of deg/s per deg");
  chart.areas = bands(response);
  chart.series.push_back(curve(response, "log", Role::measured, page::Mark::line_and_points,
                               [](const FrequencyEstimate& e) { return decibels(e.gain_per_s); }));
  chart.series.push_back(curve(response, "model", Role::model, page::Mark::line_and_points,
                               [](const FrequencyEstimate& e) { return decibels(e.model_gain_per_s); }));
  return chart;
}

Chart phase_chart(const FrequencyResponse& response) {
  Chart chart = over_frequency(response, "phase from the canards to the roll rate", "phase / deg");
  chart.width = page::half_page;
  chart.series.push_back(curve(response, "log", Role::measured, page::Mark::line_and_points,
                               [](const FrequencyEstimate& e) { return text::degrees(e.phase_rad); }));
  chart.series.push_back(curve(response, "model", Role::model, page::Mark::line_and_points,
                               [](const FrequencyEstimate& e) { return text::degrees(e.model_phase_rad); }));
  return chart;
}

Chart coherence_chart(const FrequencyResponse& response) {
  Chart chart = over_frequency(response, "coherence", "coherence");
  chart.width = page::half_page;
  Series series{.name = "coherence", .role = Role::measured, .mark = page::Mark::line_and_points};
  for (const FrequencyLine& line : response.lines) {
    series.x.push_back(line.frequency_hz);
    series.y.push_back(line.coherence);
  }
  chart.series.push_back(std::move(series));
  chart.levels.push_back({.value = least_coherence, .label = "needed"});
  chart.y_range = page::Range{0.0, 1.0};
  return chart;
}

}  // namespace

void add_frequency(Blocks& to, const FrequencyResponse& response) {
  if (count_lines(response).told > 0) {
    to.emplace_back(Picture{gain_chart(response)});
    to.emplace_back(Picture{phase_chart(response)});
  }
  to.emplace_back(Picture{coherence_chart(response)});
}

}  // namespace fantail::identify::result
