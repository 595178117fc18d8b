// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "avionics/avionics.hpp"
#include "avionics/pc_on_bus.hpp"
#include "core/flight_plan_fields.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/sim/devices.hpp"
#include "hal/sim/flash.hpp"

namespace fantail::avionics {

using hal::Microseconds;
using Pulses = std::array<std::optional<hal::Pulse>, hal::canards>;

inline constexpr float counts_per_g = 1000.0F;
inline constexpr Microseconds millisecond{1'000};
inline constexpr Microseconds second{1'000'000};

// The devices of which a test wants to know more than the world does.
struct CountedServo final : hal::Servo {
  Pulses written{};
  int writes = 0;
  hal::Servo* driver = nullptr;  ///< a real one behind it, where a test has one
  void write(const Pulses& pulses) override {
    written = pulses;
    writes += 1;
    if (driver != nullptr) {
      driver->write(pulses);
    }
  }
};
struct CountedWatchdog final : hal::Watchdog {
  int fed = 0;
  void feed() override { fed += 1; }
};
struct ReadConsole final : hal::Console {
  std::string text;
  void write(std::string_view words) override { text += words; }
};
struct SetEntropy final : hal::Entropy {
  std::uint32_t number = 0;
  std::uint32_t draw() override { return number; }
};

/// Without bounces, and so without a debouncer.
struct DirectSwitch final : hal::Contact {
  explicit DirectSwitch(const bool& closed_now) : closed_now_{closed_now} {}
  const bool& closed_now_;
  [[nodiscard]] bool closed() const override { return closed_now_; }
  [[nodiscard]] bool open() const override { return !closed_now_; }
};

/// The avionics on a table: still, upright, with canards that stand where their pulses send them after a first-order
/// lag of 20 ms, and a PC on the bus. Pulses mean what the default plan says: 1500 us and 10 us a degree.
class BoardRig {
 public:
  explicit BoardRig(const core::FlightPlan& plan = core::default_plan()) : plan_{plan} {
    hardware.imu_scale = {.rate_rad_s = 0.001F, .specific_force_m_s2 = 9.80665F / counts_per_g};
    hardware.second_imu_scale = hardware.imu_scale;
    hardware.accelerometer_scale_m_s2 = 9.80665F / counts_per_g;
    hardware.imu.specific_force = hardware.accelerometer.specific_force = {1000, 0, 0};
    hardware.imu.status = hardware.second_imu.status = hardware.accelerometer.status = hal::Status::ok;
    power_cycle();
  }

  /// The flash keeps what it has; everything else begins anew, with the switch as it stands.
  void power_cycle() {
    hardware.time = {};
    reset_processor();
  }

  /// Clock, flash and backup memory keep what they have.
  void reset_processor() {
    avionics_.reset();
    servo.written = {};
    avionics_.emplace(Devices{devices_.clock, devices_.imu, devices_.accelerometer, servo, devices_.encoder,
                              arm_switch_, abort_contact_, board_bus_, flash, console, watchdog, entropy,
                              devices_.board, backup_memory, &devices_.second_imu},
                      plan_);
  }

  const core::TickRecord& tick() {
    hardware.time += millisecond;
    if (sensors_work) {
      hardware.imu.time = hardware.second_imu.time = hardware.accelerometer.time = hardware.time;
    }
    hardware.encoders.time = hardware.time;
    for (std::size_t i = 0; i < hal::canards; ++i) {
      move_canard(i);
    }
    const core::TickRecord& record = avionics_->tick();
    pc.listen();
    return record;
  }

  /// Ticks, the bench's heartbeat included when it has a session.
  const core::TickRecord* run(Microseconds duration) {
    const core::TickRecord* record = nullptr;
    for (Microseconds elapsed{}; elapsed < duration; elapsed += millisecond) {
      if (heartbeat && hardware.time.count() % 20'000 == 0) {
        pc.say(protocol::BenchSession{.action = protocol::SessionAction::keep, .session = *heartbeat});
      }
      record = &tick();
    }
    return record;
  }

  [[nodiscard]] Avionics& avionics() { return *avionics_; }

  [[nodiscard]] int rejected(protocol::Rejection cause) {
    run(second);  // they are reported once a second
    return pc.heard<protocol::RejectionReport>()->count[static_cast<std::size_t>(cause)];
  }

  /// Stands still until a session may be opened, opens one and keeps it with `run`.
  void open_session(std::uint16_t session = 7) {
    run(3 * second);
    pc.say(protocol::BenchSession{.action = protocol::SessionAction::open, .session = session});
    heartbeat = session;
    tick();
  }

  /// Tested, and the switch closed: only the command is missing.
  void make_ready() {
    pc.say(protocol::ArmAction::self_test);
    run(8 * second);
    hardware.arm_switch_closed = true;
    tick();
  }

  /// The first step of the command; empty when it was refused.
  [[nodiscard]] std::optional<std::uint32_t> begin_arming() {
    make_ready();
    pc.say(protocol::ArmAction::begin);
    tick();
    return pc.heard<protocol::ArmReply>()->nonce;
  }

  /// Self-test, switch and both steps of the command.
  const core::TickRecord& arm() {
    armed_with = begin_arming().value_or(0);
    pc.say(protocol::ArmAction::confirm, armed_with);
    return tick();
  }

  [[nodiscard]] double commanded_deg(std::size_t canard) const {
    return static_cast<double>(servo.written[canard].value().count() - 1'500'000) / 10'000.0;
  }
  [[nodiscard]] bool all_pulses_are(double degrees, double tolerance_deg = 0.01) const {
    for (std::size_t i = 0; i < hal::canards; ++i) {
      if (!servo.written[i] || std::abs(commanded_deg(i) - degrees) > tolerance_deg) {
        return false;
      }
    }
    return true;
  }

 private:
  hal::sim::Devices devices_;

 public:
  hal::sim::WorldSide& hardware{devices_.world};
  CountedServo servo;
  CountedWatchdog watchdog;
  ReadConsole console;
  SetEntropy entropy;
  hal::sim::BackupMemory backup_memory;
  hal::sim::Flash flash{{.size = 1U << 18U, .sector_size = 4096, .page_size = 256}};
  hal::sim::CanWire wire;

 private:
  hal::sim::CanBus board_bus_{wire};  // of the two nodes the first
  DirectSwitch arm_switch_{hardware.arm_switch_closed};
  DirectSwitch abort_contact_{hardware.abort_contact_closed};

 public:
  PcOnBus pc{wire};

  bool sensors_work = true;
  std::array<bool, hal::canards> jammed{};
  std::array<bool, hal::canards> unplugged{};
  std::array<std::size_t, hal::canards> driven_by{0, 1, 2, 3};  ///< which output each servo is plugged into
  std::array<double, hal::canards> shaft_deg{};
  std::array<double, hal::canards> horn_off_deg{};
  std::optional<std::uint16_t> heartbeat;
  std::uint32_t armed_with = 0;  ///< the nonce

 private:
  void move_canard(std::size_t i) {
    const auto& pulse = servo.written[driven_by[i]];
    if (pulse && !jammed[i]) {
      shaft_deg[i] += (commanded_deg(driven_by[i]) - shaft_deg[i]) / 20.0;
    }
    // Positive first, because the conversion rounds towards zero.
    const double counts = (shaft_deg[i] + horn_off_deg[i] + 360.0) * 16384.0 / 360.0 + 0.5;
    hardware.encoders.each[i] = {.counts = static_cast<std::uint16_t>(static_cast<std::uint32_t>(counts) % 16384U),
                                 .status = unplugged[i] ? hal::Status::no_reading : hal::Status::ok};
  }

  core::FlightPlan plan_;
  std::optional<Avionics> avionics_;
};

}  // namespace fantail::avionics
