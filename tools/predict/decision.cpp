// SPDX-License-Identifier: MIT
#include "predict/decision.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "predict/sentences.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

Judgement judge(bool met) { return met ? Judgement::met : Judgement::not_met; }

std::string required_share(double share) { return "at least " + percent(share) + " of the runs"; }

std::string found_share(const Share& share) {
  return fmt::format("{} ({} to {})", of_the_runs(share.value), fixed(100.0 * share.low, 0), percent(share.high));
}

bool too_few_runs(const Share& share, double threshold) { return share.value >= threshold && share.low < threshold; }

std::string more_runs(const Share& share, double threshold) {
  return fmt::format(", but {} runs are too few to be sure of {}: take more with --runs", share.of, percent(threshold));
}

Criterion authority(const Prediction& p, double threshold) {
  const Share& share = p.authority;
  Criterion c{.key = "authority",
              .label = "Canards can balance the fin offset",
              .found = found_share(share),
              .required = required_share(threshold),
              .judgement = judge(share.low >= threshold)};
  const std::string offset = fixed(degrees(p.offset_size_rad.p50), 1);
  const std::string limit = brief(degrees(p.limit_rad), 1);
  const bool within = c.judgement == Judgement::met || too_few_runs(share, threshold);
  c.clause =
      fmt::format("the fin offset of about {} degrees is {} the {} degree canard limit in {}", offset,
                  within ? "within" : "larger than", limit, of_the_runs(within ? share.value : 1.0 - share.value));
  if (too_few_runs(share, threshold)) {
    c.clause += more_runs(share, threshold);
  }
  return c;
}

Criterion held(const Prediction& p, double threshold) {
  const Share& share = p.held;
  Criterion c{.key = "held", .label = "Roll is held", .required = required_share(threshold)};
  if (share.of == 0) {
    c.found = "could not be judged";
    c.clause =
        "whether roll is held: the reference is never constant for long enough, or the proportional gain is zero";
    return c;
  }
  c.found = found_share(share);
  c.judgement = judge(share.low >= threshold);
  c.clause = fmt::format("roll is held in {}{}", share.value >= threshold || share.count == 0 ? "" : "only ",
                         of_the_runs(share.value));
  if (p.without_control > 0) {
    c.clause += fmt::format(" (control never began in {} of {})", p.without_control, p.runs.size());
  }
  if (too_few_runs(share, threshold)) {
    c.clause += more_runs(share, threshold);
  } else if (c.judgement == Judgement::not_met && p.spin_rate_rad_s) {
    c.clause += fmt::format(" (without authority it turns at about {} degrees a second at top speed)",
                            fixed(degrees(p.spin_rate_rad_s->p50), 0));
  }
  return c;
}

Criterion phase_margin(const Prediction& p, double threshold_rad) {
  Criterion c{.key = "phase_margin",
              .label = "Phase margin at the worst speed, median",
              .required = fmt::format("at least {} degrees", brief(degrees(threshold_rad), 1))};
  if (!p.worst_speed) {
    const bool no_control = p.without_control == p.runs.size();
    c.found = no_control ? "control never begins" : "the loop has no gain";
    c.clause = no_control ? "control never begins" : "the gains are too small to hold anything";
    c.judgement = Judgement::not_met;
    return c;
  }
  const MarginsAtSpeed& worst = *p.worst_speed;
  const double found_rad = worst.phase_margin_rad.p50;
  c.judgement = judge(found_rad >= threshold_rad);
  c.found = fmt::format("{} degrees at {} m/s", fixed(degrees(found_rad), 0), fixed(worst.speed_m_s, 0));
  c.clause =
      c.judgement == Judgement::met
          ? fmt::format("the median phase margin is at least {} degrees at every speed", fixed(degrees(found_rad), 0))
          : fmt::format("at {} m/s the median phase margin is {} degrees, less than the {} asked for",
                        fixed(worst.speed_m_s, 0), fixed(degrees(found_rad), 0), brief(degrees(threshold_rad), 1));
  return c;
}

std::string advice_on_authority(const Prediction& p, double share) {
  std::vector<double> sizes(p.runs.size());
  std::ranges::transform(p.runs, sizes.begin(), [](const Run& run) { return std::abs(run.offset_rad); });
  constexpr double step_deg = 0.5;
  const double enough_deg = step_deg * std::ceil(degrees(point_above(std::move(sizes), share)) / step_deg);
  return fmt::format(
      "A canard limit of {} degrees would balance the offset in {} of the runs; so would straighter fins.",
      brief(enough_deg, 1), percent(share));
}

std::vector<std::string> advice(const Decision& d, const Prediction& p) {
  std::vector<std::string> all;
  for (const Criterion& c : d.criteria) {
    if (c.judgement != Judgement::not_met) {
      continue;
    }
    if (c.key == "authority" && !too_few_runs(p.authority, d.thresholds.authority_share)) {
      all.push_back(advice_on_authority(p, d.thresholds.authority_share));
    } else if (c.key == "phase_margin" && p.worst_speed) {
      all.emplace_back("Smaller gains or a faster servo give the loop more phase margin.");
    }
  }
  return all;
}

std::string joined(const std::vector<Criterion>& criteria, Judgement judgement) {
  std::string text;
  for (const Criterion& c : criteria) {
    if (c.judgement == judgement) {
      text += (text.empty() ? "" : "; ") + c.clause;
    }
  }
  return text;
}

}  // namespace

Decision decide(const Prediction& prediction, const Thresholds& thresholds) {
  Decision d{.thresholds = thresholds};
  d.criteria = {authority(prediction, thresholds.authority_share), held(prediction, thresholds.held_share),
                phase_margin(prediction, thresholds.phase_margin_rad)};
  const std::string wrong = joined(d.criteria, Judgement::not_met);
  d.go = wrong.empty();
  d.text = d.go ? "Go: " + joined(d.criteria, Judgement::met) + "." : "No go: " + wrong + ".";
  if (const std::string open = joined(d.criteria, Judgement::not_judged); !open.empty()) {
    d.text += " Not judged: " + open + ".";
  }
  d.advice = advice(d, prediction);
  return d;
}

}  // namespace fantail::predict
