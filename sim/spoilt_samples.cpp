// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sim/active_faults.hpp"

// What a sensor shows instead of what it measured.
namespace fantail::sim {
namespace {

using core::Microseconds;

std::array<hal::Counts*, 2> counts_of(hal::ImuSample& sample) { return {&sample.rate, &sample.specific_force}; }
std::array<hal::Counts*, 1> counts_of(hal::AccelerometerSample& sample) { return {&sample.specific_force}; }

/// The newest that had been measured so long ago; empty when none had.
template <typename Sample>
Sample measured_before(const std::deque<Sample>& measured, const Delayed& late) {
  const Microseconds ago{std::llround(late.delay_s * 1e6)};
  for (auto sample = measured.rbegin(); sample != measured.rend(); ++sample) {
    if (measured.back().time - sample->time >= ago) {
      return *sample;
    }
  }
  return {};
}

}  // namespace

void ActiveFaults::keep_samples(const hal::sim::WorldSide& hardware) {
  const auto keep = [](auto& shown, const auto& sample) {
    shown.measured.push_back(sample);
    if (shown.measured.size() > static_cast<std::size_t>(Delayed::longest_s * 1e3) + 1) {
      shown.measured.pop_front();
    }
  };
  keep(imu_, hardware.imu);
  keep(second_imu_, hardware.second_imu);
  keep(accelerometer_, hardware.accelerometer);
  keep(encoders_, hardware.encoders);
}

void ActiveFaults::note_shown(const hal::sim::WorldSide& hardware) {
  imu_.last = hardware.imu;
  second_imu_.last = hardware.second_imu;
  accelerometer_.last = hardware.accelerometer;
  encoders_.last = hardware.encoders;
  last_barometer_ = hardware.barometer;
}

void ActiveFaults::spoil_samples(const Fault& fault, hal::sim::WorldSide& hardware) {
  switch (fault.device) {
    case Device::imu: spoil(hardware.imu, imu_, fault.how); break;
    case Device::second_imu: spoil(hardware.second_imu, second_imu_, fault.how); break;
    case Device::accelerometer: spoil(hardware.accelerometer, accelerometer_, fault.how); break;
    case Device::encoder: spoil(hardware.encoders.each[fault.canard], fault.canard, fault.how); break;
    case Device::barometer: spoil(hardware.barometer, fault.how); break;
    default: break;  // has no samples
  }
}

template <typename Sample>
void ActiveFaults::spoil(Sample& sample, const Shown<Sample>& shown, const How& how) {
  if (const auto* late = std::get_if<Delayed>(&how)) {
    sample = measured_before(shown.measured, *late);
  }
  const auto* behaviour = std::get_if<Behaviour>(&how);
  if (behaviour == nullptr) {
    return;
  }
  Sample last = shown.last;
  const auto counts = counts_of(sample);
  const auto last_counts = counts_of(last);
  switch (*behaviour) {
    case Behaviour::dead: sample = Sample{}; break;
    case Behaviour::repeated: sample = last; break;
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
    default: break;  // keeps it from measuring, or no sensor has it
  }
}

void ActiveFaults::spoil(hal::EncoderSample& own, std::size_t canard, const How& how) {
  if (const auto* late = std::get_if<Delayed>(&how)) {
    own = measured_before(encoders_.measured, *late).each[canard];
  }
  const auto* behaviour = std::get_if<Behaviour>(&how);
  if (behaviour == nullptr) {
    return;
  }
  switch (*behaviour) {
    case Behaviour::dead: own = {}; break;
    case Behaviour::stuck: own = encoders_.last.each[canard]; break;
    case Behaviour::saturated: own.counts = hal::encoder_counts_per_turn - 1; break;
    case Behaviour::nan: own.counts = std::numeric_limits<std::uint16_t>::max(); break;
    case Behaviour::garbage:
      own.counts = static_cast<std::uint16_t>(random_.bits() % hal::encoder_counts_per_turn);
      break;
    default: break;  // no encoder has it
  }
}

// Its samples come again and again for 10 ms, and what is wrong with one stays with it.
void ActiveFaults::spoil(hal::BarometerSample& sample, const How& how) {
  constexpr double lowest_pa = 30'000.0;  // what such a device can measure
  constexpr double highest_pa = 110'000.0;
  const auto* behaviour = std::get_if<Behaviour>(&how);
  if (behaviour == nullptr) {
    return;
  }
  switch (*behaviour) {
    case Behaviour::dead: sample = {}; break;
    case Behaviour::stuck: sample.pressure_pa = last_barometer_.pressure_pa; break;
    case Behaviour::garbage:
      sample.pressure_pa = sample.time == last_barometer_.time
                               ? last_barometer_.pressure_pa
                               : static_cast<std::uint32_t>(lowest_pa + (highest_pa - lowest_pa) * random_.uniform());
      break;
    default: break;  // keeps it from measuring, or no barometer has it
  }
}

std::int16_t ActiveFaults::random_count() { return static_cast<std::int16_t>(random_.bits() >> 48U); }

}  // namespace fantail::sim
