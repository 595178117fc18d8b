// SPDX-License-Identifier: MIT
#include "predict/advice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "flight/flight.hpp"
#include "predict/sentences.hpp"
#include "sim/canard_aerodynamics.hpp"
#include "sim/servo.hpp"
#include "stability/canard_sense.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

// The low end of the phase margin that decide() looks at leaves out 5 % of the runs.
constexpr double share_of_runs = 0.95;

Share within(const Prediction& p, double limit_rad) {
  const auto count =
      std::ranges::count_if(p.runs, [limit_rad](const Run& run) { return std::abs(run.offset_rad) < limit_rad; });
  return share(static_cast<std::size_t>(count), p.runs.size());
}

/// Of what the canards do; a limit of them balances so much less.
double left_by_fins(const Prediction& p) { return stability::left_in_the_end(p.flown); }

/// In half degrees. The tolerance: a plan's 20 degrees are a float, a little less than the number that a person types.
std::optional<double> enough_limit_deg(const Prediction& p, double share, double farthest_deg) {
  const double left = left_by_fins(p);
  const auto last = static_cast<int>(std::floor(2.0 * (farthest_deg / left + 1e-3)));
  for (int half_degrees = 1; half_degrees <= last; ++half_degrees) {
    const double limit_deg = 0.5 * half_degrees;
    if (within(p, text::radians(left * limit_deg)).low >= share) {
      return limit_deg;
    }
  }
  return std::nullopt;
}

std::string_view compared(double value, double present) {
  return value < present ? "smaller" : value > present ? "larger" : "unchanged";
}

/// As published, the loop settles at the reference plus the offset over the gain. With a schedule the gain is another
/// one at each speed.
std::string settles(const Prediction& p, const stability::Gains& gains) {
  const auto present = static_cast<double>(p.flown.plan.controller.proportional_gain);
  const core::FlightPlan& plan = p.flown.plan;
  if (gains.proportional == present || gains.proportional == 0.0 || flight::rejects_offset(plan) ||
      plan.gain_schedule.speeds_count > 0) {
    return {};
  }
  const auto off = [&](double gain) { return fixed(degrees(p.offset_size_rad.p50) / (gain * left_by_fins(p)), 1); };
  return fmt::format(" The roll then settles {} degrees from its reference instead of {} (median of the runs).",
                     off(gains.proportional), off(present));
}

/// What of the law the advice leaves as the plan has it, and the loop model has.
std::string kept(const core::FlightPlan& plan) {
  std::string all;
  if (plan.offset.rejection == core::OffsetRejection::integral) {
    all = fmt::format("integral gain of {} 1/s", brief(static_cast<double>(plan.offset.integral_gain_per_s), 4));
  } else if (plan.offset.rejection == core::OffsetRejection::observer) {
    all = fmt::format("observer of {} rad/s", brief(static_cast<double>(plan.offset.observer_bandwidth_rad_s), 4));
  }
  if (plan.gain_schedule.speeds_count > 0) {
    all += all.empty() ? "gain schedule" : " and gain schedule";
  }
  return all.empty() ? "" : " with its " + all;
}

/// What the first runs of a prediction came to when they were flown again.
struct FlownAgain {
  std::size_t held = 0;
  std::size_t not_judged = 0;
  std::string first_cause{};  ///< of the first that is not held
};

FlownAgain fly_first(const Prediction& p, std::size_t count, const sim::Scenario& changed, const Look& look) {
  FlownAgain all;
  for (std::size_t i = 0; i < count; ++i) {
    const Run run = fly_run(changed, p.runs[i].airframe, p.runs[i].seed);
    look();
    all.held += run.outcome == report::Outcome::held ? 1 : 0;
    all.not_judged += run.outcome == report::Outcome::not_judged ? 1 : 0;
    if (all.first_cause.empty() && run.outcome != report::Outcome::held) {
      all.first_cause = fmt::format("run {}: {}", i, cause(run));
    }
  }
  return all;
}

/// Where none of them can be judged: a reference that moves may be why.
Trial with_a_held_reference(const Prediction& p, std::size_t count, sim::Scenario changed, const std::string& why,
                            const Look& look) {
  const std::string none = fmt::format("With that change, none of the first {} can be judged ({})", runs(count), why);
  if (changed.plan.reference.kind != core::ReferenceKind::hold) {
    changed.plan.reference.kind = core::ReferenceKind::hold;
    if (const std::size_t held = fly_first(p, count, changed, look).held; held > 0) {
      return {fmt::format("{}; with reference.kind=hold as well the roll is held in {} of them.", none, held)};
    }
  }
  return {none + ": whether it helps is unknown.", false};
}

}  // namespace

LimitAdvice advice_on_canard_limit(const Prediction& p, double asked) {
  if (const std::string why = stability::why_uncontrollable(p.flown); !why.empty()) {
    return {fmt::format("No canard limit would balance the offset: {}.", why), {}};
  }
  const double left = left_by_fins(p);
  if (share(p.runs.size(), p.runs.size()).low < asked) {
    return {fmt::format("{} are too few to advise a canard limit: even success in all of them would not prove {}.",
                        runs(p.runs.size()), percent(asked)),
            {}};
  }
  const CanardReach farthest = farthest_reach(p.flown, usual_offset_rad(p.runs));
  const double farthest_deg = degrees(farthest.angle_rad);
  if (const auto limit_deg = enough_limit_deg(p, asked, farthest_deg)) {
    const Share found = within(p, text::radians(left * *limit_deg));
    return {
        fmt::format("A canard limit of {} degrees would balance the offset in {} (at least {}, estimated from {}).",
                    brief(*limit_deg, 1), of_the_runs(found.value), percent_at_least(found.low), runs(p.runs.size())),
        limit_deg};
  }
  // Enough in these runs, and these runs too few to be sure of it.
  if (within(p, farthest.angle_rad).value >= asked) {
    int half_degrees = 1;
    while (within(p, text::radians(left * 0.5 * half_degrees)).value < asked &&
           left * 0.5 * half_degrees < farthest_deg) {
      ++half_degrees;
    }
    const double limit_deg = std::min(0.5 * half_degrees, farthest_deg / left);
    return {fmt::format("A canard limit of {} degrees would balance the offset in {}, but {} are too few to be sure of "
                        "{}: fly more with --runs.",
                        brief(limit_deg, 1), of_the_runs(within(p, text::radians(left * limit_deg)).value),
                        runs(p.runs.size()), percent(asked)),
            limit_deg};
  }
  return {fmt::format("No canard limit would balance the offset in {} of the runs: the canards reach at most {} "
                      "degrees ({}), which is enough in {}.",
                      percent(asked), brief(farthest_deg, 1),
                      farthest.set_by.empty() ? "a plan has no larger limit" : farthest.set_by,
                      of_the_runs(within(p, farthest.angle_rad).value)),
          {}};
}

GainAdvice advice_on_gains(const Prediction& p, double phase_margin_rad, stability::Search search) {
  const core::ControllerPlan& plan = p.flown.plan.controller;
  const stability::Gains present{.proportional = static_cast<double>(plan.proportional_gain),
                                 .derivative_s = static_cast<double>(plan.derivative_gain_s)};
  const stability::Gains largest = stability::largest_gains();
  const stability::PhaseMarginDemand demand{.phase_margin_rad = phase_margin_rad, .share = share_of_runs};
  const stability::LoopsAtSpeeds loops = loops_at_speeds(p.flown, p.runs, p.speeds_m_s);
  const std::string aim = fmt::format("a phase margin of {} degrees in {} of the runs at every speed flown",
                                      brief(degrees(phase_margin_rad), 1), percent(share_of_runs));
  if (const auto gains = stability::nearest_gains(loops, present, largest, demand, search)) {
    return {fmt::format("In the loop model, gains of {} and {} s reach {}: proportional gain {}, derivative gain {} "
                        "(the plan has {} and {} s{}).{}",
                        brief(gains->proportional, 4), brief(gains->derivative_s, 4), aim,
                        compared(gains->proportional, present.proportional),
                        compared(gains->derivative_s, present.derivative_s), brief(present.proportional, 4),
                        brief(present.derivative_s, 4), kept(p.flown.plan), settles(p, *gains)),
            gains};
  }
  const std::string none =
      fmt::format("No gains that a plan allows (up to {} and {} s{}) reach {}", brief(largest.proportional, 4),
                  brief(largest.derivative_s, 4), kept(p.flown.plan), aim);
  const auto lag_s = stability::longest_servo_lag_s(loops, present, sim::shortest_lag_s, demand);
  return {
      lag_s ? fmt::format("{}. With the plan's gains, a servo lag of {} ms or less would reach it ({} ms was assumed).",
                          none, brief(1e3 * *lag_s, 1), brief(1e3 * p.servo_lag_s, 1))
            : fmt::format("{}. With the plan's gains, no servo lag down to {} ms does either.", none,
                          brief(1e3 * sim::shortest_lag_s, 1)),
      {}};
}

sim::Scenario with_advice(const Prediction& p, const LimitAdvice& limit, const GainAdvice& gains) {
  sim::Scenario changed = p.flown;
  core::ControllerPlan& plan = changed.plan.controller;
  if (limit.limit_deg) {
    plan.canard_limit = core::Angle::from_degrees(static_cast<float>(*limit.limit_deg));
  }
  if (gains.gains) {
    plan.proportional_gain = static_cast<float>(gains.gains->proportional);
    plan.derivative_gain_s = static_cast<float>(gains.gains->derivative_s);
  }
  return changed;
}

Trial trial(const Prediction& p, const LimitAdvice& limit, const GainAdvice& gains, const Look& look) {
  if (!limit.limit_deg && !gains.gains) {
    return {};
  }
  sim::Scenario changed = with_advice(p, limit, gains);
  const std::size_t count = std::min(most_flown_again, p.runs.size());
  const auto planned = static_cast<std::size_t>(
      std::ranges::count(std::span{p.runs}.first(count), report::Outcome::held, &Run::outcome));
  const FlownAgain again = fly_first(p, count, changed, look);
  if (again.held < planned) {
    return {fmt::format("With that change, the roll is held in only {} of the first {} ({}); with the plan as it is, "
                        "in {}. Do not follow this advice.",
                        again.held, runs(count), again.first_cause, planned),
            false, share(again.held, count)};
  }
  if (again.not_judged == count) {
    return with_a_held_reference(p, count, std::move(changed), again.first_cause, look);
  }
  if (again.held == 0) {
    return {fmt::format("With that change, none of the first {} holds its roll ({}): it is not enough.", runs(count),
                        again.first_cause),
            true, share(0, count)};
  }
  return {fmt::format("With that change, the roll is held in {} of the first {}{}.", again.held, runs(count),
                      again.not_judged > 0 ? fmt::format(" and not judged in {} of them", again.not_judged) : ""),
          true, share(again.held, count)};
}

}  // namespace fantail::predict
