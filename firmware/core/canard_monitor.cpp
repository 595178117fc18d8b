// SPDX-License-Identifier: MIT
#include "core/canard_monitor.hpp"

#include <algorithm>
#include <limits>

#include "core/finite.hpp"
#include "core/low_pass.hpp"

namespace fantail::core {
namespace {

using namespace literals;

// Encoder noise and play; a canard that moved less than this did not move.
constexpr Angle standstill = 0.3_deg;

// A lag never arrives. This near it has: what is left would only shrink into denormal numbers, which a PC is slow with.
constexpr Angle arrived = 0.0001_deg;

// A clock that jumps is a timing fault, not a reason to condemn a canard.
constexpr Microseconds longest_tick{5'000};

bool readable(const std::optional<Angle>& encoder) { return encoder && is_finite(encoder->radians()); }

}  // namespace

CanardMonitor::CanardMonitor(const MonitorPlan& monitor, const CanardsPlan& canards)
    : plan_{monitor}, servo_lag_s_{seconds(monitor.servo_lag)} {
  for (std::size_t i = 0; i < canard_count; ++i) {
    channels_[i].sense = canards.each[i].direction == Direction::reversed ? -1.0F : 1.0F;
  }
}

const std::array<CanardVerdict, canard_count>& CanardMonitor::update(Microseconds time, const CanardCommands& commands,
                                                                     const EncoderAngles& encoders) {
  Tick tick{.time = time, .elapsed = std::clamp(time - last_time_.value_or(time), Microseconds{0}, longest_tick)};
  last_time_ = time;
  const float moved_share = lag_fraction(seconds(tick.elapsed) / servo_lag_s_);
  for (std::size_t i = 0; i < canard_count; ++i) {
    Channel& channel = channels_[i];
    follow(channel, moved_share, commands[i], encoders[i]);
    if (channel.expected && readable(encoders[i])) {
      tick.departures[i] = channel.sense * (*encoders[i] - *channel.expected);
    }
  }
  tick.all_agree = all_agree(tick.departures);
  for (std::size_t i = 0; i < canard_count; ++i) {
    verdicts_[i] = judge(tick, i, encoders[i]);
  }
  return verdicts_;
}

void CanardMonitor::bridge() {
  last_time_.reset();
  for (Channel& channel : channels_) {
    channel.expected.reset();
    channel.silent_since.reset();
  }
}

// Where the servo should be by now: it starts from where it is, and moves on while its encoder is silent.
void CanardMonitor::follow(Channel& channel, float moved_share, const CanardCommand& command,
                           const std::optional<Angle>& encoder) {
  if (!command.driven) {
    channel.expected.reset();
  } else if (channel.expected) {
    const Angle remaining = command.angle - *channel.expected;
    *channel.expected = abs(remaining) < arrived ? command.angle : *channel.expected + moved_share * remaining;
  } else if (readable(encoder)) {
    channel.expected = encoder;
  }
}

CanardVerdict CanardMonitor::judge(const Tick& tick, std::size_t canard, const std::optional<Angle>& encoder) {
  if (tick.departures[canard]) {
    return judge_departure(tick, canard, *encoder);
  }
  Channel& channel = channels_[canard];
  channel.off = {};
  channel.apart = {};
  if (readable(encoder)) {  // but not driven
    channel.silent_since.reset();
    return CanardVerdict::healthy;
  }
  channel.silent_since = channel.silent_since.value_or(tick.time);
  return tick.time - *channel.silent_since >= plan_.encoder_timeout ? CanardVerdict::dead : verdicts_[canard];
}

CanardVerdict CanardMonitor::judge_departure(const Tick& tick, std::size_t canard, Angle encoder) {
  Channel& channel = channels_[canard];
  channel.silent_since.reset();
  const bool is_off = abs(*tick.departures[canard]) > plan_.tracking_limit;
  const bool is_apart = !tick.all_agree && stands_apart(canard, tick.departures);
  if (!is_off && !is_apart && channel.off.charge == Microseconds{0} && channel.apart.charge == Microseconds{0}) {
    return CanardVerdict::healthy;  // the usual case
  }
  if (channel.off.charge == Microseconds{0}) {
    channel.lowest = channel.highest = encoder;
  }
  channel.lowest = std::min(channel.lowest, encoder);
  channel.highest = std::max(channel.highest, encoder);
  const bool off = lasts(channel.off, is_off, tick.elapsed);
  const bool apart = lasts(channel.apart, is_apart, tick.elapsed);
  if (off) {
    return channel.highest - channel.lowest < standstill ? CanardVerdict::stalled : CanardVerdict::slipping;
  }
  return apart ? CanardVerdict::disagreeing : CanardVerdict::healthy;
}

// The usual case, told from the two outermost: then no canard stands apart from any middle.
bool CanardMonitor::all_agree(const Departures& departures) const {
  Angle low =
      Angle::from_radians(std::numeric_limits<float>::infinity());  // no departures: an empty range, which agrees
  Angle high = -low;
  for (const std::optional<Angle>& departure : departures) {
    if (departure) {
      low = std::min(low, *departure);
      high = std::max(high, *departure);
    }
  }
  return high - low <= plan_.disagreement_limit;
}

// Against the middle of the others, so that one bad canard does not make its neighbours look bad. The middle of two is
// all that lies between them; one other alone cannot say which of the two is right.
bool CanardMonitor::stands_apart(std::size_t canard, const Departures& departures) const {
  std::array<Angle, canard_count - 1> others{};  // sorted
  std::size_t count = 0;
  for (std::size_t i = 0; i < canard_count; ++i) {
    if (i == canard || !departures[i]) {
      continue;
    }
    std::size_t place = count++;
    for (; place > 0 && others[place - 1] > *departures[i]; --place) {
      others[place] = others[place - 1];
    }
    others[place] = *departures[i];
  }
  if (count < 2) {
    return false;
  }
  const Angle own = *departures[canard];
  const Angle middle = std::clamp(own, others[(count - 1) / 2], others[count / 2]);
  return abs(own - middle) > plan_.disagreement_limit;
}

bool CanardMonitor::lasts(Persistence& persistence, bool condition, Microseconds elapsed) const {
  persistence.charge =
      std::clamp(persistence.charge + (condition ? elapsed : -2 * elapsed), Microseconds{0}, plan_.hold);
  persistence.lasting =
      persistence.charge == plan_.hold || (persistence.lasting && persistence.charge > Microseconds{0});
  return persistence.lasting;
}

}  // namespace fantail::core
