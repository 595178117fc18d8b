// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "predict/results.hpp"
#include "predict/sentences.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::fixed;

std::string with_ends(const Quantiles& s, double scale, int decimals, std::string_view unit) {
  return fmt::format("{} {} ({} to {})", fixed(scale * s.p50, decimals), unit, fixed(scale * s.p5, decimals),
                     fixed(scale * s.p95, decimals));
}

std::string line(std::string_view label, const std::string& value) { return fmt::format("  {:<27}{}\n", label, value); }

std::string line(std::string_view label, const std::optional<Quantiles>& s, double scale, int decimals,
                 std::string_view unit) {
  return s ? line(label, with_ends(*s, scale, decimals, unit)) : "";
}

std::string figures(const Prediction& p) {
  const double in_degrees = degrees(1.0);
  std::string text = "Median of the runs (5 to 95 % of them):\n";
  text += line("size of the fin offset", p.offset_size_rad, in_degrees, 1, "deg");
  text += line("authority margin", p.authority_margin_rad, in_degrees, 1, "deg");
  text += line("roll settles at", p.settle_rad, in_degrees, 1, "deg");
  text += line("  its reference then", p.settle_reference_rad, in_degrees, 1, "deg");
  text += line("saturated", p.saturated_share, 100.0, 0, "% of control time");
  text += line("spin without authority", p.spin_rate_rad_s, in_degrees, 0, "deg/s at top speed");
  text += line("top speed", p.top_speed_m_s, 1.0, 1, "m/s");
  text += line("apogee", p.apogee_m, 1.0, 0, "m");
  text += line("drift at apogee", p.drift_m, 1.0, 0, "m");
  text += line("wind", p.wind_m_s, 1.0, 1, "m/s");
  if (p.worst_speed) {
    const MarginsAtSpeed& at = *p.worst_speed;
    text += line("worst phase margin", with_ends(at.phase_margin_rad, in_degrees, 0, "deg") +
                                           fmt::format(" at {} m/s", fixed(at.speed_m_s, 0)));
    text += line("  crossover there", at.crossover_rad_s, 1.0, 0, "rad/s");
    text += line("  gain margin there", at.gain_margin, 1.0, 1, "times");
    if (may_swing_with_less(at)) {
      text += "  Where the loop holds, a gain margin below 1 says with how much less gain it swings.\n";
    }
  }
  return text;
}

}  // namespace

std::string prediction_text(const Prediction& p, const Decision& decision) {
  std::string text =
      fmt::format("{} ({}), {}, seed {}\n{}\n\n", p.scenario, p.vehicle, runs(p.runs.size()), p.seed, decision.text);
  if (const std::string changes = changes_sentence(p); !changes.empty()) {
    text.insert(text.find('\n') + 1, changes + "\n");
  }
  if (const std::vector<std::string> left_out = not_in_verdict(p); !left_out.empty()) {
    text += "Beside the requirements:\n";
    for (const std::string& sentence : left_out) {
      text += fmt::format("  {}\n", sentence);
    }
    text += "\n";
  }
  for (const Criterion& c : decision.criteria) {
    text += fmt::format("  {:<11}{}: {}; asked for: {}\n", label(c.judgement), c.label, c.found, c.required);
  }
  for (const std::string& sentence : decision.advice) {
    text += fmt::format("  {}\n", sentence);
  }
  if (const std::string warning = resonance_warning(p); !warning.empty()) {
    text += fmt::format("\n{}\n", warning);
  }
  text += fmt::format("\n{}\nHow this was found:\n", figures(p));
  for (const std::string& sentence : basis(p)) {
    text += fmt::format("  {}\n", sentence);
  }
  return text + fmt::format("\n  any run again, with its flight report: {}\n", repeat_command(p, "RUN"));
}

}  // namespace fantail::predict
