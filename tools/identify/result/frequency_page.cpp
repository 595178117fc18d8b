// SPDX-License-Identifier: MIT
#include "identify/result/frequency_page.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "page/chart.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

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

std::string_view name(Instrument instrument) {
  switch (instrument) {
    case Instrument::canards: return "canards";
    case Instrument::excitation: return "excitation";
    case Instrument::reference: break;
  }
  return "reference";
}

std::string frequency_sentence(const FrequencyResponse& response) {
  if (!response.obstacle.empty()) {
    return response.obstacle;
  }
  const FrequencyCount count = count_lines(response);
  const std::string needed = text::fixed(least_coherence, 1);
  if (count.told == 0) {
    return fmt::format(
        "Frequency response: the coherence reaches {} at none of {} frequencies up to {} Hz, so the log does not show "
        "one.",
        needed, response.lines.size(), text::brief(response.lines.back().frequency_hz, 1));
  }
  return fmt::format(
      "Frequency response: the coherence reaches {} at {} of {} frequencies, between {} and {} Hz; the model's gain is "
      "inside the 95 % interval at {} of them.",
      needed, count.told, response.lines.size(), text::brief(count.lowest_hz, 1), text::brief(count.highest_hz, 1),
      count.agreed);
}

std::string instrument_sentence(const FrequencyResponse& response) {
  if (response.instrument != Instrument::canards) {
    return fmt::format(
        "The log has the {} of a controller. Cross spectra are taken with it, so what noise and disturbances do to the "
        "canards by way of the controller does not bias the estimate.",
        name(response.instrument));
  }
  if (response.loop_was_closed) {
    return "The log has the reference of a controller, but it did not move, and there was no excitation: noise and "
           "disturbances that came back to the canards through the controller bias this estimate. The fit over time is "
           "not based on it.";
  }
  return "The log does not say what moved the canards. If it was a controller that measured the roll, noise and "
         "disturbances that came back through it bias this estimate; the fit over time is not based on it.";
}

std::string frequency_section(const FrequencyResponse& response) {
  std::string body = page::paragraph(frequency_sentence(response));
  if (!response.lines.empty()) {
    body += page::paragraph(instrument_sentence(response));
    body += page::paragraph(fmt::format(
        "Welch's method: {} segments of {} s that overlap by half, Hann's window. Nothing is drawn where the coherence "
        "is below {}. The model's curve is computed in the same way from the modelled roll rate, so a speed that "
        "changes within the window acts on both alike.",
        response.segments, text::brief(response.segment_s, 2), text::fixed(least_coherence, 1)));
    if (count_lines(response).told > 0) {
      body += page::figure(gain_chart(response));
      const std::vector<std::string> two{page::figure(phase_chart(response)), page::figure(coherence_chart(response))};
      body += page::side_by_side(two);
    } else {
      body += page::figure(coherence_chart(response));
    }
  }
  return page::section("Frequency response", body);
}

}  // namespace fantail::identify::result
