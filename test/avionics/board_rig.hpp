// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "avionics/avionics.hpp"
#include "avionics/can_frame.hpp"
#include "core/flight_plan_fields.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/sim/can_bus.hpp"
#include "hal/sim/flash.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::avionics {

using hal::Microseconds;
using Pulses = std::array<std::optional<hal::Pulse>, hal::canards>;

inline constexpr float counts_per_g = 1000.0F;
inline constexpr Microseconds millisecond{1'000};
inline constexpr Microseconds second{1'000'000};

struct FakeClock final : hal::Clock {
  Microseconds time{};
  [[nodiscard]] Microseconds now() const override { return time; }
};
struct FakeImu final : hal::Imu {
  hal::ImuSample sample{.time = {}, .rate = {}, .specific_force = {1000, 0, 0}, .status = hal::Status::ok};
  hal::ImuSample read() override { return sample; }
  [[nodiscard]] hal::ImuScale scale() const override { return {0.001F, 9.80665F / counts_per_g}; }
};
struct FakeAccelerometer final : hal::Accelerometer {
  hal::AccelerometerSample sample{.time = {}, .specific_force = {1000, 0, 0}, .status = hal::Status::ok};
  hal::AccelerometerSample read() override { return sample; }
  [[nodiscard]] float scale() const override { return 9.80665F / counts_per_g; }
};
struct FakeServo final : hal::Servo {
  Pulses written{};
  int writes = 0;
  void write(const Pulses& pulses) override {
    written = pulses;
    writes += 1;
  }
};
struct FakeEncoder final : hal::Encoder {
  hal::EncoderReading reading{};
  hal::EncoderReading read() override { return reading; }
};
struct FakeArmSwitch final : hal::ArmSwitch {
  bool is_closed = false;
  [[nodiscard]] bool closed() const override { return is_closed; }
};
struct FakeConsole final : hal::Console {
  std::string text;
  void write(std::string_view words) override { text += words; }
};
struct FakeEntropy final : hal::Entropy {
  std::uint32_t number = 0;
  std::uint32_t draw() override { return number; }
};
struct FakeBoard final : hal::Board {
  hal::BoardStatus now{};
  hal::Signal shown = hal::Signal::safe;
  hal::BoardStatus status() override { return now; }
  void show(hal::Signal signal) override { shown = signal; }
};
struct FakeWatchdog final : hal::Watchdog {
  int fed = 0;
  void feed() override { fed += 1; }
};

/// The avionics on a table: fakes for its devices, canards that stand where their pulses send them after a first-order
/// lag of 20 ms, and a PC on the bus. Pulses mean what the default plan says: 1500 us and 10 us a degree.
class BoardRig {
 public:
  explicit BoardRig(const core::FlightPlan& plan = core::default_plan()) : plan_{plan} { power_cycle(); }

  /// The flash keeps what it has; everything else begins anew, with the switch as it stands.
  void power_cycle() {
    clock.time = {};
    reset_processor();
  }

  /// Clock, flash and backup memory keep what they have.
  void reset_processor() {
    avionics_.reset();
    servo.written = {};
    avionics_.emplace(Devices{clock, imu, accelerometer, servo, encoder, arm_switch, board_bus, flash, console,
                              watchdog, entropy, board, backup_memory},
                      plan_);
  }

  const core::TickRecord& tick() {
    clock.time += millisecond;
    if (sensors_work) {
      imu.sample.time = accelerometer.sample.time = clock.time;
    }
    for (std::size_t i = 0; i < hal::canards; ++i) {
      const auto& pulse = servo.written[driven_by[i]];
      if (pulse && !jammed[i]) {
        const double wanted_deg = static_cast<double>(pulse->count() - 1'500'000) / 10'000.0;
        shaft_deg[i] += (wanted_deg - shaft_deg[i]) / 20.0;
      }
      // Positive first, because the conversion rounds towards zero.
      const double counts = (shaft_deg[i] + horn_off_deg[i] + 360.0) * 16384.0 / 360.0 + 0.5;
      encoder.reading.each[i] = {.counts = static_cast<std::uint16_t>(static_cast<std::uint32_t>(counts) % 16384U),
                                 .status = unplugged[i] ? hal::Status::no_reading : hal::Status::ok};
    }
    encoder.reading.time = clock.time;
    const core::TickRecord& record = avionics_->tick();
    hear();
    return record;
  }

  /// Ticks, the bench's heartbeat included when it has a session.
  const core::TickRecord* run(Microseconds duration) {
    const core::TickRecord* record = nullptr;
    for (Microseconds elapsed{}; elapsed < duration; elapsed += millisecond) {
      if (heartbeat && clock.time.count() % 20'000 == 0) {
        say(protocol::BenchSession{.action = protocol::SessionAction::keep, .session = *heartbeat});
      }
      record = &tick();
    }
    return record;
  }

  [[nodiscard]] Avionics& avionics() { return *avionics_; }

  // ---- the PC ----

  void send(const protocol::BusFrame& frame) { (void)pc_bus.send(can_frame(frame)); }
  void say(const protocol::BenchRequest& message) { send(encode(message, counters_[0].next())); }
  void say(const protocol::BenchSession& message) { send(encode(message, counters_[1].next())); }
  void say(const protocol::ArmRequest& message) { send(encode(message, counters_[2].next())); }
  void say(const protocol::PlanBegin& message) { send(encode(message, counters_[3].next())); }
  void say(const protocol::PlanData& message) { send(encode(message)); }
  void say(protocol::ArmAction action, std::uint32_t nonce = 0) {
    say(protocol::ArmRequest{.action = action, .nonce = nonce});
  }

  /// The newest message of a kind since power-up.
  template <typename Message>
  [[nodiscard]] const std::optional<Message>& heard() const {
    return std::get<std::optional<Message>>(heard_);
  }
  template <typename Message>
  [[nodiscard]] int count() const {
    return counts_[protocol::FromAvionics{Message{}}.index()];
  }
  [[nodiscard]] int rejected(protocol::Rejection cause) {
    run(second);  // they are reported once a second
    return heard<protocol::RejectionReport>()->count[static_cast<std::size_t>(cause)];
  }

  /// Stands still until a session may be opened, opens one and keeps it with `run`.
  void open_session(std::uint16_t session = 7) {
    run(3 * second);
    say(protocol::BenchSession{.action = protocol::SessionAction::open, .session = session});
    heartbeat = session;
    tick();
  }

  /// Tested, and the switch closed: only the command is missing.
  void make_ready() {
    say(protocol::ArmAction::self_test);
    run(8 * second);
    arm_switch.is_closed = true;
    tick();
  }

  /// The first step of the command; empty when it was refused.
  [[nodiscard]] std::optional<std::uint32_t> begin_arming() {
    make_ready();
    say(protocol::ArmAction::begin);
    tick();
    return heard<protocol::ArmReply>()->nonce;
  }

  /// Self-test, switch and both steps of the command.
  const core::TickRecord& arm() {
    armed_with = begin_arming().value_or(0);
    say(protocol::ArmAction::confirm, armed_with);
    return tick();
  }

  [[nodiscard]] bool all_pulses_are(double degrees, double tolerance_deg = 0.01) const {
    for (const auto& pulse : servo.written) {
      const double off_ns = pulse ? static_cast<double>(pulse->count()) - (1'500'000.0 + 10'000.0 * degrees) : 1e9;
      if (off_ns > 10'000.0 * tolerance_deg || off_ns < -10'000.0 * tolerance_deg) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] double commanded_deg(std::size_t canard) const {
    return static_cast<double>(servo.written[canard].value().count() - 1'500'000) / 10'000.0;
  }

  FakeClock clock;
  FakeImu imu;
  FakeAccelerometer accelerometer;
  FakeServo servo;
  FakeEncoder encoder;
  FakeArmSwitch arm_switch;
  FakeConsole console;
  FakeWatchdog watchdog;
  FakeEntropy entropy;
  FakeBoard board;
  hal::sim::BackupMemory backup_memory;
  hal::sim::Flash flash{{.size = 1U << 18U, .sector_size = 4096, .page_size = 256}};
  hal::sim::CanWire wire;
  hal::sim::CanBus board_bus{wire};
  hal::sim::CanBus pc_bus{wire};

  bool sensors_work = true;
  std::array<bool, hal::canards> jammed{};
  std::array<bool, hal::canards> unplugged{};
  std::array<std::size_t, hal::canards> driven_by{0, 1, 2, 3};  ///< which output each servo is plugged into
  std::array<double, hal::canards> shaft_deg{};
  std::array<double, hal::canards> horn_off_deg{};
  std::optional<std::uint16_t> heartbeat;
  std::uint32_t armed_with = 0;  ///< the nonce

 private:
  void hear() {
    while (const auto frame = pc_bus.receive()) {
      const auto decoded = protocol::decode_from_avionics(bus_frame(*frame));
      if (decoded.message) {
        counts_[decoded.message->index()] += 1;
        std::visit(
            [this](const auto& message) { std::get<std::optional<std::decay_t<decltype(message)>>>(heard_) = message; },
            *decoded.message);
      }
    }
  }

  template <typename... Messages>
  static std::tuple<std::optional<Messages>...> one_of_each(const std::variant<Messages...>&);

  core::FlightPlan plan_;
  std::optional<Avionics> avionics_;
  std::array<protocol::FrameCounter, 4> counters_{};
  decltype(one_of_each(protocol::FromAvionics{})) heard_{};
  std::array<int, std::variant_size_v<protocol::FromAvionics>> counts_{};
};

}  // namespace fantail::avionics
