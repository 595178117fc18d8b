// SPDX-License-Identifier: MIT
// A launch is detected if and only if the axial specific force has been at or above the threshold (or at the end of the
// sensor's range) in every sample for at least the hold: never before, and at the first sample that makes the hold
// whole, so within one sample after it.
//
// Proved by induction over the samples, so for runs of any length. `Run` below says in its own words since when the
// force has been above the threshold without a break. Before a tick the detector is in any state in which its memory of
// that agrees with Run; after one tick with any samples at any times it must agree again, and its answer must be the
// one that Run demands. A new and a reset detector agree (first lines of main). The low-pass is replaced by any number
// (any_filter/core/low_pass.hpp), so this holds with it and without; the plan may be any. "At or above" is "not below":
// an output of the filter that is no number counts as above, here and in the code. No sample can make one, because one
// that is no number is of no use (`sensible` below).
#include "core/launch_detector.cpp"

#include "proof.hpp"

using namespace fantail;
using namespace fantail::core;
using namespace fantail::proof;

namespace {

/// Since when one accelerometer has seen thrust without a break.
struct Run {
  std::optional<Microseconds> last;   ///< the last sample that was used
  std::optional<Microseconds> since;  ///< the first of those without a break

  [[nodiscard]] bool whole(Microseconds hold) const { return since && *last - *since >= hold; }
};

enum class Use { no, again, yes };

/// Can this sample be used? `again`: it has been seen before.
Use use_of(Microseconds now, Microseconds stale, const std::optional<Microseconds>& last,
           const AccelerometerSample& s) {
  const bool measured = s.quality == SampleQuality::valid || s.quality == SampleQuality::saturated;
  const float x = s.specific_force_m_s2.x;
  const bool sensible = x >= -largest_specific_force_m_s2 && x <= largest_specific_force_m_s2;
  if (!measured || !sensible || s.time > now || s.time < now - stale || (last && s.time < *last)) {
    return Use::no;
  }
  return last && s.time == *last ? Use::again : Use::yes;
}

/// `thrust`: the sample is at or above the threshold, or at the end of the sensor's range.
Use follow(Run& run, Microseconds now, Microseconds stale, const AccelerometerSample& sample, bool thrust) {
  if (run.last && *run.last > now) {  // the clock has jumped back
    run = Run{};
  }
  const Use use = use_of(now, stale, run.last, sample);
  if (use == Use::no) {
    run.since.reset();
  }
  if (use != Use::yes) {
    return use;
  }
  if (!thrust || (run.last && sample.time - *run.last > stale)) {
    run.since.reset();
  }
  run.last = sample.time;
  if (thrust && !run.since) {
    run.since = sample.time;
  }
  return use;
}

AccelerometerSample any_sample() {
  AccelerometerSample sample{};
  sample.time = any_instant();
  sample.specific_force_m_s2 = {nondet_float(), nondet_float(), nondet_float()};
  sample.quality = any_of<SampleQuality>(4);
  return sample;
}

bool agrees(const LaunchDetector::Channel& channel, const Run& run, Microseconds hold) {
  return channel.last_time == run.last && channel.above_since == run.since && channel.hold_complete == run.whole(hold);
}

}  // namespace

int main() {
  LaunchDetectionPlan plan{};
  plan.threshold_m_s2 = nondet_float();
  plan.hold = any_instant();
  assume(plan.hold > Microseconds{0});
  plan.accelerometers = any_of<AccelerometerRule>(2);
  plan.single_allowed = nondet_bool();
  plan.low_pass = nondet_bool();
  plan.disagreement_m_s2 = nondet_float();
  const Microseconds stale = any_instant();
  assume(stale > Microseconds{0});

  LaunchDetector detector{plan, stale};
  CLAIM(agrees(detector.channels_[0], Run{}, plan.hold) && agrees(detector.channels_[1], Run{}, plan.hold));

  std::array<Run, 2> runs{};
  Anything anything;
  detector.visit_state(anything);
  for (std::size_t i = 0; i < 2; ++i) {
    if (nondet_bool()) {
      runs[i].last = any_instant();
      if (nondet_bool()) {
        runs[i].since = any_instant();
        assume(*runs[i].since <= *runs[i].last);
      }
    }
    assume(agrees(detector.channels_[i], runs[i], plan.hold));
  }

  const std::array<AccelerometerSample, 2> samples{any_sample(), any_sample()};
  const Microseconds now = any_instant();
  const DetectionState state = detector.update(now, samples);

  std::array<Use, 2> use{};
  for (std::size_t i = 0; i < 2; ++i) {
    const float seen = plan.low_pass ? detector.channels_[i].low_pass.output_ : samples[i].specific_force_m_s2.x;
    const bool thrust = !(seen < plan.threshold_m_s2) || samples[i].quality == SampleQuality::saturated;
    if (i == 0 || plan.accelerometers == AccelerometerRule::two_agree) {
      use[i] = follow(runs[i], now, stale, samples[i], thrust);
    }
  }

  const bool first_whole = runs[0].whole(plan.hold);
  const bool second_whole = runs[1].whole(plan.hold);
  const bool detected = state == DetectionState::detected;
  if (plan.accelerometers == AccelerometerRule::one) {
    CLAIM(detected == (use[0] != Use::no && first_whole));
  } else if ((use[0] == Use::no) != (use[1] == Use::no) && plan.single_allowed) {
    CLAIM(detected == (use[0] != Use::no ? first_whole : second_whole));
  } else {
    const bool agree = use[0] != Use::no && use[1] != Use::no && state != DetectionState::disagreement;
    CLAIM(detected == (agree && first_whole && second_whole));
    if (!agree) {
      runs[0].since.reset();
      runs[1].since.reset();
    }
  }
  CLAIM(agrees(detector.channels_[0], runs[0], plan.hold));
  CLAIM(agrees(detector.channels_[1], runs[1], plan.hold));

  REACHABLE(1, detected && plan.accelerometers == AccelerometerRule::one);
  REACHABLE(2, detected && plan.accelerometers == AccelerometerRule::two_agree && !plan.single_allowed);
  REACHABLE(3, state == DetectionState::disagreement);
  return 0;
}
