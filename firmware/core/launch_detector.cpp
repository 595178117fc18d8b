// SPDX-License-Identifier: MIT
#include "core/launch_detector.hpp"

#include "core/finite.hpp"

namespace fantail::core {
namespace {

// A sensor that stands still agrees with one that swings for a part of each swing, and of the shakes by hand that carry
// it through the guide's gate nine in ten have shorter ones than this.
constexpr Microseconds agreement_time{250'000};

}  // namespace

LaunchDetector::LaunchDetector(const LaunchDetectionPlan& plan, Microseconds stale_time)
    : plan_{plan}, stale_time_{stale_time}, channels_{Channel{plan.low_pass_hz}, Channel{plan.low_pass_hz}} {}

void LaunchDetector::reset() { channels_ = {Channel{plan_.low_pass_hz}, Channel{plan_.low_pass_hz}}; }

LaunchDetector::Health LaunchDetector::health(Microseconds now, const Channel& channel,
                                              const AccelerometerSample& sample) const {
  const bool usable = sample.quality == SampleQuality::valid || sample.quality == SampleQuality::saturated;
  const bool fresh = sample.time >= now - stale_time_ && sample.time <= now;
  const bool forwards = !channel.last_time || sample.time >= *channel.last_time;
  if (!usable || !fresh || !forwards || !is_within(sample.specific_force_m_s2.x, largest_specific_force_m_s2)) {
    return Health::bad;
  }
  return channel.last_time == sample.time ? Health::repeated : Health::good;
}

LaunchDetector::Health LaunchDetector::take(Channel& channel, Microseconds now,
                                            const AccelerometerSample& sample) const {
  // A clock that jumped back would make every later sample look old: start over.
  if (channel.last_time > now) {
    channel = Channel{plan_.low_pass_hz};
  }
  const Health verdict = health(now, channel, sample);
  if (verdict == Health::good) {
    channel.last_time = sample.time;
    channel.saturated = sample.quality == SampleQuality::saturated;
    channel.low_pass.update(sample.time, sample.specific_force_m_s2.x);
  }
  return verdict;
}

LaunchDetector::Health LaunchDetector::feed(Channel& channel, Microseconds now, const AccelerometerSample& sample) {
  const std::optional<Microseconds> last_time = channel.last_time;
  const Health verdict = take(channel, now, sample);
  if (verdict == Health::bad) {
    channel.forget_hold();
  }
  if (verdict != Health::good) {
    return verdict;
  }
  // Nobody measured what happened in a gap, so no hold reaches across it.
  if (last_time && sample.time - *last_time > stale_time_) {
    channel.forget_hold();
  }
  const float observed = plan_.low_pass ? *channel.low_pass.output() : sample.specific_force_m_s2.x;
  if (observed < plan_.threshold_m_s2 && !channel.saturated) {
    channel.forget_hold();
    return verdict;
  }
  if (!channel.above_since) {
    channel.above_since = sample.time;
  }
  // Meets DET-1, DET-2.
  channel.hold_complete = sample.time - *channel.above_since >= plan_.hold;
  return verdict;
}

// A channel at its positive end says "at least this much": it may read too little, but not too much.
bool LaunchDetector::disagree() const {
  const auto first = channels_[0].low_pass.output();
  const auto second = channels_[1].low_pass.output();
  // uncovered: a channel that is not bad has had a sample, and so its filter has an output
  if (!first || !second) {
    return false;
  }
  const float excess = *first - *second;
  return (excess > plan_.disagreement_m_s2 && !channels_[1].saturated) ||
         (-excess > plan_.disagreement_m_s2 && !channels_[0].saturated);
}

DetectionState LaunchDetector::update(Microseconds now, const std::array<AccelerometerSample, 2>& samples) {
  const Health first = feed(channels_[0], now, samples[0]);
  if (plan_.accelerometers == AccelerometerRule::one) {
    return first == Health::bad ? DetectionState::bad_sample : channels_[0].state();
  }

  const Health second = feed(channels_[1], now, samples[1]);
  const bool first_lost = first == Health::bad;
  const bool second_lost = second == Health::bad;
  if (first_lost != second_lost && plan_.single_allowed) {
    return channels_[first_lost ? 1 : 0].state();
  }
  // Meets DET-3.
  if (first_lost || second_lost || disagree()) {
    for (Channel& channel : channels_) {
      channel.forget_hold();
    }
    return first_lost || second_lost ? DetectionState::bad_sample : DetectionState::disagreement;
  }
  const DetectionState both = channels_[0].state();
  return both == channels_[1].state() ? both : DetectionState::holding;
}

// Meets DET-4.
bool LaunchDetector::agrees(Microseconds now, const std::array<AccelerometerSample, 2>& samples) {
  if (plan_.accelerometers == AccelerometerRule::one) {
    return true;
  }
  // The hold has done its work: its beginning is from now on when they last disagreed.
  std::optional<Microseconds>& disagreed = channels_[0].above_since;
  if (channels_[0].hold_complete) {
    channels_[0].forget_hold();
  }
  const bool first_measures = take(channels_[0], now, samples[0]) != Health::bad;
  const bool second_measures = take(channels_[1], now, samples[1]) != Health::bad;
  if (first_measures && second_measures && disagree()) {
    disagreed = now;
  }
  return !disagreed || now - *disagreed >= agreement_time;
}

}  // namespace fantail::core
