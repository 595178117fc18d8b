// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include "sim/device_faults.hpp"

// What a sensor that misbehaves shows instead of what it measured.
namespace fantail::sim {
namespace {

using core::Microseconds;

std::array<hal::Counts*, 2> counts_of(hal::ImuSample& sample) { return {&sample.rate, &sample.specific_force}; }
std::array<hal::Counts*, 1> counts_of(hal::AccelerometerSample& sample) { return {&sample.specific_force}; }

Microseconds delay_of(const Misbehaviour& how) { return Microseconds{std::llround(how.delay_s * 1e6)}; }

/// The newest that had been measured so long ago; empty when none had.
template <typename Sample>
Sample measured_before(const std::deque<Sample>& measured, Microseconds ago) {
  for (auto sample = measured.rbegin(); sample != measured.rend(); ++sample) {
    if (measured.back().time - sample->time >= ago) {
      return *sample;
    }
  }
  return {};
}

}  // namespace

template <typename Sample>
void DeviceFaults::keep(Shown<Sample>& shown, const Sample& sample) const {
  if (!delays_) {
    return;
  }
  shown.measured.push_back(sample);
  if (shown.measured.size() > static_cast<std::size_t>(longest_misbehaviour_delay_s * 1e3) + 1) {
    shown.measured.pop_front();
  }
}

template void DeviceFaults::keep(Shown<hal::ImuSample>& shown, const hal::ImuSample& sample) const;
template void DeviceFaults::keep(Shown<hal::AccelerometerSample>& shown, const hal::AccelerometerSample& sample) const;
template void DeviceFaults::keep(Shown<hal::EncoderReading>& shown, const hal::EncoderReading& sample) const;

template <typename Sample>
void DeviceFaults::spoil(Sample& sample, const Shown<Sample>& shown, const Misbehaviour& how) {
  Sample last = shown.last;
  const auto counts = counts_of(sample);
  const auto last_counts = counts_of(last);
  switch (how.behaviour) {
    case Behaviour::dead: sample = Sample{}; break;
    case Behaviour::repeated: sample = last; break;
    case Behaviour::delayed: sample = measured_before(shown.measured, delay_of(how)); break;
    case Behaviour::stuck:
      for (std::size_t i = 0; i < counts.size(); ++i) {
        *counts[i] = *last_counts[i];
      }
      break;
    case Behaviour::saturated:
      for (hal::Counts* each : counts) {
        (*each)[0] = std::numeric_limits<std::int16_t>::max();
      }
      break;
    case Behaviour::garbage:
      for (hal::Counts* each : counts) {
        *each = {random_count(), random_count(), random_count()};
      }
      break;
    case Behaviour::nan:
      for (hal::Counts* each : counts) {
        *each = hal::no_counts;
      }
      break;
    default: break;  // no sensor has it
  }
}

template void DeviceFaults::spoil(hal::ImuSample& sample, const Shown<hal::ImuSample>& shown, const Misbehaviour& how);
template void DeviceFaults::spoil(hal::AccelerometerSample& sample, const Shown<hal::AccelerometerSample>& shown,
                                  const Misbehaviour& how);

void DeviceFaults::spoil(hal::EncoderReading& reading, std::size_t canard, const Misbehaviour& how) {
  hal::EncoderSample& own = reading.each[canard];
  switch (how.behaviour) {
    case Behaviour::dead: own = {}; break;
    case Behaviour::stuck: own = encoders_.last.each[canard]; break;
    case Behaviour::delayed: own = measured_before(encoders_.measured, delay_of(how)).each[canard]; break;
    case Behaviour::saturated: own.counts = hal::encoder_counts_per_turn - 1; break;
    case Behaviour::nan: own.counts = std::numeric_limits<std::uint16_t>::max(); break;
    case Behaviour::garbage:
      own.counts = static_cast<std::uint16_t>(random_.bits() % hal::encoder_counts_per_turn);
      break;
    default: break;  // no encoder has it
  }
}

std::int16_t DeviceFaults::random_count() { return static_cast<std::int16_t>(random_.bits() >> 48U); }

}  // namespace fantail::sim
