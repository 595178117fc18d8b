// SPDX-License-Identifier: MIT
#include "faults/judge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "flight/phase_names.hpp"

namespace fantail::faults {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

// A pulse has whole nanoseconds, 0.0001 degrees at 10 us a degree, and the law has 24 bits.
constexpr double rounding_rad = 0.001 * degree;
// After a reset a canard is commanded from where its encoder reads it to trim, whose noise and play are this much.
constexpr double encoder_rad = 0.3 * degree;
constexpr double same_tick_s = 0.0005;

bool is_at_rest(core::Phase phase) { return phase != core::Phase::safe && phase != core::Phase::controlling; }

}  // namespace

Limits limits_of(const sim::Scenario& scenario) {
  constexpr double hard_limit_rad = 20.0 * degree;
  constexpr double longest_capture_s = 1.2;
  const core::FlightPlan& plan = scenario.plan;
  const bool captures = plan.controller.entry == core::ControlEntry::capture;
  Limits limits{.shafts = shaft_limits(scenario),
                .any_turn = captures,
                .capture_s = captures ? longest_capture_s : 0.0,
                .early_s = plan.sensors.barometer == core::BarometerUse::none ? 0.1 : 0.5};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const core::CanardPlan& canard = plan.canards.each[i];
    limits.trim_rad[i] = static_cast<double>(canard.trim.radians());
    limits.limit_rad[i] = std::min({static_cast<double>(plan.controller.canard_limit.radians()), hard_limit_rad,
                                    static_cast<double>(canard.mechanical_stop.radians())});
  }
  return limits;
}

void Twin::add(const Moment& moment) {
  if (moment.phase == core::Phase::controlling) {
    control_begin = control_begin.value_or(phases.size());
    control_end = phases.size();
  }
  true_roll_rad.push_back(moment.true_roll_rad);
  phases.push_back(moment.phase);
}

void Judge::add(const Moment& moment) {
  if (moment.ticked && !moment.completed) {
    breach(moment, "a tick did not complete");
  }
  look_at_commands(moment);
  look_at_shafts(moment);
  look_at_phase(moment);
  look_at_roll(moment);
  last_ticked_ = moment.ticked;
  ++moments_;
}

void Judge::breach(const Moment& moment, const std::string& what) {
  if (findings_.breach.empty()) {
    findings_.breach = what;
    findings_.breach_s = moment.time_s;
  }
}

void Judge::look_at_commands(const Moment& moment) {
  const bool rests = is_at_rest(moment.phase);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const std::optional<double>& commanded = moment.commanded_rad[i];
    if (!commanded) {
      off_trim_rad_[i] = 0.0;
      continue;
    }
    if (!(std::abs(*commanded) <= limits_.limit_rad[i] + rounding_rad)) {
      breach(moment, fmt::format("canard {} commanded to {:.3f} deg; its limit is {:.3f}", i + 1, *commanded / degree,
                                 limits_.limit_rad[i] / degree));
    }
    const double off_rad = std::abs(*commanded - limits_.trim_rad[i]);
    if (moment.ticked && rests && off_rad > rounding_rad) {
      breach(moment, fmt::format("canard {} commanded {:.3f} deg off its trim in {}", i + 1, off_rad / degree,
                                 flight::display_name(moment.phase)));
    }
    const bool in_safe = moment.ticked && last_ticked_ && moment.phase == core::Phase::safe &&
                         phase_ == core::Phase::safe && moment.time_s > 0.0;
    if (in_safe && off_rad > off_trim_rad_[i] + rounding_rad) {
      breach(moment, fmt::format("canard {} commanded away from its trim in Safe, after ignition", i + 1));
    }
    if (moment.time_s >= fault_.begin_s && off_rad > encoder_rad) {
      findings_.trim_after_s = moment.time_s - fault_.begin_s;
    }
    off_trim_rad_[i] = off_rad;
  }
}

// Written so that an angle that is no number is a breach, too.
void Judge::look_at_shafts(const Moment& moment) {
  const ShaftLimits& own = limits_.shafts;
  const bool fails = moment.time_s > fault_.begin_s - same_tick_s && moment.time_s < fault_.end_s + own.travel_s;
  const bool in_safe = moment.phase == core::Phase::safe && moment.time_s > 0.0;
  rests_from_s_ = is_at_rest(moment.phase) ? rests_from_s_.value_or(moment.time_s) : std::optional<double>{};
  std::array<double, core::canard_count> least_rad{};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const Shaft shaft = fails ? fault_.shafts[i] : Shaft::obeys;
    const double angle_rad = moment.true_shaft_rad[i];
    const double off_rad = std::abs(angle_rad - limits_.trim_rad[i]);
    const bool may_be_off = shaft == Shaft::runs_away || shaft == Shaft::stays_short;
    least_rad[i] = least_off_rad_ && !may_be_off ? std::min((*least_off_rad_)[i], off_rad) : off_rad;
    if (shaft == Shaft::runs_away) {
      continue;
    }
    const double allowed_rad = own.off_rad[i] + (shaft == Shaft::jolts ? jolt_rad : 0.0);
    if (!(std::abs(angle_rad) <= limits_.limit_rad[i] + allowed_rad)) {
      breach(moment, fmt::format("canard {} is truly at {:.3f} deg; its limit is {:.3f}", i + 1, angle_rad / degree,
                                 limits_.limit_rad[i] / degree));
    }
    if (may_be_off) {
      continue;
    }
    const double travel_s = own.travel_s * (shaft == Shaft::late ? late_times : 1.0);
    if (rests_from_s_ && moment.time_s > *rests_from_s_ + travel_s && !(off_rad <= allowed_rad)) {
      breach(moment, fmt::format("canard {} is truly {:.3f} deg off its trim in {}", i + 1, off_rad / degree,
                                 flight::display_name(moment.phase)));
    }
    if (in_safe && !(off_rad <= least_rad[i] + 2.0 * allowed_rad + encoder_rad)) {
      breach(moment, fmt::format("canard {} truly moves away from its trim in Safe, after ignition", i + 1));
    }
    if (moment.time_s >= fault_.begin_s && off_rad > allowed_rad + encoder_rad) {
      findings_.stands_after_s = moment.time_s - fault_.begin_s;
    }
  }
  least_off_rad_ = in_safe ? std::optional{least_rad} : std::nullopt;
}

void Judge::look_at_phase(const Moment& moment) {
  if (!moment.ticked) {
    before_gap_ = after_gap_ ? before_gap_ : phase_;
    after_gap_ = true;
    return;
  }
  const core::Phase from = after_gap_ ? before_gap_ : phase_;
  if (moment.phase == core::Phase::controlling) {
    if (!core::is_flight(from) && !(tunnel_ && from == core::Phase::armed)) {
      breach(moment, "Controlling without Launched or Dormant before");
    }
    control_end_ = moments_;
  }
  if (phase_ == core::Phase::finished && moment.phase != core::Phase::finished && !after_gap_) {
    breach(moment, "another phase after Finished");
  }
  findings_.armed = findings_.armed || moment.phase != core::Phase::safe;
  findings_.controlled = findings_.controlled || moment.phase == core::Phase::controlling;
  // A resumed flight is Safe until the flash has said which plan is in force.
  after_gap_ = after_gap_ && moment.phase == core::Phase::safe;
  phase_ = findings_.last_phase = moment.phase;
}

void Judge::look_at_roll(const Moment& moment) {
  const auto capture = static_cast<std::size_t>(limits_.capture_s * 1e3);
  const bool twin_controls =
      twin_.control_begin && moments_ >= *twin_.control_begin + capture && moments_ <= *twin_.control_end;
  if (!twin_controls || moment.time_s < fault_.begin_s) {
    return;
  }
  const double apart_rad = moment.true_roll_rad - twin_.true_roll_rad[moments_];
  const double apart_deg = std::abs(limits_.any_turn ? std::remainder(apart_rad, 360.0 * degree) : apart_rad) / degree;
  findings_.apart_deg = std::max(findings_.apart_deg, apart_deg);
  findings_.apart_with_turns_deg = std::max(findings_.apart_with_turns_deg, std::abs(apart_rad) / degree);
  findings_.apart_at_end_deg = apart_deg;
  if (moment.phase == core::Phase::controlling) {
    findings_.apart_meanwhile_deg = std::max(findings_.apart_meanwhile_deg, apart_deg);
  }
  if (moment.time_s >= fault_.end_s + settle_s_) {
    findings_.apart_settled_deg = std::max(findings_.apart_settled_deg, apart_deg);
  }
}

Findings Judge::findings() const {
  const auto early = static_cast<std::size_t>(limits_.early_s * 1e3);
  Findings all = findings_;
  all.travel_s = limits_.shafts.travel_s;
  all.lasted = control_end_ && twin_.control_end && *control_end_ + early >= *twin_.control_end;
  return all;
}

bool Findings::is(Outcome outcome, const Expected& e) const {
  switch (outcome) {
    case Outcome::not_armed: return !armed;
    case Outcome::no_control: return !controlled;
    case Outcome::holds: return lasted && apart_deg <= e.within_deg;
    case Outcome::recovers: return lasted && apart_settled_deg <= e.within_deg && apart_deg <= e.meanwhile_deg;
    case Outcome::goes_on: return lasted && apart_deg <= e.meanwhile_deg;
    case Outcome::over:
      return last_phase != core::Phase::controlling && trim_after_s <= e.trim_s &&
             stands_after_s <= e.trim_s + travel_s;
    case Outcome::ended:
      return controlled && !lasted && last_phase != core::Phase::controlling && apart_meanwhile_deg <= e.meanwhile_deg;
    case Outcome::anything: break;
  }
  return true;
}

std::optional<Outcome> Findings::outcome(const Expected& expected) const {
  if (!breach.empty()) {
    return std::nullopt;
  }
  for (unsigned bit = 0; bit < outcomes; ++bit) {
    const auto one = static_cast<Outcome>(1U << bit);
    if (expected.allows(one) && is(one, expected)) {
      return one;
    }
  }
  return std::nullopt;
}

std::string Findings::what_it_was() const {
  if (!breach.empty()) {
    return fmt::format("{}, {:.3f} s after ignition", breach, breach_s);
  }
  if (!armed) {
    return "not armed";
  }
  if (!controlled) {
    return "no control";
  }
  const bool has_turned = apart_with_turns_deg > apart_deg + 180.0;
  return fmt::format(
      "{}, roll {:.1f} deg off{}; commands off trim until {:.3f} s after the fault began, canards until {:.3f} s",
      lasted ? "control continued" : "control ended early", apart_deg,
      has_turned ? fmt::format(" without whole turns, {:.1f} with them", apart_with_turns_deg) : "", trim_after_s,
      stands_after_s);
}

}  // namespace fantail::faults
