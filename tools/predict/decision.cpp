// SPDX-License-Identifier: MIT
#include "predict/decision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "predict/advice.hpp"
#include "predict/sentences.hpp"
#include "stability/canard_sense.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

// What control engineers call comfortable; advice aims at it, or at what is asked for where that is more.
constexpr double comfortable_phase_margin_rad = text::radians(45.0);

Judgement judge(bool met) { return met ? Judgement::met : Judgement::not_met; }

std::string required_share(double share) { return "at least " + percent(share) + " of the runs"; }

std::string found_share(const Share& share) {
  // Outwards: rounded, the interval may not look narrower than it is.
  return fmt::format("{} ({} to {} %)", of_the_runs(share.value), fixed(std::floor(100.0 * share.low), 0),
                     fixed(std::ceil(100.0 * share.high), 0));
}

bool too_few_runs(const Share& share, double threshold) { return share.value >= threshold && share.low < threshold; }

std::string more_runs(const Share& share, double threshold) {
  return fmt::format(", but {} too few to be sure of {}: fly more with --runs",
                     share.of == 1 ? "1 run is" : fmt::format("{} runs are", share.of), percent(threshold));
}

Criterion authority(const Prediction& p, double threshold) {
  const Share& share = p.authority;
  Criterion c{.key = "authority",
              .label = "Canards can balance the fin offset",
              .found = found_share(share),
              .required = required_share(threshold),
              .judgement = judge(share.low >= threshold)};
  const bool within = c.judgement == Judgement::met || too_few_runs(share, threshold);
  const bool some_at_limit =
      std::ranges::any_of(p.runs, [](const Run& run) { return std::abs(run.authority_margin_rad) <= same_angle_rad; });
  c.clause =
      fmt::format("the fin offset of about {} degrees is {} the {} in {}", fixed(degrees(p.offset_size_rad.p50), 1),
                  within          ? "within"
                  : some_at_limit ? "not smaller than"
                                  : "larger than",
                  p.reach.text(), of_the_runs(within ? share.value : 1.0 - share.value));
  if (too_few_runs(share, threshold)) {
    c.clause += more_runs(share, threshold);
  }
  if (std::string why = stability::why_uncontrollable(p.flown); !why.empty()) {
    c.clause = std::move(why);
    c.judgement = Judgement::not_met;
  }
  return c;
}

/// What a run that is not held came to, as a clause.
struct NotHeld {
  report::Outcome outcome;
  std::string_view clause;
};
constexpr std::array ways_not_to_hold{NotHeld{report::Outcome::ascent_failed, "the ascent fails"},
                                      NotHeld{report::Outcome::off_command, "the roll rests too far from its command"},
                                      NotHeld{report::Outcome::oscillates, "the canards oscillate"},
                                      NotHeld{report::Outcome::cut_short, "control ends early"},
                                      NotHeld{report::Outcome::no_control, "control does not begin"},
                                      NotHeld{report::Outcome::not_judged, "the roll could not be judged"}};

/// "in 3 of 200 runs control does not begin (run 17: no launch was detected)"; empty where no run came to it.
std::string first_with(const Prediction& p, const NotHeld& what) {
  // Control may end early in a run that is not held for another reason, or for what came after it.
  const auto came_to_it = [&what](const Run& run) {
    const bool fails = run.outcome == report::Outcome::ascent_failed;  // which ends control, and is told of itself
    return what.outcome == report::Outcome::cut_short ? run.ended_early && !fails : run.outcome == what.outcome;
  };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(p.runs, came_to_it));
  if (count == 0) {
    return {};
  }
  const auto first = std::ranges::find_if(p.runs, came_to_it);
  const std::string many = count < p.runs.size() ? fmt::format("in {} of {}", count, runs(p.runs.size()))
                           : count == 1          ? "in the run"
                                                 : "in all runs";
  return fmt::format("{} {} (run {}: {})", many, what.clause, first - p.runs.begin(), cause(*first));
}

/// What "held" is: about the angle at which the law settles, and how far that may be from the one that was asked for.
std::string held_where(const Prediction& p) {
  const std::string within = fmt::format(", within {} degrees of ", brief(degrees(report::held_error_rad), 1));
  if (flight::rejects_offset(p.flown.plan)) {
    return within + "its reference";
  }
  const std::string median =
      p.settle_off_rad ? fmt::format("{} in the median, ", fixed(degrees(p.settle_off_rad->p50), 1)) : "";
  return within + fmt::format("where this law settles ({}at most {} degrees from its command)", median,
                              brief(degrees(p.flown.rest_limit_rad), 1));
}

Criterion held(const Prediction& p, double threshold) {
  const Share& share = p.held;
  Criterion c{.key = "held",
              .label = "Roll is held",
              .found = found_share(share),
              .required = required_share(threshold),
              .judgement = judge(share.low >= threshold)};
  if (p.not_judged > 0) {
    c.found += fmt::format(", {} of {} not judged", p.not_judged, runs(p.runs.size()));
  }
  if (const std::size_t outside = steady_outside_model(p); outside > 0) {
    c.found += fmt::format(", {} of {} outside the model", outside, runs(p.runs.size()));
    if (c.judgement == Judgement::not_met && predict::share(share.count + outside, share.of).low >= threshold) {
      c.judgement = Judgement::not_judged;
      return c;
    }
  }
  std::string others;
  for (const NotHeld& what : ways_not_to_hold) {
    if (const std::string text = first_with(p, what); !text.empty()) {
      others += (others.empty() ? "" : ", ") + text;
    }
  }
  if (p.without_control == p.runs.size() || p.not_judged == p.runs.size()) {
    c.clause = others;
    c.judgement = p.without_control > 0 ? Judgement::not_met : c.judgement;  // also where no share is asked for
    return c;
  }
  c.clause = fmt::format("roll is held in {}{}", share.value >= threshold || share.count == 0 ? "" : "only ",
                         of_the_runs(share.value));
  if (share.value >= threshold && share.count > 0) {
    c.clause += held_where(p);
  }
  if (too_few_runs(share, threshold)) {
    c.clause += more_runs(share, threshold);
  } else if (c.judgement == Judgement::not_met && p.spin_rate_rad_s) {
    c.clause += fmt::format(" (without authority it turns at about {} degrees a second at top speed)",
                            fixed(degrees(p.spin_rate_rad_s->p50), 0));
  }
  const auto not_held = std::ranges::find(p.runs, report::Outcome::not_held, &Run::outcome);
  if (not_held != p.runs.end() && !p.spin_rate_rad_s) {
    c.clause += fmt::format(" (not in run {}: {})", not_held - p.runs.begin(), cause(*not_held));
  }
  c.clause += others.empty() ? "" : ", " + others;
  return c;
}

/// Rounded so that "or more" stays true where it is enough and "or less" where it is not, with a digit more where the
/// whole number would hide on which side of the threshold it is.
std::string phase_margin_text(double found_rad, double threshold_rad) {
  if (found_rad >= threshold_rad) {
    return fixed(std::floor(degrees(found_rad)), 0);
  }
  const double whole = std::ceil(degrees(found_rad));
  return whole < degrees(threshold_rad) ? fixed(whole, 0) : fixed(std::floor(10.0 * degrees(found_rad)) / 10.0, 1);
}

Criterion phase_margin(const Prediction& p, double threshold_rad) {
  Criterion c{.key = "phase_margin",
              .label = "Phase margin at the worst speed, low end (5 %) of the runs",
              .required = fmt::format("at least {} degrees", brief(degrees(threshold_rad), 1))};
  if (p.without_control == p.runs.size()) {
    c.found = "not judged: no run was under control";
    return c;
  }
  if (!p.worst_speed) {
    const bool obeys = stability::why_uncontrollable(p.flown).empty();
    c.found = obeys ? "the loop has no gain" : "the canards do not turn the rocket as commanded";
    c.clause = obeys ? "the gains are too small to control the roll" : "";
    c.judgement = Judgement::not_met;
    return c;
  }
  const MarginsAtSpeed& worst = *p.worst_speed;
  const double found_rad = worst.phase_margin_rad.p5;
  const std::string found = phase_margin_text(found_rad, threshold_rad);
  const std::string speed = fixed(worst.speed_m_s, 0);
  c.judgement = judge(found_rad >= threshold_rad);
  c.found =
      fmt::format("{} degrees at {} m/s (median {})", found, speed, fixed(degrees(worst.phase_margin_rad.p50), 0));
  c.clause =
      c.judgement == Judgement::met
          ? fmt::format("95 % of the runs have a phase margin of {} degrees or more at every speed", found)
          : fmt::format("at {} m/s, 5 % of the runs have a phase margin of {} degrees or less, where {} is required",
                        speed, found, brief(degrees(threshold_rad), 1));
  return c;
}

struct TriedGains {
  GainAdvice gains{};
  Trial trial{};
};

/// The first that costs no runs which would hold: for a comfortable margin, or for the one that is asked for; by both
/// gains, or by the derivative gain alone, because a smaller proportional gain settles further from the reference.
TriedGains try_gains(const Prediction& p, const LimitAdvice& limit, double asked_rad, const Look& look) {
  std::vector<double> aims_rad{std::max(comfortable_phase_margin_rad, asked_rad)};
  if (asked_rad < comfortable_phase_margin_rad) {
    aims_rad.push_back(asked_rad);
  }
  std::optional<TriedGains> first;
  for (const auto search : {stability::Search::both_gains, stability::Search::derivative_gain}) {
    for (const double aim_rad : aims_rad) {
      const GainAdvice gains = advice_on_gains(p, aim_rad, search);
      TriedGains tried{.gains = gains, .trial = trial(p, limit, gains, look)};
      if (tried.gains.gains && tried.trial.helps) {
        return tried;
      }
      if (!first) {
        first = std::move(tried);
      }
    }
  }
  return first.value();
}

std::vector<std::string> advice(const Decision& d, const Prediction& p, const Look& look) {
  LimitAdvice limit;
  bool loop_swings = false;
  std::string tilt;
  std::string wind;
  for (const Criterion& c : d.criteria) {
    if (c.judgement != Judgement::not_met) {
      continue;
    }
    if (c.key == "authority" && !too_few_runs(p.authority, d.thresholds.authority_share)) {
      limit = advice_on_canard_limit(p, d.thresholds.authority_share);
    } else if (c.key == "phase_margin" && p.worst_speed) {
      loop_swings = true;
    } else if (c.key == "tilt_limit") {
      tilt = advice_on_tilt(p);
    } else if (c.key == "held") {
      wind = advice_on_wind(p, look);
    }
  }
  const TriedGains tried = loop_swings ? try_gains(p, limit, d.thresholds.phase_margin_rad, look)
                                       : TriedGains{.trial = trial(p, limit, {}, look)};
  std::vector<std::string> all{limit.sentence, tried.gains.sentence, tried.trial.sentence, tilt, wind};
  std::erase(all, "");
  return all;
}

std::string joined(const std::vector<Criterion>& criteria, bool met) {
  std::string text;
  for (const Criterion& c : criteria) {
    if ((c.judgement == Judgement::met) == met && !c.clause.empty()) {
      text += (text.empty() ? "" : "; ") + c.clause;
    }
  }
  return text;
}

}  // namespace

Decision decide(const Prediction& prediction, const Thresholds& thresholds, const Look& look) {
  Decision d{.thresholds = thresholds};
  d.criteria = {authority(prediction, thresholds.authority_share), held(prediction, thresholds.held_share),
                phase_margin(prediction, thresholds.phase_margin_rad)};
  if (const auto tilt = tilt_limit(prediction)) {
    d.criteria.push_back(*tilt);
  }
  const auto model = within_model(prediction);
  const bool is_caution = model && d.criteria[1].judgement == Judgement::met && is_outside_by_wind_alone(prediction);
  if (model && !is_caution) {
    d.criteria.insert(d.criteria.begin(), *model);
  }
  d.go = std::ranges::all_of(d.criteria, [](const Criterion& c) { return c.judgement == Judgement::met; });
  if (d.go) {
    d.cautions = {is_caution ? model->clause : "", stability_caution(prediction), resonance_caution(prediction)};
    std::erase(d.cautions, "");
  }
  d.text = fmt::format("{}: {}{}.", d.heading(), joined(d.criteria, d.go),
                       d.cautions.empty() ? "" : fmt::format("; but {}", fmt::join(d.cautions, "; ")));
  for (const std::string& missing : {missing_spread(prediction), spread_not_drawn(prediction)}) {
    d.text += missing.empty() ? "" : " " + missing;
  }
  d.advice = advice(d, prediction, look);
  return d;
}

}  // namespace fantail::predict
