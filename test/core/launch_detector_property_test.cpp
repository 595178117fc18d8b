// SPDX-License-Identifier: MIT
#include "core/flight_plan_fields.hpp"
#include "core/launch_detector.hpp"
#include "properties.hpp"
#include "random_stream.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;
constexpr Microseconds stale_time{5'000};

/// One accelerometer as the rules tell it, written down without any cleverness: every sample is kept, and the hold is
/// found by walking back from the newest.
class NaiveChannel {
 public:
  explicit NaiveChannel(const LaunchDetectionPlan& plan) : plan_{plan} {}

  bool accept(Microseconds now, const AccelerometerSample& sample) {
    const auto value = static_cast<double>(sample.specific_force_m_s2.x);
    const bool usable = sample.quality == SampleQuality::valid || sample.quality == SampleQuality::saturated;
    const std::int64_t age_us = now.count() - sample.time.count();
    if (!usable || age_us < 0 || age_us > stale_time.count() || !(std::abs(value) <= 1e4) ||
        (!samples_.empty() && sample.time < samples_.back().time)) {
      forget_hold();
      return false;
    }
    if (!samples_.empty() && sample.time == samples_.back().time) {
      return true;
    }
    double filtered = value;
    if (!samples_.empty()) {
      if (sample.time - samples_.back().time > stale_time) {
        forget_hold();
      }
      const double dt_s = static_cast<double>((sample.time - samples_.back().time).count()) * 1e-6;
      // How near the product's series comes to the exponential is the business of LowPass's own tests.
      const double x = 2.0 * std::numbers::pi * static_cast<double>(plan_.low_pass_hz) * dt_s;
      const double share = 1.0 - 1.0 / (1.0 + x + x * x / 2.0 + x * x * x / 6.0);
      filtered = samples_.back().filtered + share * (value - samples_.back().filtered);
    }
    const double observed = plan_.low_pass ? filtered : value;
    const bool saturated = sample.quality == SampleQuality::saturated;
    const auto threshold = static_cast<double>(plan_.threshold_m_s2);
    samples_.push_back({sample.time, filtered, observed >= threshold || saturated, saturated});
    const double margin = std::abs(observed - threshold);
    closest_call = plan_.low_pass ? std::min(closest_call, margin) : closest_call;
    return true;
  }

  void forget_hold() { hold_begins_after_ = samples_.size(); }

  [[nodiscard]] bool complete() const {
    std::size_t first = samples_.size();
    while (first > hold_begins_after_ && samples_[first - 1].above) {
      --first;
    }
    return first < samples_.size() && samples_.back().time - samples_[first].time >= plan_.hold;
  }

  [[nodiscard]] bool empty() const { return samples_.empty(); }
  [[nodiscard]] double filtered() const { return samples_.back().filtered; }
  [[nodiscard]] bool saturated() const { return samples_.back().saturated; }

  double closest_call = 1e9;  ///< how near a comparison came to being decided by rounding

 private:
  struct Kept {
    Microseconds time;
    double filtered;
    bool above;
    bool saturated;
  };
  LaunchDetectionPlan plan_;
  std::vector<Kept> samples_;
  std::size_t hold_begins_after_ = 0;
};

class NaiveDetector {
 public:
  explicit NaiveDetector(const LaunchDetectionPlan& plan) : plan_{plan} {}

  bool update(Microseconds now, const std::array<AccelerometerSample, 2>& samples) {
    const bool first_good = first_.accept(now, samples[0]);
    if (plan_.accelerometers == AccelerometerRule::one) {
      return first_good && first_.complete();
    }
    const bool second_good = second_.accept(now, samples[1]);
    if (first_good != second_good && plan_.single_allowed) {
      return first_good ? first_.complete() : second_.complete();
    }
    if (!first_good || !second_good || disagree()) {
      first_.forget_hold();
      second_.forget_hold();
      return false;
    }
    return first_.complete() && second_.complete();
  }

  [[nodiscard]] double closest_call() const {
    return std::min({closest_call_, first_.closest_call, second_.closest_call});
  }

 private:
  bool disagree() {
    const double excess = first_.filtered() - second_.filtered();
    const auto allowed = static_cast<double>(plan_.disagreement_m_s2);
    closest_call_ = std::min(closest_call_, std::abs(std::abs(excess) - allowed));
    return (excess > allowed && !second_.saturated()) || (-excess > allowed && !first_.saturated());
  }

  LaunchDetectionPlan plan_;
  NaiveChannel first_{plan_};
  NaiveChannel second_{plan_};
  double closest_call_ = 1e9;
};

LaunchDetectionPlan random_plan(RandomStream& random) {
  LaunchDetectionPlan plan = default_plan().launch_detection;
  plan.threshold_m_s2 = random.between(1.5F, 4.0F) * g;
  plan.hold = Microseconds{random.whole(20'000, 200'000)};
  plan.accelerometers = random.chance(0.6) ? AccelerometerRule::two_agree : AccelerometerRule::one;
  plan.single_allowed = random.chance(0.5);
  plan.low_pass = random.chance(0.5);
  plan.low_pass_hz = random.between(8.0F, 40.0F);
  return plan;
}

/// Thrust that comes and goes, seen by two accelerometers of different rates, delays and manners.
class Scene {
 public:
  explicit Scene(RandomStream& random)
      : random_{random},
        bad_share_{random.chance(0.5) ? 0.0 : 0.004},
        interval_{random.whole(1, 3), random.whole(1, 3)} {}

  void advance() {
    now_ += Microseconds{random_.whole(600, 1'400)};
    now_ += random_.chance(0.001) ? Microseconds{random_.whole(0, 20'000)} : Microseconds{0};
    if (now_ >= segment_end_) {
      segment_end_ = now_ + Microseconds{random_.whole(1'000, 250'000)};
      level_g_ = random_.chance(0.6) ? random_.between(3.5F, 12.0F) : random_.between(0.0F, 2.5F);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (tick_ % interval_[i] == 0) {
        samples_[i] = {.time = now_ - Microseconds{random_.whole(0, 500)},
                       .specific_force_m_s2 = {(level_g_ + random_.between(-0.2F, 0.2F)) * g, 0.0F, 0.0F},
                       .quality = level_g_ > 11.0F ? SampleQuality::saturated : SampleQuality::valid};
      }
    }
    ++tick_;
  }

  [[nodiscard]] Microseconds now() const { return now_; }

  std::array<AccelerometerSample, 2> samples() {
    auto result = samples_;
    for (AccelerometerSample& sample : result) {
      if (random_.chance(bad_share_)) {
        spoil(sample);
      }
    }
    return result;
  }

 private:
  void spoil(AccelerometerSample& sample) {
    switch (random_.whole(0, 5)) {
      case 0: sample.quality = SampleQuality::invalid; break;
      case 1: sample = {}; break;
      case 2: sample.specific_force_m_s2.x = std::numeric_limits<float>::quiet_NaN(); break;
      case 3: sample.specific_force_m_s2.x = -std::numeric_limits<float>::infinity(); break;
      case 4: sample.time -= Microseconds{random_.whole(0, 10'000)}; break;
      default: sample.specific_force_m_s2.x = random_.between(-3e38F, 3e38F); break;
    }
  }

  RandomStream& random_;
  double bad_share_;
  std::array<int, 2> interval_;
  Microseconds now_{0};
  Microseconds segment_end_{0};
  float level_g_ = 1.0F;
  int tick_ = 0;
  std::array<AccelerometerSample, 2> samples_{};
};

RC_GTEST_PROP(LaunchDetector, NeverFiresEarlyOrLateAgainstANaiveReference, (std::uint32_t seed)) {
  RandomStream random{seed};
  const LaunchDetectionPlan plan = random_plan(random);
  LaunchDetector detector{plan, stale_time};
  NaiveDetector naive{plan};
  Scene scene{random};
  int fired = 0;
  for (int tick = 0; tick < 3'000; ++tick) {
    scene.advance();
    const auto samples = scene.samples();
    const bool expected = naive.update(scene.now(), samples);
    const DetectionState state = detector.update(scene.now(), samples);
    // What is nearer than a float can tell, nobody can decide.
    if (naive.closest_call() < 0.005) {
      break;
    }
    fired += expected ? 1 : 0;
    RC_ASSERT((state == DetectionState::detected) == expected);
  }
  RC_CLASSIFY(fired > 0, "fired");
}

}  // namespace
}  // namespace fantail::core
