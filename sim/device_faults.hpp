// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/time.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/flash.hpp"
#include "hal/sim/world_side.hpp"
#include "sim/canard_set.hpp"
#include "sim/fault.hpp"
#include "sim/flight_computer.hpp"
#include "sim/random.hpp"

namespace fantail::sim {

/// The faults of a run that are of kind `device`. They stand between the devices and the avionics: what the sensors
/// measured, what the servos are told, and the switch are spoilt here on their way.
///
/// Several faults of one device act one after the other, in the scenario's order.
class DeviceFaults {
 public:
  /// What they act upon. Without a wire and a flash (they are somebody else's) those of bus and flash do nothing.
  struct Places {
    hal::sim::WorldSide& hardware;
    FlightComputer& board;
    CanardSet& canards;
    hal::sim::CanWire* wire;
    hal::sim::Flash* flash;
  };

  /// Takes those of kind `device`. `random` is a stream of its own.
  DeviceFaults(const std::vector<Fault>& faults, Random random);

  /// Once a tick, when sensors, switch and pad crew have done their part, and before the avionics has its tick. `at` is
  /// the same every time.
  void before_tick(core::Microseconds since_ignition, const Places& at);

  /// The processor has no tick now.
  [[nodiscard]] bool processor_stands() const { return processor_stands_; }

  using Pulses = std::array<std::optional<hal::Pulse>, hal::canards>;
  /// What the servos hear of what the avionics wrote; once a tick, after it.
  [[nodiscard]] const Pulses& heard(const Pulses& written);

 private:
  struct One {
    Fault fault;
    bool there = false;      ///< now
    bool was_there = false;  ///< in the tick before
  };
  /// What a sensor has measured up to now, the newest last, and what was shown of it last.
  template <typename Sample>
  struct Shown {
    std::deque<Sample> measured{};
    Sample last{};
  };

  void begin(const One& one, const Places& at);
  void follow(One& one, const Places& at);
  template <typename Sample>
  void keep(Shown<Sample>& shown, const Sample& sample) const;
  template <typename Sample>
  void spoil(Sample& sample, const Shown<Sample>& shown, const Misbehaviour& how);
  void spoil(hal::EncoderReading& reading, std::size_t canard, const Misbehaviour& how);
  void spoil(Pulses& pulses, std::size_t canard, const Misbehaviour& how);
  void fail_servo(const One& one, CanardSet& set) const;
  void disturb_bus(const One& one, hal::sim::CanWire& wire);
  [[nodiscard]] hal::CanFrame random_frame();
  [[nodiscard]] std::int16_t random_count();

  std::vector<One> all_;
  bool delays_ = false;  ///< some fault wants what was measured earlier
  Random random_;
  Shown<hal::ImuSample> imu_{};
  Shown<hal::ImuSample> second_imu_{};
  Shown<hal::AccelerometerSample> accelerometer_{};
  Shown<hal::EncoderReading> encoders_{};
  std::deque<Pulses> written_{};
  Pulses heard_{};
  bool switch_stood_closed_ = false;
  bool processor_stands_ = false;
  std::optional<hal::sim::CanBus> intruder_{};
  std::deque<hal::CanFrame> overheard_{};
};

}  // namespace fantail::sim
