// SPDX-License-Identifier: MIT
#pragma once

#include "hal/accelerometer.hpp"
#include "hal/barometer.hpp"
#include "hal/board.hpp"
#include "hal/clock.hpp"
#include "hal/contact.hpp"
#include "hal/debounced_contact.hpp"
#include "hal/encoder.hpp"
#include "hal/imu.hpp"
#include "hal/servo.hpp"
#include "hal/sim/world_side.hpp"
#include "hal/watchdog.hpp"

// The avionics' face of the simulated hardware: each device reads what the world put into a WorldSide, or leaves there
// what the world takes out. The WorldSide outlives them.
namespace fantail::hal::sim {

class Clock final : public hal::Clock {
 public:
  explicit Clock(const WorldSide& world) : world_{world} {}
  [[nodiscard]] Microseconds now() const override { return world_.time; }

 private:
  const WorldSide& world_;
};

class Imu final : public hal::Imu {
 public:
  explicit Imu(const WorldSide& world) : world_{world} {}
  ImuSample read() override { return world_.imu; }
  [[nodiscard]] ImuScale scale() const override { return world_.imu_scale; }

 private:
  const WorldSide& world_;
};

/// One that is not fitted is silent.
class SecondImu final : public hal::Imu {
 public:
  explicit SecondImu(const WorldSide& world) : world_{world} {}
  ImuSample read() override { return world_.second_imu_is_fitted ? world_.second_imu : ImuSample{}; }
  [[nodiscard]] ImuScale scale() const override { return world_.second_imu_scale; }

 private:
  const WorldSide& world_;
};

class Accelerometer final : public hal::Accelerometer {
 public:
  explicit Accelerometer(const WorldSide& world) : world_{world} {}
  AccelerometerSample read() override { return world_.accelerometer; }
  [[nodiscard]] float scale() const override { return world_.accelerometer_scale_m_s2; }

 private:
  const WorldSide& world_;
};

/// One that is not fitted is silent.
class Barometer final : public hal::Barometer {
 public:
  explicit Barometer(const WorldSide& world) : world_{world} {}
  BarometerSample read() override { return world_.barometer_is_fitted ? world_.barometer : BarometerSample{}; }

 private:
  const WorldSide& world_;
};

class Servo final : public hal::Servo {
 public:
  explicit Servo(WorldSide& world) : world_{world} {}
  void write(const std::array<std::optional<Pulse>, canards>& pulses) override { world_.pulses = pulses; }

 private:
  WorldSide& world_;
};

class Encoder final : public hal::Encoder {
 public:
  explicit Encoder(const WorldSide& world) : world_{world} {}
  EncoderReading read() override { return world_.encoders; }

 private:
  const WorldSide& world_;
};

/// As on the board: a level of the world, debounced.
class Contact final : public hal::Contact {
 public:
  explicit Contact(const bool& closed_now) : closed_now_{closed_now} {}
  void power_up() { contact_ = {}; }
  /// Once a tick, before the avionics has its own.
  void update() { contact_.update(closed_now_); }
  [[nodiscard]] bool closed() const override { return contact_.closed(); }
  [[nodiscard]] bool open() const override { return contact_.open(); }

 private:
  const bool& closed_now_;
  DebouncedContact contact_;
};

class Watchdog final : public hal::Watchdog {
 public:
  explicit Watchdog(WorldSide& world) : world_{world} {}
  void feed() override { world_.watchdog_fed = world_.time; }

 private:
  WorldSide& world_;
};

class Board final : public hal::Board {
 public:
  explicit Board(WorldSide& world) : world_{world} {}
  [[nodiscard]] BoardStatus status() override { return world_.board; }
  void show(Signal signal) override { world_.shown = signal; }

 private:
  WorldSide& world_;
};

/// All of them, and the world's face of them.
struct Devices {
  WorldSide world;
  Clock clock{world};
  Imu imu{world};
  SecondImu second_imu{world};
  Accelerometer accelerometer{world};
  Barometer barometer{world};
  Servo servo{world};
  Encoder encoder{world};
  Contact arm_switch{world.arm_switch_closed};
  Contact abort_contact{world.abort_contact_closed};
  Watchdog watchdog{world};
  Board board{world};

  Devices() = default;
  Devices(const Devices&) = delete;  // they point into it
  Devices& operator=(const Devices&) = delete;
};

}  // namespace fantail::hal::sim
