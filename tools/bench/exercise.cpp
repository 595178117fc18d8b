// SPDX-License-Identifier: MIT
#include "bench/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/core.h>

#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

using text::radians;

const double widest_rad = radians(widest_request_deg);
const double beyond_rad = radians(3.0);  // how far past its limit a canard is asked
const double ramp_rad_s = radians(20.0);
constexpr double settle_s = 0.4;
constexpr double hold_s = 0.3;
constexpr double across_s = 0.4;  // twice the way of the other steps
constexpr double verb_hold_s = 0.5;
constexpr double longest_wave_s = 60.0;
constexpr double shortest_wave_s = 0.1;  // in less no amplitude is found behind the swinging-in

std::string_view part_text(Part part) {
  switch (part) {
    case Part::settle: return "at the centre";
    case Part::ramp_positive: return "slowly beyond the + limit";
    case Part::hold_positive: return "held beyond the + limit";
    case Part::return_from_positive: return "slowly back from the + limit";
    case Part::centre_from_above: return "at the centre, from above";
    case Part::ramp_negative: return "slowly beyond the \u2212 limit";
    case Part::hold_negative: return "held beyond the \u2212 limit";
    case Part::return_from_negative: return "slowly back from the \u2212 limit";
    case Part::centre_from_below: return "at the centre, from below";
    case Part::step_out: return "at once to one side";
    case Part::step_across: return "at once to the other side";
    case Part::step_home: return "at once to the centre";
    case Part::sine: break;
  }
  return "through a sine";
}

void require(bool allowed, const char* what) {
  if (!allowed) {
    throw std::invalid_argument{what};
  }
}

}  // namespace

Bounds bounds(const protocol::LimitReport& limits, const Each<core::Angle>& trims) {
  Bounds result;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    result.limit_rad[i] = static_cast<double>(limits.limit[i].radians());
    result.centre_rad[i] =
        std::clamp(static_cast<double>(trims[i].radians()), -result.limit_rad[i], result.limit_rad[i]);
  }
  return result;
}

std::string_view name(ExerciseKind kind) {
  constexpr std::array<std::string_view, 3> names{"limits", "step", "sine"};
  return names[static_cast<std::size_t>(kind)];
}

Exercise Exercise::limits(const Bounds& bounds) {
  Exercise exercise{ExerciseKind::limits, bounds};
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    exercise.limits_turn(canard);
  }
  exercise.limits_turn(std::nullopt);
  return exercise;
}

Exercise Exercise::limits_together(const Bounds& bounds) {
  Exercise exercise{ExerciseKind::limits, bounds};
  exercise.limits_turn(std::nullopt);
  return exercise;
}

Exercise Exercise::limits_of(const Bounds& bounds, std::size_t canard) {
  Exercise exercise{ExerciseKind::limits, bounds};
  exercise.limits_turn(canard);
  return exercise;
}

Exercise Exercise::step(const Bounds& bounds, std::size_t canard, double to_rad) {
  require(std::abs(to_rad) <= widest_rad, "a step must be to an angle within +-20.47 deg");
  Exercise exercise{ExerciseKind::step, bounds};
  exercise.begin_turn(canard);
  exercise.go(Part::settle, settle_s, bounds.centre_rad);
  Each<double> there = bounds.centre_rad;
  there[canard] = to_rad;
  exercise.jump(Part::step_out, verb_hold_s, there);
  exercise.jump(Part::step_home, verb_hold_s, bounds.centre_rad);
  return exercise;
}

Exercise Exercise::sine(const Bounds& bounds, std::size_t canard, const Wave& wave) {
  require(std::abs(wave.amplitude_rad) <= widest_rad, "the amplitude of a sine must be at most 20.47 deg");
  require(wave.frequency_hz >= 0.05 && wave.frequency_hz <= 50.0, "the frequency of a sine must be 0.05 to 50 Hz");
  require(wave.cycles >= 1 && wave.cycles >= shortest_wave_s * wave.frequency_hz &&
              wave.cycles <= longest_wave_s * wave.frequency_hz,
          "a sine must last for at least one cycle, and for 0.1 to 60 s");
  Exercise exercise{ExerciseKind::sine, bounds};
  exercise.wave_ = wave;
  exercise.begin_turn(canard);
  exercise.go(Part::settle, settle_s, bounds.centre_rad);
  exercise.go(Part::sine, wave.cycles / wave.frequency_hz, bounds.centre_rad);
  exercise.go(Part::settle, settle_s, bounds.centre_rad);
  return exercise;
}

protocol::PerCanard Exercise::asked(double time_s) const {
  const Stretch& stretch = stretches_[stretch_at(time_s)];
  const double share = std::clamp((time_s - stretch.begin_s) / (stretch.end_s - stretch.begin_s), 0.0, 1.0);
  protocol::PerCanard angles;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (!stretch.asked[i]) {
      continue;
    }
    double angle_rad = stretch.from_rad[i] + share * (stretch.to_rad[i] - stretch.from_rad[i]);
    if (stretch.part == Part::sine) {
      angle_rad += wave_->amplitude_rad * std::sin(2.0 * std::numbers::pi * share * wave_->cycles);
    }
    angles[i] = core::Angle::from_radians(static_cast<float>(std::clamp(angle_rad, -widest_rad, widest_rad)));
  }
  return angles;
}

std::size_t Exercise::stretch_at(double time_s) const {
  const auto after = std::ranges::upper_bound(stretches_, time_s, {}, &Stretch::begin_s);
  return after == stretches_.begin() ? 0 : static_cast<std::size_t>(after - stretches_.begin()) - 1;
}

std::size_t Exercise::turns_before(std::size_t stretch) const {
  return static_cast<std::size_t>(std::ranges::count_if(turns_, [&](const Turn& turn) { return turn.last < stretch; }));
}

Exercise Exercise::beginning(std::size_t first_turns) const {
  require(first_turns >= 1 && first_turns <= turns_.size(), "an exercise has one turn at least");
  Exercise first = *this;
  first.turns_.resize(first_turns);
  first.stretches_.resize(first.turns_.back().last + 1);
  return first;
}

std::string Exercise::doing(std::size_t stretch) const {
  const auto turn = std::ranges::find_if(turns_, [&](const Turn& one) { return stretch <= one.last; });
  const std::string who = turn->canard ? fmt::format("canard {} alone", *turn->canard + 1) : "all four together";
  return fmt::format("{}: {}", who, part_text(stretches_[stretch].part));
}

void Exercise::begin_turn(std::optional<std::size_t> canard) {
  require(!canard || *canard < core::canard_count, "there are four canards");
  turns_.push_back({.canard = canard, .first = stretches_.size(), .last = stretches_.size()});
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    asked_[i] = !canard || *canard == i;
  }
  now_rad_ = bounds_.centre_rad;
}

void Exercise::go(Part part, double duration_s, const Each<double>& to_rad) {
  const double begin_s = stretches_.empty() ? 0.0 : stretches_.back().end_s;
  turns_.back().last = stretches_.size();
  stretches_.push_back({.part = part,
                        .begin_s = begin_s,
                        .end_s = begin_s + duration_s,
                        .from_rad = now_rad_,
                        .to_rad = to_rad,
                        .asked = asked_});
  now_rad_ = to_rad;
}

void Exercise::jump(Part part, double duration_s, const Each<double>& to_rad) {
  now_rad_ = to_rad;
  go(part, duration_s, to_rad);
}

void Exercise::limits_turn(std::optional<std::size_t> canard) {
  begin_turn(canard);
  const Each<double>& centre = bounds_.centre_rad;
  Each<double> positive = bounds_.limit_rad;
  Each<double> negative{};
  Each<double> beyond_positive{};
  Each<double> beyond_negative{};
  double longest_rad = 0.0;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    negative[i] = -positive[i];
    beyond_positive[i] = std::min(positive[i] + beyond_rad, widest_rad);
    beyond_negative[i] = -beyond_positive[i];
    if (asked_[i]) {
      longest_rad = std::max(longest_rad, beyond_positive[i] + std::abs(centre[i]));
    }
  }
  // Canards with different limits start and arrive together.
  const double ramp_s = longest_rad / ramp_rad_s;
  go(Part::settle, settle_s, centre);
  go(Part::ramp_positive, ramp_s, beyond_positive);
  go(Part::hold_positive, hold_s, beyond_positive);
  go(Part::return_from_positive, ramp_s, centre);
  go(Part::centre_from_above, hold_s, centre);
  go(Part::ramp_negative, ramp_s, beyond_negative);
  go(Part::hold_negative, hold_s, beyond_negative);
  go(Part::return_from_negative, ramp_s, centre);
  go(Part::centre_from_below, hold_s, centre);
  jump(Part::step_out, hold_s, positive);
  jump(Part::step_across, across_s, negative);
  jump(Part::step_home, hold_s, centre);
}

}  // namespace fantail::bench
