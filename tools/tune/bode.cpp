// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "page/chart.hpp"
#include "stability/roll_loop.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using page::Role;
using text::brief;
using text::degrees;
using text::fixed;

constexpr double rad_per_turn = 2.0 * std::numbers::pi;
// Not blue: beside them that is the old plan.
constexpr std::array roles{Role::second_model, Role::reference, Role::model};

double in_db(double gain) { return 20.0 * std::log10(gain); }
double in_hz(double w_rad_s) { return w_rad_s / rad_per_turn; }

struct Line {
  std::string speed;  ///< "20 m/s"
  Role role;
  const stability::RollLoop& loop;
  std::optional<stability::Margins> margins;
};

/// The slowest, the middle and the fastest air speed under control.
std::vector<Line> lines_of(const Judged& judged, double median_m_s) {
  const auto off_median = [&](const LoopAtSpeed& at) { return std::abs(at.speed_m_s - median_m_s); };
  const std::vector<LoopAtSpeed>& all = judged.loop;
  const std::array shown{&all.front(), &*std::ranges::min_element(all, {}, off_median), &all.back()};
  std::vector<Line> lines;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (i == 0 || shown[i]->speed_m_s > shown[i - 1]->speed_m_s) {
      lines.push_back({.speed = fixed(shown[i]->speed_m_s, 0) + " m/s",
                       .role = roles.at(i),
                       .loop = shown[i]->open,
                       .margins = stability::margins(shown[i]->open)});
    }
  }
  return lines;
}

/// From a tenth of the lowest crossover to twice the highest frequency with a margin.
std::vector<double> frequencies_rad_s(const std::vector<Line>& lines) {
  constexpr int points = 400;
  double low_rad_s = std::numeric_limits<double>::infinity();
  double high_rad_s = 0.0;
  for (const Line& line : lines) {
    if (line.margins) {
      low_rad_s = std::min(low_rad_s, line.margins->crossover_rad_s);
      high_rad_s = std::max({high_rad_s, line.margins->crossover_rad_s, line.margins->half_turn_rad_s.value_or(0.0)});
    }
  }
  if (high_rad_s == 0.0) {  // no gain reaches one
    low_rad_s = rad_per_turn;
    high_rad_s = 10.0 * rad_per_turn;
  }
  std::vector<double> all;
  for (int i = 0; i <= points; ++i) {
    all.push_back(0.1 * low_rad_s * std::pow(20.0 * high_rad_s / low_rad_s, static_cast<double>(i) / points));
  }
  return all;
}

/// Upright from the level that counts to the curve, with a dot at both.
page::Series margin_mark(const Line& line, double w_rad_s, double from, double to) {
  return {
      .role = line.role, .mark = page::Mark::line_and_points, .x = {in_hz(w_rad_s), in_hz(w_rad_s)}, .y = {from, to}};
}

std::string gain_name(const Line& line) {
  if (!line.margins) {
    return line.speed + ": below 0 dB at every frequency";
  }
  const auto& factor = line.margins->gain_margin;
  return factor ? fmt::format("{}: gain margin {} dB at {} Hz", line.speed, fixed(in_db(*factor), 1),
                              brief(in_hz(*line.margins->half_turn_rad_s), 2))
                : line.speed + ": no gain margin";
}

std::string phase_name(const Line& line) {
  return line.margins ? fmt::format("{}: phase margin {} deg at {} Hz", line.speed,
                                    fixed(degrees(line.margins->phase_margin_rad), 1),
                                    brief(in_hz(line.margins->crossover_rad_s), 2))
                      : line.speed;
}

}  // namespace

std::vector<result::Block> bode_diagram(const Tuning& t) {
  const Judged& judged = t.after ? *t.after : t.before;
  if (judged.loop.empty()) {
    return {};
  }
  const std::vector<Line> lines = lines_of(judged, t.speeds.median_m_s);
  const std::vector<double> w_rad_s = frequencies_rad_s(lines);
  page::Chart gain{.label = "Gain of the open roll loop over frequency",
                   .x_label = "frequency / Hz",
                   .y_label = "gain / dB",
                   .height = 260.0,
                   .levels = {{.value = 0.0, .label = "0 dB", .role = Role::limit}},
                   .x_scale = page::Scale::logarithmic};
  page::Chart phase = gain;
  phase.label = "Phase of the open roll loop over frequency";
  phase.y_label = "phase / deg";
  phase.levels = {{.value = -180.0, .label = "\u2212180 deg", .role = Role::limit}};
  for (const Line& line : lines) {
    page::Series of_gain{.name = gain_name(line), .role = line.role};
    page::Series of_phase{.name = phase_name(line), .role = line.role};
    for (const double w : w_rad_s) {
      const stability::Response response = stability::response(line.loop, w);
      of_gain.x.push_back(in_hz(w));
      of_gain.y.push_back(in_db(response.gain));
      of_phase.x.push_back(in_hz(w));
      of_phase.y.push_back(degrees(response.phase_rad));
    }
    gain.series.push_back(std::move(of_gain));
    phase.series.push_back(std::move(of_phase));
    if (line.margins) {
      if (line.margins->gain_margin) {
        gain.series.push_back(
            margin_mark(line, *line.margins->half_turn_rad_s, 0.0, -in_db(*line.margins->gain_margin)));
      }
      phase.series.push_back(
          margin_mark(line, line.margins->crossover_rad_s, -180.0, degrees(line.margins->phase_margin_rad) - 180.0));
    }
  }
  return {result::Picture{gain, fmt::format("The open roll loop with the gains of the {}, at the slowest, the middle "
                                            "and the fastest air speed under control, for the vehicle as it is.",
                                            t.after ? "new plan" : "old plan")},
          result::Picture{phase,
                          "Phase margin: the distance of the phase from -180 deg where the gain is 0 dB. Gain margin: "
                          "the distance of the gain from 0 dB where the phase is -180 deg."}};
}

}  // namespace fantail::tune
