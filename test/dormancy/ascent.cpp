// SPDX-License-Identifier: MIT
#include "dormancy/ascent.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fantail::dormancy {
namespace {

double between(core::RandomStream& random, double low, double high) { return low + (high - low) * random.unit(); }
double evenly_in_size(core::RandomStream& random, double low, double high) {
  return low * std::pow(high / low, random.unit());
}

/// Below the weight for long, or above it for a moment. Pushed at a g beyond its weight for t, a rocket rises by
/// g t^2 a (1 + a) / 2.
void draw_push(const Rocket& rocket, double most_m, core::RandomStream& random, Burn& burn) {
  const double beyond_weight = random.chance(0.5) ? between(random, -0.8, 0.0) : between(random, 0.5, 8.0);
  burn.push = (beyond_weight + 1.0) * g / rocket.thrust_m_s2;
  burn.push_s = beyond_weight <= 0.0
                    ? between(random, 0.2, 5.0)
                    : between(random, 0.3, 1.0) * std::sqrt(2.0 * most_m / (g * beyond_weight * (1.0 + beyond_weight)));
}

}  // namespace

std::string_view name(Story story) {
  constexpr std::array<std::string_view, stories> names{"plain", "chuff", "misfire", "relight", "second burn"};
  return names[static_cast<std::size_t>(story)];
}

double Ascent::thrust_at(double time_s) const {
  const Motor& motor = rocket_->motor;
  const auto burning = [&](double since_s, double burn_s) {
    return motor.thrust(since_s / burn_s) * std::min(1.0, since_s / rocket_->rise_s);
  };
  switch (burn_.story) {
    case Story::plain: return burning(time_s, burn_.burn_s);
    case Story::misfire: return time_s < burn_.push_s ? burn_.push : 0.0;
    case Story::chuff:
      return time_s < burn_.push_s ? burn_.push : burning(time_s - burn_.push_s - burn_.pause_s, burn_.burn_s);
    case Story::relight: {
      const double pause_at = burn_.from * burn_.burn_s;
      if (time_s < pause_at) {
        return burning(time_s, burn_.burn_s);
      }
      const double again = time_s - pause_at - burn_.pause_s;
      return again < 0.0 ? 0.0 : burning(pause_at + again, burn_.burn_s) * std::min(1.0, again / rocket_->rise_s);
    }
    case Story::second_burn:
      return time_s < pause_end_s() ? burning(time_s, burn_.burn_s)
                                    : rocket_->second * burning(time_s - pause_end_s(), rocket_->second * burn_.burn_s);
  }
  return 0.0;
}

double Ascent::last_thrust_s() const {
  const double whole = rocket_->motor.last_thrust() * burn_.burn_s;
  switch (burn_.story) {
    case Story::plain: return whole;
    case Story::second_burn: return pause_end_s() + rocket_->second * whole;
    case Story::misfire: return burn_.push_s;
    case Story::chuff: return whole + burn_.push_s + burn_.pause_s;
    case Story::relight: return whole + burn_.pause_s;
  }
  return whole;
}

double Ascent::pause_end_s() const {
  return (burn_.story == Story::relight ? burn_.from : 1.0) * burn_.burn_s + burn_.pause_s;
}

void Ascent::advance(double step_s) {
  time_s_ += step_s;
  thrust_ = std::max(0.0, thrust_at(time_s_)) * burn_.thrust;
  const double steady = rocket_->thrust_m_s2 * thrust_;
  const double thrust = steady * (1.0 + burn_.oscillation * std::sin(burn_.oscillation_rad_s * time_s_));
  const double mass = 1.0 - rocket_->propellant * std::min(1.0, burnt_);
  burnt_ += thrust_ * step_s / (rocket_->motor.mean() * rocket_->burn_s * (1.0 + rocket_->second * rocket_->second));

  const double density = std::pow(1.0 - 2.25577e-5 * height_m_, 4.25588);
  const double cosine = std::cos(tilt_rad_);
  axial_m_s2_ = (thrust - rocket_->drag_per_m * density * speed_m_s_ * std::abs(speed_m_s_)) / mass;
  double acceleration = axial_m_s2_ - g * cosine;
  if (distance_m_ <= 0.0 && speed_m_s_ <= 0.0 && acceleration < 0.0) {  // the pad carries the rest
    axial_m_s2_ = g * cosine;
    acceleration = 0.0;
  }
  const bool in_guide = distance_m_ < guide_m;
  across_m_s2_ = in_guide ? g * std::sin(tilt_rad_) : 0.0;
  tilt_rate_rad_s_ = in_guide || speed_m_s_ < 3.0 ? 0.0 : g * std::sin(tilt_rad_) / speed_m_s_;
  const double before = speed_m_s_;
  speed_m_s_ += acceleration * step_s;
  const double moved = 0.5 * (before + speed_m_s_) * step_s;
  distance_m_ += moved;
  if (distance_m_ < 0.0) {  // it has hopped, and stands again
    axial_m_s2_ += -speed_m_s_ / step_s;
    distance_m_ = speed_m_s_ = 0.0;
    height_m_ = 0.0;
  } else {
    height_m_ += moved * std::cos(tilt_rad_ + 0.5 * tilt_rate_rad_s_ * step_s);
  }
  tilt_rad_ += tilt_rate_rad_s_ * step_s;
  pressure_ = density * speed_m_s_ * speed_m_s_;
}

Planned draw_rocket(core::RandomStream& random) {
  for (;;) {
    const Motor motor{static_cast<Family>(random.whole(0, families - 1)),
                      static_cast<std::size_t>(random.whole(0, variants - 1))};
    const double over_weight = evenly_in_size(random, 3.0, 15.0) / motor.thrust(0.05);  // at its beginning
    Planned planned{
        .rocket = {.motor = motor,
                   .burn_s = evenly_in_size(random, 0.8, 8.0),
                   .thrust_m_s2 = over_weight * g,
                   .rise_s = evenly_in_size(random, 0.01, 0.1),
                   .propellant = between(random, 0.03, 0.4),
                   .drag_per_m = evenly_in_size(random, 2e-4, 1e-2),
                   .tilt_rad = random.chance(0.3) ? 0.0 : between(random, 0.0, 20.0) * M_PI / 180.0,
                   .roll_rad_s = between(random, -12.0, 12.0),
                   .second =
                       motor.family() != Family::unlisted_tail && random.chance(0.1) ? between(random, 0.4, 1.0) : 0.0},
        .top_m_s = 0.0,
        .apogee_m = 0.0};
    if (over_weight > 25.0) {
      continue;
    }
    Ascent ascent{planned.rocket,
                  {.story = planned.rocket.second > 0.0 ? Story::second_burn : Story::plain,
                   .burn_s = planned.rocket.burn_s,
                   .thrust = 1.0,
                   .pause_s = 1.0}};
    for (int step = 0; step < 10'000 && !ascent.is_over() && planned.top_m_s <= 260.0; ++step) {
      ascent.advance(0.01);
      planned.top_m_s = std::max(planned.top_m_s, ascent.speed_m_s());
      planned.apogee_m = std::max(planned.apogee_m, ascent.height_m());
    }
    if (planned.top_m_s >= 60.0 && planned.top_m_s <= 260.0) {
      return planned;
    }
  }
}

Burn draw_burn(const Rocket& rocket, Story story, core::RandomStream& random) {
  // Two motors of one lot: 3 % is usual, 8 % is the most.
  const double longer = between(random, -0.04, 0.04) + between(random, -0.04, 0.04);
  Burn burn{.story = story, .burn_s = rocket.burn_s * (1.0 + longer), .thrust = 1.0 / (1.0 + longer)};
  if (random.chance(0.5)) {
    burn.oscillation = between(random, 0.0, 0.2);
    burn.oscillation_rad_s = 2.0 * M_PI * evenly_in_size(random, 5.0, 60.0);
  }
  switch (story) {
    case Story::plain: break;
    case Story::chuff:
      burn.pause_s = evenly_in_size(random, 0.05, 2.0);
      draw_push(rocket, 0.5, random, burn);
      break;
    case Story::misfire: draw_push(rocket, 2.0, random, burn); break;
    case Story::relight:
      burn.from = between(random, 0.05, 0.95);
      burn.pause_s = evenly_in_size(random, 0.02, 2.0);
      break;
    case Story::second_burn: burn.pause_s = evenly_in_size(random, 0.2, 4.0); break;
  }
  return burn;
}

}  // namespace fantail::dormancy
