// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/flight_plan.hpp"
#include "core/time.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/flash.hpp"
#include "hal/sim/world_side.hpp"
#include "sim/barometer_model.hpp"
#include "sim/canard_set.hpp"
#include "sim/fault.hpp"
#include "sim/flight_computer.hpp"
#include "sim/random.hpp"

namespace fantail::sim {

/// What keeps a sensor from measuring now.
struct ImuFault {
  bool hangs = false;
  bool frozen = false;
  double rate_offset_rad_s = 0.0;
};
struct SensorFaults {
  ImuFault imu{};
  ImuFault second_imu{};
  bool accelerometer_hangs = false;
  BarometerFault barometer{};
};

/// The faults of a run, as they come and go. Servos, and what keeps a sensor from measuring, come before the sensors;
/// all others stand between the devices and the avionics: what the sensors measured, what the servos are told, and the
/// switch are spoilt here on their way.
///
/// Several faults of one device act one after the other, in the scenario's order.
class ActiveFaults {
 public:
  /// What they act upon. Without a wire and a flash (they are somebody else's) those of bus and flash do nothing.
  struct Places {
    hal::sim::WorldSide& hardware;
    FlightComputer& board;
    core::AbortInput abort_input;
    hal::sim::CanWire* wire;
    hal::sim::Flash* flash;
  };

  /// `random` is a stream of its own.
  ActiveFaults(const std::vector<Fault>& faults, Random random);

  /// First in a tick. The reset that begins now, of several the last; null: none.
  const Reset* begin_tick(core::Microseconds since_ignition, CanardSet& canards, SensorFaults& sensors);

  /// Then, when sensors, switch and pad crew have done their part, and before the avionics has its tick. `at` is the
  /// same every time.
  void spoil(const Places& at);

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
    [[nodiscard]] bool begins() const { return there && !was_there; }
  };
  /// What a sensor has measured up to now, the newest last, and what was shown of it last.
  template <typename Sample>
  struct Shown {
    std::deque<Sample> measured{};
    Sample last{};
  };

  void begin(const Fault& fault, const Places& at);
  void follow(const One& one, const Places& at);
  void spoil_pulse(const Fault& fault, const std::optional<hal::Pulse>& before);
  void disturb_bus(const One& one, hal::sim::CanWire& wire);
  [[nodiscard]] hal::CanFrame random_frame();

  // Of samples: spoilt_samples.cpp.
  void spoil_samples(const Fault& fault, hal::sim::WorldSide& hardware);
  template <typename Sample>
  void spoil(Sample& sample, const Shown<Sample>& shown, const How& how);
  void spoil(hal::EncoderSample& own, std::size_t canard, const How& how);
  void spoil(hal::BarometerSample& sample, const How& how);
  void keep_samples(const hal::sim::WorldSide& hardware);
  void note_shown(const hal::sim::WorldSide& hardware);
  [[nodiscard]] std::int16_t random_count();

  std::vector<One> all_;
  bool delays_ = false;   ///< some fault wants what was measured earlier
  bool samples_ = false;  ///< some fault is of a sensor or an encoder
  Random random_;
  Shown<hal::ImuSample> imu_{};
  Shown<hal::ImuSample> second_imu_{};
  Shown<hal::AccelerometerSample> accelerometer_{};
  Shown<hal::EncoderReading> encoders_{};
  hal::BarometerSample last_barometer_{};  ///< as it was shown
  std::deque<Pulses> written_{};
  Pulses heard_{};
  bool switch_stood_closed_ = false;
  bool processor_stands_ = false;
  std::optional<hal::sim::CanBus> intruder_{};
  std::deque<hal::CanFrame> overheard_{};
};

}  // namespace fantail::sim
