// SPDX-License-Identifier: MIT
#include "sim/active_faults.hpp"

#include <algorithm>
#include <cmath>

#include "sim/nearest_tick.hpp"

namespace fantail::sim {
namespace {

using core::Microseconds;

// At 1 Mbit/s a bus carries nine frames in a millisecond. The avionics reads at most 24: more than that is what a
// broken driver would make of the bus.
constexpr std::size_t frames_on_bus = 9;
constexpr std::size_t frames_of_garbage = 30;
constexpr std::size_t overheard_frames = 64;

bool is_there(const Fault& fault, Microseconds since_ignition) {
  const Microseconds from = nearest_tick(fault.from_s);
  if (since_ignition < from || (fault.until_s && since_ignition >= nearest_tick(*fault.until_s))) {
    return false;
  }
  const Microseconds on = nearest_tick(fault.on_s);
  return on == Microseconds{0} || (since_ignition - from) % (on + nearest_tick(fault.off_s)) < on;
}

void keep_from_measuring(const Fault& fault, BarometerFault& barometer) {
  barometer.hangs = barometer.hangs || is(fault, Behaviour::hangs);
  barometer.blocked = barometer.blocked || is(fault, Behaviour::blocked);
  barometer.lit = barometer.lit || is(fault, Behaviour::lit);
}

void keep_from_measuring(const Fault& fault, SensorFaults& sensors) {
  if (fault.device == Device::barometer) {
    keep_from_measuring(fault, sensors.barometer);
    return;
  }
  ImuFault& imu = fault.device == Device::second_imu ? sensors.second_imu : sensors.imu;
  if (const auto* offset = std::get_if<RateOffset>(&fault.how)) {
    imu.rate_offset_rad_s += offset->rate_rad_s;
  } else if (is(fault, Behaviour::gyro_frozen)) {
    imu.frozen = true;
  } else if (is(fault, Behaviour::hangs)) {
    (fault.device == Device::accelerometer ? sensors.accelerometer_hangs : imu.hangs) = true;
  }
}

}  // namespace

ActiveFaults::ActiveFaults(const std::vector<Fault>& faults, Random random) : random_{random} {
  for (const Fault& fault : faults) {
    all_.push_back({.fault = fault});
    delays_ = delays_ || std::holds_alternative<Delayed>(fault.how);
    samples_ = samples_ || fault.device <= Device::encoder || fault.device == Device::barometer;
  }
}

const Reset* ActiveFaults::begin_tick(Microseconds since_ignition, CanardSet& canards, SensorFaults& sensors) {
  const Reset* reset = nullptr;
  sensors = {};
  for (One& one : all_) {
    const Fault& fault = one.fault;
    one.was_there = one.there;
    one.there = is_there(fault, since_ignition);
    if (one.there) {
      keep_from_measuring(fault, sensors);
    }
    if (const auto* gear = std::get_if<GearFault>(&fault.how); gear != nullptr && one.there != one.was_there) {
      canards.fail(fault.canard, one.there ? gear->fault : ServoFault::none,
                   one.there ? gear->angle_rad : std::nullopt);
    } else if (const auto* noisy = std::get_if<Noisy>(&fault.how); noisy != nullptr && one.begins()) {
      canards.make_encoder_noisy(fault.canard, noisy->noise_counts);
    } else if (const auto* begun = std::get_if<Reset>(&fault.how); begun != nullptr && one.begins()) {
      reset = begun;
    }
  }
  return reset;
}

void ActiveFaults::spoil(const Places& at) {
  if (delays_) {
    keep_samples(at.hardware);
  }
  processor_stands_ = false;
  for (const One& one : all_) {
    if (one.begins()) {
      begin(one.fault, at);
    }
    if (one.there || one.was_there) {
      follow(one, at);
    }
  }
  if (samples_) {
    note_shown(at.hardware);
  }
}

void ActiveFaults::begin(const Fault& fault, const Places& at) {
  if (is(fault, Behaviour::law_bit_flipped)) {
    at.board.flip_bit(MemoryPart::flight_law, random_.bits());
  } else if (is(fault, Behaviour::plan_bit_flipped)) {
    at.board.flip_bit(MemoryPart::plan, random_.bits());
  } else if (fault.device == Device::arm_switch) {
    switch_stood_closed_ = at.hardware.arm_switch_closed;
  }
}

// Of one that has just gone, `there` is false: what it left behind is put right.
void ActiveFaults::follow(const One& one, const Places& at) {
  hal::sim::WorldSide& hardware = at.hardware;
  const Fault& fault = one.fault;
  if (one.there) {
    spoil_samples(fault, hardware);
  }
  if (fault.device == Device::bus && at.wire != nullptr) {
    disturb_bus(one, *at.wire);
  } else if (fault.device == Device::flash && at.flash != nullptr) {
    if (is(fault, Behaviour::stuck)) {
      at.flash->set_stays_busy(one.there);
    } else {
      at.flash->set_answers(!one.there);
    }
  } else if (fault.device == Device::supply) {
    if (one.there) {
      hardware.board.faults.add(hal::BoardFault::supply_low);
    } else {
      hardware.board.faults = {};  // of a simulated board there is no other
    }
  } else if (fault.device == Device::arm_switch && one.there) {
    hardware.arm_switch_closed = is(fault, Behaviour::stuck) && switch_stood_closed_;
  } else if (fault.device == Device::abort_input && one.there) {
    hardware.abort_contact_closed = is(fault, Behaviour::pressed) && at.abort_input == core::AbortInput::closed_aborts;
  } else if (fault.device == Device::processor && is(fault, Behaviour::dead)) {
    processor_stands_ = processor_stands_ || one.there;
  }
}

const ActiveFaults::Pulses& ActiveFaults::heard(const Pulses& written) {
  if (delays_) {
    written_.push_back(written);
    if (written_.size() > static_cast<std::size_t>(Delayed::longest_s * 1e3) + 1) {
      written_.pop_front();
    }
  }
  const Pulses before = heard_;
  heard_ = written;
  for (const One& one : all_) {
    if (one.there && one.fault.device == Device::servo) {
      spoil_pulse(one.fault, before[one.fault.canard]);
    }
  }
  return heard_;
}

// `before`: what the servo heard last.
void ActiveFaults::spoil_pulse(const Fault& fault, const std::optional<hal::Pulse>& before) {
  constexpr double shortest_ns = 500e3;
  constexpr double longest_ns = 2500e3;
  std::optional<hal::Pulse>& pulse = heard_[fault.canard];
  if (const auto* delayed = std::get_if<Delayed>(&fault.how)) {
    const auto late = static_cast<std::size_t>(std::llround(delayed->delay_s * 1e3));
    pulse = late < written_.size() ? written_[written_.size() - 1 - late][fault.canard] : std::nullopt;
  } else if (is(fault, Behaviour::dead)) {
    pulse.reset();
  } else if (is(fault, Behaviour::repeated)) {
    pulse = before;
  } else if (is(fault, Behaviour::nan)) {
    pulse = hal::Pulse{0};
  } else if (is(fault, Behaviour::garbage)) {
    pulse = hal::Pulse{static_cast<std::int32_t>(shortest_ns + (longest_ns - shortest_ns) * random_.uniform())};
  } else if (is(fault, Behaviour::cut) && pulse) {
    pulse = hal::Pulse{static_cast<std::int32_t>(random_.uniform() * static_cast<double>(pulse->count()))};
  }
}

void ActiveFaults::disturb_bus(const One& one, hal::sim::CanWire& wire) {
  if (is(one.fault, Behaviour::dead)) {
    wire.set_state(one.there ? hal::CanState::down : hal::CanState::error_active);
    return;
  }
  if (!intruder_) {
    intruder_.emplace(wire);
  }
  while (const auto frame = intruder_->receive()) {
    overheard_.push_back(*frame);
    if (overheard_.size() > overheard_frames) {
      overheard_.pop_front();
    }
  }
  if (!one.there) {
    return;
  }
  if (is(one.fault, Behaviour::garbage)) {
    for (std::size_t i = 0; i < frames_of_garbage; ++i) {
      (void)intruder_->send(random_frame());
    }
    return;
  }
  for (std::size_t i = 0; i < std::min(frames_on_bus, overheard_.size()); ++i) {
    (void)intruder_->send(overheard_.front());
    overheard_.push_back(overheard_.front());
    overheard_.pop_front();
  }
}

hal::CanFrame ActiveFaults::random_frame() {
  constexpr std::uint32_t identifiers = 0x800;
  const std::uint64_t content = random_.bits();
  const std::uint64_t head = random_.bits();
  hal::CanFrame frame{.id = static_cast<std::uint32_t>(head % identifiers),
                      .length = static_cast<std::uint8_t>((head >> 32U) % 9)};
  for (std::size_t i = 0; i < frame.data.size(); ++i) {
    frame.data[i] = static_cast<std::uint8_t>(content >> (8 * i));
  }
  return frame;
}

}  // namespace fantail::sim
