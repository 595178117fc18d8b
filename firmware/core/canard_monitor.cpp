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

const CanardVerdicts& CanardMonitor::update(Microseconds time, const CanardCommands& commands,
                                            const EncoderAngles& encoders) {
  const Microseconds elapsed = up_to(longest_tick, time - last_time_.value_or(time));
  last_time_ = time;
  if (elapsed != share_of_) {  // one tick is as long as the other
    share_of_ = elapsed;
    moved_share_ = lag_fraction(seconds(elapsed) / servo_lag_s_);
  }
  bool all_in_order = true;
  Angle lowest = Angle::from_radians(std::numeric_limits<float>::infinity());  // an empty range, in which all agree
  Angle highest = -lowest;
  for (std::size_t i = 0; i < canard_count; ++i) {
    Channel& channel = channels_[i];
    follow(channel, moved_share_, commands[i], encoders[i]);
    all_in_order = is_in_order(channel) && all_in_order;
    if (channel.comparable) {
      lowest = std::min(lowest, channel.departure);
      highest = std::max(highest, channel.departure);
    }
  }
  // Told from the two outermost: then no canard stands apart from any middle.
  const bool all_agree = highest - lowest <= plan_.disagreement_limit;
  if (all_in_order && all_agree) {  // the usual case
    verdicts_.fill(CanardVerdict::healthy);
  } else {
    Tick tick{.time = time, .elapsed = elapsed, .all_agree = all_agree};
    judge_all(tick, encoders);
  }
  return verdicts_;
}

// Called, not written in: the usual case would have fewer registers.
[[gnu::noinline]] void CanardMonitor::judge_all(Tick& tick, const EncoderAngles& encoders) {
  if (!tick.all_agree) {
    sort_departures(tick);
  }
  for (std::size_t i = 0; i < canard_count; ++i) {
    verdicts_[i] = judge(tick, i, encoders[i]);
  }
}

void CanardMonitor::bridge() {
  last_time_.reset();
  for (Channel& channel : channels_) {
    channel.expected.reset();
    channel.silent_since.reset();
  }
}

// Where the servo should be by now: it starts from where it is, and moves on while its encoder is silent. What a canard
// should do by its own command is taken off before it is compared with the others, because the self-test and a bench
// move one and not the others.
void CanardMonitor::follow(Channel& channel, float moved_share, const CanardCommand& command,
                           const std::optional<Angle>& encoder) {
  const bool is_readable = readable(encoder);
  if (is_readable) {
    channel.silent_since.reset();
  }
  channel.comparable = is_readable && command.driven;
  if (!command.driven) {
    channel.expected.reset();
    return;
  }
  if (channel.expected) {
    const Angle remaining = command.angle - *channel.expected;
    const Angle expected = abs(remaining) < arrived ? command.angle : *channel.expected + moved_share * remaining;
    *channel.expected = expected;
    if (is_readable) {
      channel.departure = channel.sense * (*encoder - expected);
    }
  } else if (is_readable) {
    channel.expected = encoder;
    channel.departure = Angle{};
  }
}

// Then there is nothing to judge, as long as it does not stand apart from the others.
bool CanardMonitor::is_in_order(const Channel& channel) const {
  return channel.comparable && abs(channel.departure) <= plan_.tracking_limit &&
         channel.off.charge == Microseconds{0} && channel.apart.charge == Microseconds{0};
}

// Meets SEN-3.
CanardVerdict CanardMonitor::judge(const Tick& tick, std::size_t canard, const std::optional<Angle>& encoder) {
  Channel& channel = channels_[canard];
  if (channel.comparable) {
    return judge_departure(tick, channel, *encoder);
  }
  channel.off = {};
  channel.apart = {};
  if (readable(encoder)) {  // but not driven
    return CanardVerdict::healthy;
  }
  channel.silent_since = channel.silent_since.value_or(tick.time);
  return tick.time - *channel.silent_since >= plan_.encoder_timeout ? CanardVerdict::dead : verdicts_[canard];
}

CanardVerdict CanardMonitor::judge_departure(const Tick& tick, Channel& channel, Angle encoder) const {
  const bool is_apart = !tick.all_agree && stands_apart(tick, channel.departure);
  if (is_in_order(channel) && !is_apart) {
    return CanardVerdict::healthy;
  }
  if (channel.off.charge == Microseconds{0}) {
    channel.lowest = channel.highest = encoder;
  }
  channel.lowest = std::min(channel.lowest, encoder);
  channel.highest = std::max(channel.highest, encoder);
  const bool off = lasts(channel.off, abs(channel.departure) > plan_.tracking_limit, tick.elapsed);
  const bool apart = lasts(channel.apart, is_apart, tick.elapsed);
  if (off) {
    return channel.highest - channel.lowest < standstill ? CanardVerdict::stalled : CanardVerdict::slipping;
  }
  return apart ? CanardVerdict::disagreeing : CanardVerdict::healthy;
}

void CanardMonitor::sort_departures(Tick& tick) const {
  for (const Channel& channel : channels_) {
    if (!channel.comparable) {
      continue;
    }
    std::size_t place = tick.compared++;
    for (; place > 0 && tick.sorted[place - 1] > channel.departure; --place) {
      tick.sorted[place] = tick.sorted[place - 1];
    }
    tick.sorted[place] = channel.departure;
  }
}

// Against the middle of the others, so that one bad canard does not make its neighbours look bad. The middle of two is
// all that lies between them; one other alone cannot say which of the two is right.
bool CanardMonitor::stands_apart(const Tick& tick, Angle departure) const {
  if (tick.compared < 3) {
    return false;
  }
  const std::size_t others = tick.compared - 1;
  std::size_t own = 0;
  while (own < others && tick.sorted[own] != departure) {
    ++own;
  }
  const auto other = [&](std::size_t i) { return tick.sorted[i < own ? i : i + 1]; };
  const Angle limit = plan_.disagreement_limit;
  return other((others - 1) / 2) - departure > limit || departure - other(others / 2) > limit;
}

bool CanardMonitor::lasts(Persistence& persistence, bool condition, Microseconds elapsed) const {
  persistence.charge = up_to(plan_.hold, persistence.charge + (condition ? elapsed : -2 * elapsed));
  persistence.lasting =
      persistence.charge == plan_.hold || (persistence.lasting && persistence.charge > Microseconds{0});
  return persistence.lasting;
}

}  // namespace fantail::core
