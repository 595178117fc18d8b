// SPDX-License-Identifier: MIT
#include "core/canard_monitor.hpp"

#include <algorithm>

#include "core/finite.hpp"
#include "core/low_pass.hpp"

namespace fantail::core {
namespace {

using namespace literals;

// Encoder noise and play; a canard that moved less than this did not move.
constexpr Angle standstill = 0.3_deg;

// A clock that jumps is a timing fault, not a reason to condemn a canard.
constexpr Microseconds longest_tick{5'000};

bool readable(const std::optional<Angle>& encoder) { return encoder && is_finite(encoder->radians()); }

}  // namespace

CanardMonitor::CanardMonitor(const MonitorPlan& monitor, const CanardsPlan& canards)
    : plan_{monitor}, canards_{canards} {}

const std::array<CanardVerdict, canard_count>& CanardMonitor::update(Microseconds time, const CanardCommands& commands,
                                                                     const EncoderAngles& encoders) {
  const Microseconds elapsed = std::clamp(time - last_time_.value_or(time), Microseconds{0}, longest_tick);
  last_time_ = time;
  for (std::size_t i = 0; i < canard_count; ++i) {
    verdicts_[i] = judge(time, elapsed, i, commands[i], encoders);
  }
  return verdicts_;
}

CanardVerdict CanardMonitor::judge(Microseconds time, Microseconds elapsed, std::size_t canard,
                                   const CanardCommand& command, const EncoderAngles& encoders) {
  Channel& channel = channels_[canard];
  const std::optional<Angle>& encoder = encoders[canard];

  // Where the servo should be by now: it starts from where it is, and moves on while its encoder is silent.
  if (!command.driven) {
    channel.expected.reset();
  } else if (channel.expected) {
    const float moved_share = lag_fraction(seconds(elapsed) / seconds(plan_.servo_lag));
    *channel.expected += moved_share * (command.angle - *channel.expected);
  } else if (readable(encoder)) {
    channel.expected = encoder;
  }

  if (!readable(encoder)) {
    channel.off = {};
    channel.apart = {};
    channel.silent_since = channel.silent_since.value_or(time);
    return time - *channel.silent_since >= plan_.encoder_timeout ? CanardVerdict::dead : verdicts_[canard];
  }
  channel.silent_since.reset();
  if (!command.driven) {
    channel.off = {};
    channel.apart = {};
    return CanardVerdict::healthy;
  }

  if (channel.off.charge == Microseconds{0}) {
    channel.lowest = channel.highest = *encoder;
  }
  channel.lowest = std::min(channel.lowest, *encoder);
  channel.highest = std::max(channel.highest, *encoder);
  const bool off = lasts(channel.off, abs(*encoder - *channel.expected) > plan_.tracking_limit, elapsed);
  const bool apart = lasts(channel.apart, stands_apart(canard, encoders), elapsed);
  if (off) {
    return channel.highest - channel.lowest < standstill ? CanardVerdict::stalled : CanardVerdict::slipping;
  }
  return apart ? CanardVerdict::disagreeing : CanardVerdict::healthy;
}

// Against the middle of the others, so that one bad canard does not make its neighbours look bad. The middle of two is
// all that lies between them; one other alone cannot say which of the two is right.
bool CanardMonitor::stands_apart(std::size_t canard, const EncoderAngles& encoders) const {
  auto roll_angle = [&](std::size_t i) {
    const Angle shaft = *encoders[i] - canards_.each[i].trim;
    return canards_.each[i].direction == Direction::reversed ? -shaft : shaft;
  };
  std::array<Angle, canard_count - 1> others{};  // sorted
  std::size_t count = 0;
  for (std::size_t i = 0; i < canard_count; ++i) {
    if (i == canard || !readable(encoders[i])) {
      continue;
    }
    const Angle angle = roll_angle(i);
    std::size_t place = count++;
    for (; place > 0 && others[place - 1] > angle; --place) {
      others[place] = others[place - 1];
    }
    others[place] = angle;
  }
  if (count < 2) {
    return false;
  }
  const Angle own = roll_angle(canard);
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
