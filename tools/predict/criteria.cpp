// SPDX-License-Identifier: MIT
#include "predict/criteria.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "predict/sentences.hpp"
#include "report/hold.hpp"
#include "stability/canard_sense.hpp"
#include "text/apart.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

Judgement judge(bool met) { return met ? Judgement::met : Judgement::not_met; }

/// Too few runs tell neither.
Judgement judge(const Share& share, double threshold) {
  return too_few_runs(share, threshold) ? Judgement::not_judged : judge(share.low >= threshold);
}

/// Not as percent() rounds it: 90.5 % is not the 90 that was found.
std::string required_share(double share) { return fmt::format("at least {} % of the runs", brief(100.0 * share, 3)); }

std::string found_share(const Share& share, double threshold) {
  // Outwards: rounded, the interval may not look narrower than it is.
  return fmt::format("{} ({} to {} %){}", of_the_runs(share.value), fixed(std::floor(100.0 * share.low), 0),
                     fixed(std::ceil(100.0 * share.high), 0), too_few_runs(share, threshold) ? ", too few runs" : "");
}

/// "about 7.2 degrees": the median; where it is beyond the reach, never the same number.
std::string usual_offset(const Prediction& p) {
  return text::apart(degrees(p.offset_size_rad.p50), degrees(p.reach.angle_rad), 1);
}

}  // namespace

Criterion share_asked(std::string key, std::string label, const Share& share, double threshold) {
  return {.key = std::move(key),
          .label = std::move(label),
          .found = found_share(share, threshold),
          .required = required_share(threshold),
          .judgement = judge(share, threshold)};
}

std::string more_runs(const Share& share, double threshold) {
  return fmt::format("{} too few to be sure of {}. Fly more with --runs", text::counted(share.of, "run is", "runs are"),
                     percent(threshold));
}

bool too_few_runs(const Share& share, double threshold) { return share.value >= threshold && share.low < threshold; }

std::string as_sentences(const std::vector<std::string>& clauses) {
  std::string all;
  for (std::string clause : clauses) {
    if (!all.empty()) {
      clause.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(clause.front())));
    }
    all += (all.empty() ? "" : ". ") + clause;
  }
  return all;
}

Criterion authority(const Prediction& p, double threshold) {
  const Share& share = p.authority;
  Criterion c = share_asked("authority", "Canards can balance the fin offset", share, threshold);
  const bool within = c.judgement == Judgement::met || too_few_runs(share, threshold);
  const bool some_at_limit =
      std::ranges::any_of(p.runs, [](const Run& run) { return std::abs(run.authority_margin_rad) <= same_angle_rad; });
  c.clause = fmt::format("the fin offset of about {} degrees is {} the {} in {}", usual_offset(p),
                         within          ? "within"
                         : some_at_limit ? "not smaller than"
                                         : "larger than",
                         p.reach.text(), of_the_runs(within ? share.value : 1.0 - share.value));
  if (too_few_runs(share, threshold)) {
    c.clause = as_sentences({more_runs(share, threshold), c.clause});
  }
  if (std::string why = stability::why_uncontrollable(p.flown); !why.empty()) {
    c.clause = std::move(why);
    c.judgement = Judgement::not_met;
  }
  return c;
}

namespace {

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

}  // namespace

Criterion held(const Prediction& p, double threshold) {
  const Share& share = p.held;
  Criterion c = share_asked("held", "Roll is held", share, threshold);
  if (p.not_judged > 0) {
    c.found += fmt::format(", {} of {} not judged", p.not_judged, runs(p.runs.size()));
  }
  if (const std::size_t outside = steady_outside_model(p); outside > 0) {
    c.found += fmt::format(", {} of {} outside the model", outside, runs(p.runs.size()));
    if (c.judgement != Judgement::met && predict::share(share.count + outside, share.of).low >= threshold) {
      c.judgement = Judgement::not_judged;
      return c;
    }
  }
  std::vector<std::string> others;
  for (const NotHeld& what : ways_not_to_hold) {
    others.push_back(first_with(p, what));
  }
  std::erase(others, "");
  if (p.without_control == p.runs.size() || p.not_judged == p.runs.size()) {
    const bool is_said = std::ranges::all_of(p.runs, &Run::gate_stays_closed);  // by gate()
    c.clause = is_said ? "" : as_sentences(others);
    c.judgement = p.without_control > 0 ? Judgement::not_met : c.judgement;  // also where no share is asked for
    return c;
  }
  std::string clause = fmt::format("roll is held in {}{}", share.value >= threshold || share.count == 0 ? "" : "only ",
                                   of_the_runs(share.value));
  if (share.value >= threshold && share.count > 0) {
    clause += held_where(p);
  }
  std::vector<std::string> all;
  if (too_few_runs(share, threshold)) {
    all.push_back(more_runs(share, threshold));
  }
  all.push_back(std::move(clause));
  if (share.count > 0) {
    flight::Flight of_plan;
    of_plan.plan = p.flown.plan;
    const bool again =
        std::ranges::any_of(p.runs, [](const Run& run) { return run.opening && run.opening->reopenings > 0; });
    all.push_back("this leaves out " + report::settling_left_out(of_plan, again));
  }
  report::AllowedTiltEnds allowed;
  for (const Run& run : p.runs) {
    allowed.add(run.outcome == report::Outcome::held ? run.allowed_tilt_end_s : std::nullopt);
  }
  all.push_back(allowed.sentence(share.count, "run"));
  if (c.judgement == Judgement::not_met && p.spin_rate_rad_s) {
    all.push_back(fmt::format("without authority the rocket turns at about {} degrees a second at top speed",
                              fixed(degrees(p.spin_rate_rad_s->p50), 0)));
  }
  const auto not_held = std::ranges::find_if(
      p.runs, [](const Run& run) { return run.outcome == report::Outcome::not_held && !run.ended_early; });
  if (not_held != p.runs.end() && !p.spin_rate_rad_s) {
    all.push_back(fmt::format("it is not held in run {}: {}", not_held - p.runs.begin(), cause(*not_held)));
  }
  all.insert(all.end(), others.begin(), others.end());
  std::erase(all, "");
  c.clause = as_sentences(all);
  return c;
}

namespace {

/// Rounded so that "or more" stays true where it is enough and "or less" where it is not, with a digit more where the
/// whole number would hide on which side of the threshold it is.
std::string phase_margin_text(double found_rad, double threshold_rad) {
  if (found_rad >= threshold_rad) {
    return fixed(std::floor(degrees(found_rad)), 0);
  }
  const double whole = std::ceil(degrees(found_rad));
  return whole < degrees(threshold_rad) ? fixed(whole, 0) : fixed(std::floor(10.0 * degrees(found_rad)) / 10.0, 1);
}

}  // namespace

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

}  // namespace fantail::predict
