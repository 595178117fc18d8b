// SPDX-License-Identifier: MIT
#include "identify/result/frequency_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/core.h>

#include "distributions/quantiles.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using Complex = std::complex<double>;

constexpr double segments_in_window = 4.5;  // lengths of one; overlapping by half, that makes eight
constexpr std::size_t least_segments = 6;
constexpr double shortest_segment_s = 0.5;
constexpr double longest_segment_s = 4.0;  // longer windows give more segments, not finer lines
constexpr double highest_hz = 25.0;
constexpr double highest_share_of_rate = 0.4;  // of the sample rate
constexpr std::size_t first_line = 2;          // the one below is taken away with the trend

enum Signal : std::uint8_t { instrument, canard, rate, model_rate, signals };
using Signals = std::array<const std::vector<double>*, signals>;

double usual_step_s(const Record& record) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < record.size(); ++i) {
    steps.push_back(record.time_s[i] - record.time_s[i - 1]);
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

// A stretch without a gap, by samples [first, end).
struct Part {
  std::size_t first;
  std::size_t end;
};

std::vector<Part> parts(const Record& record) {
  std::vector<Part> all;
  all.reserve(record.segment_begin.size());
  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    all.push_back(
        {record.segment_begin[s], s + 1 < record.segment_begin.size() ? record.segment_begin[s + 1] : record.size()});
  }
  return all;
}

// At even distances, on straight lines between the samples.
std::vector<double> evenly(const Record& record, const Part& part, const std::vector<double>& values, double step_s) {
  std::vector<double> even;
  const double begin_s = record.time_s[part.first];
  const auto count = static_cast<std::size_t>((record.time_s[part.end - 1] - begin_s) / step_s + 1e-6) + 1;
  std::size_t left = part.first;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = begin_s + step_s * static_cast<double>(i);
    while (left + 2 < part.end && record.time_s[left + 1] <= t) {
      ++left;
    }
    const double share = (t - record.time_s[left]) / (record.time_s[left + 1] - record.time_s[left]);
    even.push_back(values[left] + share * (values[left + 1] - values[left]));
  }
  return even;
}

/// The Fourier transform of one segment at the lines that are looked at.
class Transform {
 public:
  Transform(std::size_t length, std::size_t lines) : lines_{lines} {
    for (std::size_t n = 0; n < length; ++n) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(length);
      wave_.push_back(std::polar(1.0, -turn));
      window_.push_back(0.5 * (1.0 - std::cos(turn)));
    }
  }

  [[nodiscard]] std::size_t length() const { return wave_.size(); }

  [[nodiscard]] std::vector<Complex> of(const double* values) const {
    std::vector<double> segment{values, values + length()};
    take_trend_away(segment);
    std::vector<Complex> result(lines_);
    for (std::size_t k = 0; k < lines_; ++k) {
      std::size_t at = 0;
      for (std::size_t n = 0; n < length(); ++n) {
        result[k] += segment[n] * window_[n] * wave_[at];
        at = (at + k + first_line) % length();
      }
    }
    return result;
  }

 private:
  static void take_trend_away(std::vector<double>& segment) {
    const double middle = 0.5 * static_cast<double>(segment.size() - 1);
    double sum = 0.0;
    double moment = 0.0;
    double inertia = 0.0;
    for (std::size_t n = 0; n < segment.size(); ++n) {
      const double from_middle = static_cast<double>(n) - middle;
      sum += segment[n];
      moment += from_middle * segment[n];
      inertia += from_middle * from_middle;
    }
    const double mean = sum / static_cast<double>(segment.size());
    for (std::size_t n = 0; n < segment.size(); ++n) {
      segment[n] -= mean + moment / inertia * (static_cast<double>(n) - middle);
    }
  }

  std::size_t lines_;
  std::vector<Complex> wave_{};
  std::vector<double> window_{};
};

/// Sums over the segments of one line: [a][b] of a times conjugate b.
using Spectra = std::array<std::array<Complex, signals>, signals>;

double coherence(const Spectra& s, Signal a, Signal b) {
  const double both = s[a][a].real() * s[b][b].real();
  return both > 0.0 ? std::norm(s[a][b]) / both : 0.0;
}

double phase_rad(const Complex& gain) {
  const double angle = std::arg(gain);
  return angle > 0.5 * std::numbers::pi ? angle - 2.0 * std::numbers::pi : angle;
}

FrequencyLine line(double frequency_hz, const Spectra& s, bool plain, double independent_segments) {
  FrequencyLine result{.frequency_hz = frequency_hz,
                       .coherence = plain ? coherence(s, rate, canard)
                                          : std::min(coherence(s, canard, instrument), coherence(s, rate, instrument)),
                       .estimate = {}};
  if (!(result.coherence >= least_coherence)) {
    return result;
  }
  const Complex gain = s[rate][instrument] / s[canard][instrument];
  const Complex model_gain = s[model_rate][instrument] / s[canard][instrument];
  const double left_over = s[rate][rate].real() + std::norm(gain) * s[canard][canard].real() -
                           2.0 * (std::conj(gain) * s[rate][canard]).real();
  const double variance = std::max(left_over, 0.0) * s[instrument][instrument].real() /
                          (std::norm(s[canard][instrument]) * (independent_segments - 1.0));
  result.estimate = {
      .gain_per_s = std::abs(gain),
      .phase_rad = phase_rad(gain),
      .reach_per_s = distributions::student_975(2.0 * (independent_segments - 1.0)) * std::sqrt(0.5 * variance),
      .model_gain_per_s = std::abs(model_gain),
      .model_phase_rad = phase_rad(model_gain)};
  return result;
}

// Neighbours under Hann's window share a sixth of their amplitude (Welch 1967).
double independent(std::size_t segments) {
  const auto n = static_cast<double>(segments);
  return n / (1.0 + 2.0 / 36.0 * (n - 1.0) / n);
}

bool moves(const std::vector<double>& angle_rad) {
  constexpr double least_rad = 1e-6;
  return !angle_rad.empty() && std::ranges::max(angle_rad) - std::ranges::min(angle_rad) > least_rad;
}

void add_segments(const Record& record, const Part& part, const Signals& of, double step_s, const Transform& transform,
                  std::vector<Spectra>& spectra, std::size_t& segments) {
  std::array<std::vector<double>, signals> even;
  std::ranges::transform(of, even.begin(), [&](const auto* values) { return evenly(record, part, *values, step_s); });
  for (std::size_t at = 0; at + transform.length() <= even[rate].size(); at += transform.length() / 2) {
    std::array<std::vector<Complex>, signals> spectrum;
    std::ranges::transform(even, spectrum.begin(), [&](const auto& values) { return transform.of(&values[at]); });
    for (std::size_t k = 0; k < spectra.size(); ++k) {
      for (std::size_t a = 0; a < signals; ++a) {
        for (std::size_t b = 0; b < signals; ++b) {
          spectra[k][a][b] += spectrum[a][k] * std::conj(spectrum[b][k]);
        }
      }
    }
    ++segments;
  }
}

}  // namespace

FrequencyResponse frequency_response(const Record& record, const Simulation& simulation) {
  FrequencyResponse response;
  response.loop_was_closed =
      !record.reference_rad.empty() && std::ranges::find(record.in_control, true) != record.in_control.end();
  response.instrument = moves(record.excitation_rad)  ? Instrument::excitation
                        : moves(record.reference_rad) ? Instrument::reference
                                                      : Instrument::canards;
  double measured_s = 0.0;
  for (const Part& part : parts(record)) {
    measured_s += record.time_s[part.end - 1] - record.time_s[part.first];
  }
  const double step_s = usual_step_s(record);
  const double segment_s = std::min(measured_s / segments_in_window, longest_segment_s);
  const auto length = 2 * static_cast<std::size_t>(0.5 * segment_s / step_s);
  response.segment_s = step_s * static_cast<double>(length);
  const double top_hz = std::min(highest_hz, highest_share_of_rate / step_s);
  const auto top = static_cast<std::size_t>(top_hz * response.segment_s);
  if (segment_s < shortest_segment_s || top < first_line) {
    response.obstacle = fmt::format(
        "No frequency response: the window has {} s of samples at {} Hz; at least {} s at 10 Hz are needed.",
        text::brief(measured_s, 1), text::brief(1.0 / step_s, 1),
        text::brief(segments_in_window * shortest_segment_s, 1));
    return response;
  }

  const std::vector<double>* const from = response.instrument == Instrument::excitation  ? &record.excitation_rad
                                          : response.instrument == Instrument::reference ? &record.reference_rad
                                                                                         : &record.canard_rad;
  const Signals of{from, &record.canard_rad, &record.roll_rate_rad_s, &simulation.roll_rate_rad_s};
  const Transform transform{length, top - first_line + 1};
  std::vector<Spectra> spectra(top - first_line + 1, Spectra{});
  for (const Part& part : parts(record)) {
    add_segments(record, part, of, step_s, transform, spectra, response.segments);
  }
  if (response.segments < least_segments) {
    response.obstacle =
        fmt::format("No frequency response: the gaps leave {} of {} s; at least {} are needed.",
                    text::counted(response.segments, "segment"), text::brief(response.segment_s, 2), least_segments);
    return response;
  }
  for (std::size_t k = 0; k < spectra.size(); ++k) {
    response.lines.push_back(line(static_cast<double>(k + first_line) / response.segment_s, spectra[k],
                                  response.instrument == Instrument::canards, independent(response.segments)));
  }
  return response;
}

FrequencyCount count_lines(const FrequencyResponse& response) {
  FrequencyCount count;
  for (const FrequencyLine& each : response.lines) {
    if (!each.estimate) {
      continue;
    }
    const FrequencyEstimate& e = *each.estimate;
    count.lowest_hz = count.told == 0 ? each.frequency_hz : count.lowest_hz;
    count.highest_hz = each.frequency_hz;
    ++count.told;
    count.agreed += std::abs(e.model_gain_per_s - e.gain_per_s) <= e.reach_per_s ? 1 : 0;
  }
  return count;
}

}  // namespace fantail::identify::result
