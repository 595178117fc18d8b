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

bool readable(const std::optional<Angle>& encoder) { return encoder && is_finite(encoder->radians()); }

}  // namespace

CanardMonitor::CanardMonitor(const MonitorPlan& monitor, const CanardsPlan& canards)
    : plan_{monitor}, canards_{canards} {}

const std::array<CanardVerdict, canard_count>& CanardMonitor::update(Microseconds time, const CanardCommands& commands,
                                                                     const EncoderAngles& encoders) {
  const float moved_share = last_time_ ? lag_fraction(seconds(time - *last_time_) / seconds(plan_.servo_lag)) : 0.0F;
  last_time_ = time;
  for (std::size_t i = 0; i < canard_count; ++i) {
    verdicts_[i] = judge(time, i, moved_share, commands[i], encoders);
  }
  return verdicts_;
}

CanardVerdict CanardMonitor::judge(Microseconds time, std::size_t canard, float moved_share,
                                   const CanardCommand& command, const EncoderAngles& encoders) {
  Channel& channel = channels_[canard];
  const std::optional<Angle>& encoder = encoders[canard];
  if (!readable(encoder)) {
    channel.off_since.reset();
    channel.apart_since.reset();
    channel.silent_since = channel.silent_since.value_or(time);
    return time - *channel.silent_since >= plan_.encoder_timeout ? CanardVerdict::dead : verdicts_[canard];
  }
  channel.silent_since.reset();
  if (!command.driven) {
    channel.expected.reset();
    return CanardVerdict::healthy;
  }

  // Where the servo should be by now; it starts from where it is.
  const Angle expected = channel.expected.value_or(*encoder);
  channel.expected = expected + moved_share * (command.angle - expected);

  const bool off = abs(*encoder - *channel.expected) > plan_.tracking_limit;
  if (!channel.off_since) {
    channel.lowest = channel.highest = *encoder;
  }
  channel.lowest = std::min(channel.lowest, *encoder);
  channel.highest = std::max(channel.highest, *encoder);
  if (lasts(channel.off_since, off, time)) {
    return channel.highest - channel.lowest < standstill ? CanardVerdict::stalled : CanardVerdict::slipping;
  }
  const bool apart = !off && stands_apart(canard, encoders);
  return lasts(channel.apart_since, apart, time) ? CanardVerdict::disagreeing : CanardVerdict::healthy;
}

// Against the middle one of the others, so that one bad canard does not make its neighbours look bad.
bool CanardMonitor::stands_apart(std::size_t canard, const EncoderAngles& encoders) const {
  auto roll_angle = [&](std::size_t i) {
    const Angle shaft = *encoders[i] - canards_.each[i].trim;
    return canards_.each[i].direction == Direction::reversed ? -shaft : shaft;
  };
  std::array<Angle, canard_count - 1> others{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < canard_count; ++i) {
    if (i != canard && readable(encoders[i])) {
      others[count++] = roll_angle(i);
    }
  }
  if (count < others.size()) {
    return false;
  }
  const auto [low, high] = std::minmax(others[0], others[1]);
  const Angle middle = std::clamp(others[2], low, high);
  return abs(roll_angle(canard) - middle) > plan_.disagreement_limit;
}

bool CanardMonitor::lasts(std::optional<Microseconds>& since, bool condition, Microseconds time) const {
  if (!condition) {
    since.reset();
    return false;
  }
  since = since.value_or(time);
  return time - *since >= plan_.hold;
}

}  // namespace fantail::core
