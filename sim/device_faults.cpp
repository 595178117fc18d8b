// SPDX-License-Identifier: MIT
#include "sim/device_faults.hpp"

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
  if (since_ignition < from || since_ignition >= nearest_tick(fault.until_s)) {
    return false;
  }
  const Microseconds on = nearest_tick(fault.misbehaviour.on_s);
  const Microseconds off = nearest_tick(fault.misbehaviour.off_s);
  return on == Microseconds{0} || (since_ignition - from) % (on + off) < on;
}

ServoFault gear_fault(Behaviour behaviour) {
  switch (behaviour) {
    case Behaviour::stuck: return ServoFault::stuck;
    case Behaviour::saturated: return ServoFault::hardover;
    case Behaviour::slow: return ServoFault::slow;
    default: return ServoFault::none;  // of the pulses
  }
}

}  // namespace

DeviceFaults::DeviceFaults(const std::vector<Fault>& faults, Random random) : random_{random} {
  for (const Fault& fault : faults) {
    if (is_of_device(fault.kind)) {
      all_.push_back({.fault = fault});
      delays_ = delays_ || fault.misbehaviour.behaviour == Behaviour::delayed;
    }
  }
}

void DeviceFaults::before_tick(Microseconds since_ignition, const Places& at) {
  hal::sim::WorldSide& hardware = at.hardware;
  keep(imu_, hardware.imu);
  keep(second_imu_, hardware.second_imu);
  keep(accelerometer_, hardware.accelerometer);
  keep(encoders_, hardware.encoders);
  processor_stands_ = false;
  for (One& one : all_) {
    one.was_there = one.there;
    one.there = is_there(one.fault, since_ignition);
    if (one.there && !one.was_there) {
      begin(one, at);
    }
    if (one.there || one.was_there) {
      follow(one, at);
    }
  }
  imu_.last = hardware.imu;
  second_imu_.last = hardware.second_imu;
  accelerometer_.last = hardware.accelerometer;
  encoders_.last = hardware.encoders;
}

void DeviceFaults::begin(const One& one, const Places& at) {
  switch (one.fault.misbehaviour.behaviour) {
    case Behaviour::law_bit_flipped: at.board.flip_bit(MemoryPart::flight_law, random_.bits()); break;
    case Behaviour::plan_bit_flipped: at.board.flip_bit(MemoryPart::plan, random_.bits()); break;
    default: break;
  }
  if (one.fault.misbehaviour.device == Device::arm_switch) {
    switch_stood_closed_ = at.hardware.arm_switch_closed;
  }
}

// Of one that has just gone, `there` is false: what it left behind is put right.
void DeviceFaults::follow(One& one, const Places& at) {
  hal::sim::WorldSide& hardware = at.hardware;
  const Misbehaviour& how = one.fault.misbehaviour;
  switch (how.device) {
    case Device::imu:
      if (one.there) {
        spoil(hardware.imu, imu_, how);
      }
      break;
    case Device::second_imu:
      if (one.there) {
        spoil(hardware.second_imu, second_imu_, how);
      }
      break;
    case Device::accelerometer:
      if (one.there) {
        spoil(hardware.accelerometer, accelerometer_, how);
      }
      break;
    case Device::encoder:
      if (one.there) {
        spoil(hardware.encoders, one.fault.canard, how);
      }
      break;
    case Device::servo: fail_servo(one, at.canards); break;
    case Device::bus:
      if (at.wire != nullptr) {
        disturb_bus(one, *at.wire);
      }
      break;
    case Device::flash:
      if (at.flash != nullptr && how.behaviour == Behaviour::stuck) {
        at.flash->set_stays_busy(one.there);
      } else if (at.flash != nullptr) {
        at.flash->set_answers(!one.there);
      }
      break;
    case Device::supply:
      if (one.there) {
        hardware.board.faults.add(hal::BoardFault::supply_low);
      } else {
        hardware.board.faults = {};  // of a simulated board there is no other
      }
      break;
    case Device::arm_switch:
      if (one.there) {
        hardware.arm_switch_closed = how.behaviour == Behaviour::stuck && switch_stood_closed_;
      }
      break;
    case Device::memory: break;
    case Device::processor: processor_stands_ = processor_stands_ || one.there; break;
  }
}

// The pulses that reach a servo are spoilt in heard().
void DeviceFaults::fail_servo(const One& one, CanardSet& set) const {
  const ServoFault gear = gear_fault(one.fault.misbehaviour.behaviour);
  if (gear != ServoFault::none && one.there != one.was_there) {
    set.fail(one.fault.canard, one.there ? gear : ServoFault::none);
  }
}

const DeviceFaults::Pulses& DeviceFaults::heard(const Pulses& written) {
  if (delays_) {
    written_.push_back(written);
    if (written_.size() > static_cast<std::size_t>(longest_misbehaviour_delay_s * 1e3) + 1) {
      written_.pop_front();
    }
  }
  const Pulses before = heard_;
  heard_ = written;
  for (const One& one : all_) {
    if (one.there && one.fault.misbehaviour.device == Device::servo) {
      std::optional<hal::Pulse>& pulse = heard_[one.fault.canard];
      if (one.fault.misbehaviour.behaviour == Behaviour::repeated) {
        pulse = before[one.fault.canard];
      } else {
        spoil(heard_, one.fault.canard, one.fault.misbehaviour);
      }
    }
  }
  return heard_;
}

void DeviceFaults::spoil(Pulses& pulses, std::size_t canard, const Misbehaviour& how) {
  constexpr double shortest_ns = 500e3;
  constexpr double longest_ns = 2500e3;
  std::optional<hal::Pulse>& pulse = pulses[canard];
  switch (how.behaviour) {
    case Behaviour::dead: pulse.reset(); break;
    case Behaviour::nan: pulse = hal::Pulse{0}; break;
    case Behaviour::garbage:
      pulse = hal::Pulse{static_cast<std::int32_t>(shortest_ns + (longest_ns - shortest_ns) * random_.uniform())};
      break;
    case Behaviour::cut:
      if (pulse) {
        pulse = hal::Pulse{static_cast<std::int32_t>(random_.uniform() * static_cast<double>(pulse->count()))};
      }
      break;
    case Behaviour::delayed: {
      const auto late = static_cast<std::size_t>(std::llround(how.delay_s * 1e3));
      pulse = late < written_.size() ? written_[written_.size() - 1 - late][canard] : std::nullopt;
      break;
    }
    default: break;  // of the gear
  }
}

void DeviceFaults::disturb_bus(const One& one, hal::sim::CanWire& wire) {
  const Behaviour how = one.fault.misbehaviour.behaviour;
  if (how == Behaviour::dead) {
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
  if (how == Behaviour::garbage) {
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

hal::CanFrame DeviceFaults::random_frame() {
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
