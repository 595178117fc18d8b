// SPDX-License-Identifier: MIT
#include "core/gyro_pair.hpp"

#include <algorithm>
#include <cmath>

#include "core/finite.hpp"

namespace fantail::core {
namespace {

// Ten samples with the same three counts are none while the other one turns. At rest, where nothing is lost, a good
// gyro may well say the same so often: its noise is less than a count.
constexpr std::uint32_t most_repeats = 9;
constexpr float share_of_repeats = 0.125F;  // of what they may differ by
// A disturbed transfer spoils one sample, a shock a few.
constexpr Microseconds moment{20'000};
// What two gyros within their data sheets differ by as they turn: scale 1 % each, axes 1 degree off each.
constexpr float share_of_rate = 0.05F;
// The pad window's time at 1 kHz; then it fades at that rate.
constexpr std::uint32_t samples_in_mean = 3'000;

bool same(const Vector3& a, const Vector3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

float largest(const Vector3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

void GyroPair::History::note(Microseconds measured, const Vector3& rate) {
  if (measured == time) {
    return;
  }
  repeats = same(rate, rate_rad_s) ? repeats + 1 : 0;
  time = measured;
  rate_rad_s = rate;
}

// Meets SEN-2.
GyroSample GyroPair::choose(const Inputs& inputs, bool flies, const Vector3& rate_rad_s, const GyroGate& gate) {
  const GyroSample& first = inputs.gyro;
  GyroSample second = inputs.second_gyro.value_or(GyroSample{});
  const Vector3 as_read = second.rate_rad_s;
  second.rate_rad_s = minus(as_read, difference_rad_s_);
  const auto [first_could_be, second_could_be] = could_be(inputs.time, first, second, as_read, rate_rad_s.x, gate);
  if (!first_could_be && !second_could_be) {
    vote_ = GyroVote::neither;
    return {};
  }
  if (!first_could_be || !second_could_be) {
    put_aside(first_could_be ? Doubted::second : Doubted::first);
  } else {
    // On the pad as they read: a difference that grows there is not to be learned away.
    judge(inputs.time, agree(first, flies ? second : GyroSample{second.time, as_read, second.quality}, 1.0F));
  }
  if (doubted_ == Doubted::both) {
    vote_ = GyroVote::disagree;
    return {};
  }
  const bool use_first = is_first_better(first, second, rate_rad_s);
  const bool agreed = doubted_ == Doubted::nobody && !since_;
  if (agreed && !flies) {
    learn_difference(first.rate_rad_s, as_read);
  }
  vote_ = agreed ? GyroVote::both : use_first ? GyroVote::first : GyroVote::second;
  GyroSample chosen = use_first ? first : second;
  // The samples of one may be older than those of the other: what was measured before the last one that was used is
  // no step back.
  chosen.time = std::max(chosen.time, gate.last_time().value_or(chosen.time));
  return chosen;
}

GyroPair::CouldBe GyroPair::could_be(Microseconds now, const GyroSample& first, const GyroSample& second,
                                     const Vector3& as_read, float roll_rate_rad_s, const GyroGate& gate) {
  bool first_could_be = gate.is_usable(now, first, roll_rate_rad_s);
  bool second_could_be = gate.is_usable(now, second, roll_rate_rad_s);
  if (first_could_be) {
    history_[0].note(first.time, first.rate_rad_s);
  }
  if (second_could_be) {
    history_[1].note(second.time, as_read);
  }
  const bool differ_somewhat = doubted_ != Doubted::nobody || !agree(first, second, share_of_repeats);
  if (first_could_be && second_could_be && differ_somewhat) {
    first_could_be = history_[0].repeats < most_repeats || history_[1].repeats > 0;
    second_could_be = history_[1].repeats < most_repeats || history_[0].repeats > 0;
  }
  if (first_could_be && second_could_be) {
    first_could_be = first.time >= second.time - late_;
    second_could_be = second.time >= first.time - late_;
  }
  return {first_could_be, second_could_be};
}

// Of two that could be true and are not both doubted.
bool GyroPair::is_first_better(const GyroSample& first, const GyroSample& second, const Vector3& rate_rad_s) const {
  if (doubted_ != Doubted::nobody) {
    return doubted_ != Doubted::first;
  }
  if (since_) {
    return largest(minus(first.rate_rad_s, rate_rad_s)) <= largest(minus(second.rate_rad_s, rate_rad_s));
  }
  // One that has come to the end of its range has stopped measuring, and agrees with whatever lies beyond.
  return first.quality == SampleQuality::valid || second.quality != SampleQuality::valid;
}

bool GyroPair::agree(const GyroSample& first, const GyroSample& second, float share) const {
  Vector3 a = first.rate_rad_s;
  Vector3 b = second.rate_rad_s;
  // At the end of a range: at least this much.
  if (first.quality == SampleQuality::saturated && std::abs(b.x) > std::abs(a.x)) {
    b.x = std::copysign(a.x, b.x);
  } else if (second.quality == SampleQuality::saturated && std::abs(a.x) > std::abs(b.x)) {
    a.x = std::copysign(b.x, a.x);
  }
  return is_within(minus(a, b), share * (disagreement_rad_s_ + share_of_rate * std::max(largest(a), largest(b))));
}

void GyroPair::put_aside(Doubted who) {
  doubted_ = who;
  since_.reset();
}

void GyroPair::judge(Microseconds now, bool agree) {
  const bool as_believed = agree == (doubted_ == Doubted::nobody);
  if (as_believed) {
    since_.reset();
    return;
  }
  since_ = since_.value_or(now);
  if (now - *since_ >= moment) {
    put_aside(agree ? Doubted::nobody : Doubted::both);
  }
}

void GyroPair::learn_difference(const Vector3& first, const Vector3& second) {
  differences_ = std::min(differences_ + 1, samples_in_mean);
  const float share = 1.0F / static_cast<float>(differences_);
  const Vector3 off = minus(minus(second, first), difference_rad_s_);
  difference_rad_s_ = {difference_rad_s_.x + share * off.x, difference_rad_s_.y + share * off.y,
                       difference_rad_s_.z + share * off.z};
}

}  // namespace fantail::core
