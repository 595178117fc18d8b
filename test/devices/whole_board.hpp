// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "avionics/avionics.hpp"
#include "avionics/pc_on_bus.hpp"
#include "core/flight_plan_fields.hpp"
#include "fake_as5047p.hpp"
#include "fake_capture.hpp"
#include "fake_icm42688.hpp"
#include "fake_kx134.hpp"
#include "fake_timer.hpp"
#include "fake_w25q.hpp"
#include "hal/sim/backup_memory.hpp"
#include "hal/stm32f4/accelerometer.hpp"
#include "hal/stm32f4/as5047p.hpp"
#include "hal/stm32f4/battery.hpp"
#include "hal/stm32f4/board.hpp"
#include "hal/stm32f4/buzzer.hpp"
#include "hal/stm32f4/contact.hpp"
#include "hal/stm32f4/encoder.hpp"
#include "hal/stm32f4/entropy.hpp"
#include "hal/stm32f4/flash.hpp"
#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/imu.hpp"
#include "hal/stm32f4/kx134.hpp"
#include "hal/stm32f4/servo.hpp"
#include "hal/stm32f4/w25q.hpp"
#include "wire_fault.hpp"

namespace fantail::devices {

namespace stm32 = hal::stm32f4;
namespace fake = hal::stm32f4::test;
using hal::Microseconds;

struct CountedWatchdog final : hal::Watchdog {
  std::int64_t fed = 0;
  void feed() override { fed += 1; }
};
struct DeafConsole final : hal::Console {
  void write(std::string_view) override {}
};

/// The avionics over the drivers of the board, each on a device that behaves as its data sheet says, in a rocket that
/// rolls by its canards. Only the CAN controller, the backup memory and the watchdog are simulated ones, without a
/// driver.
///
/// The rocket: 6 g for three seconds, a roll moment of fins that stand askew, and canards that brake and turn it.
class WholeBoard {
 public:
  WholeBoard();
  WholeBoard(const WholeBoard&) = delete;  // everything points into it
  WholeBoard& operator=(const WholeBoard&) = delete;

  /// A millisecond of the world, and the tick at its end. The first is that of the power-up.
  const core::TickRecord& tick();
  const core::TickRecord& run(int milliseconds);
  /// From now on it burns.
  void ignite() { lit_ = clock_.time; }
  void set_switch(bool closed) { switch_closed_ = closed; }
  /// Self-test, switch, and both steps of the command, as long as nothing refuses.
  void try_to_arm();

  [[nodiscard]] const core::TickRecord& record() const { return *record_; }
  /// What is said of it on the bus: the faults of the board, the verdicts on its canards, and whether the flash has
  /// failed, since forget_faults().
  [[nodiscard]] std::string faults() const;
  void forget_faults();
  /// Why the self-test failed, or else why it was not armed.
  [[nodiscard]] std::string refusal() const;
  /// Of the rocket, since the launch was detected.
  [[nodiscard]] double roll_deg() const;
  /// How far that of the avionics is from it.
  [[nodiscard]] double roll_error_deg() const;
  /// Of all four pulses, from 1500 us; the largest since forget_pulses(), and those of the last frame.
  [[nodiscard]] double largest_deflection_deg() const { return largest_deg_; }
  [[nodiscard]] double last_deflection_deg() const { return last_deg_; }
  void forget_pulses() { largest_deg_ = 0.0; }
  [[nodiscard]] std::int64_t ticks() const { return ticks_; }
  [[nodiscard]] bool every_tick_was_completed() const { return watchdog.fed == ticks_; }

 private:
  fake::RegisterWorld world_{};
  fake::FakeClock clock_{};
  fake::FakePort port_a_{world_}, port_b_{world_}, port_c_{world_};
  static constexpr std::uint32_t apb1_hz = 42'000'000, apb2_hz = 84'000'000, timers_hz = 168'000'000;
  fake::FakeSpi spi_1_{world_, apb2_hz}, spi_2_{world_, apb1_hz}, spi_3_{world_, apb1_hz};

 public:
  fake::FakeIcm42688 imu_device{clock_};
  fake::FakeKx134 accelerometer_device{clock_};
  std::array<fake::FakeAs5047p, hal::canards> encoder_devices{};
  fake::FakeW25q flash_device{clock_};
  WireFault imu_wire{imu_device, 1};
  WireFault accelerometer_wire{accelerometer_device, 2};
  std::array<WireFault, hal::canards> encoder_wires{WireFault{encoder_devices[0], 3}, WireFault{encoder_devices[1], 4},
                                                    WireFault{encoder_devices[2], 5}, WireFault{encoder_devices[3], 6}};
  WireFault flash_wire{flash_device, 7};
  bool imu_line_is_on = true;
  bool battery_answers = true;
  bool imu_line_storms = false;  ///< thousands of edges, the last one just now
  bool switch_wire_is_off = false;
  bool switch_is_stuck = false;  ///< as it stands
  bool switch_chatters = false;
  std::array<std::size_t, hal::canards> driven_by{0, 1, 2, 3};  ///< which output each servo is plugged into
  std::array<bool, hal::canards> servo_dead{};                  ///< where it was blown to: its centre
  std::array<bool, hal::canards> servo_jammed{};
  std::array<double, hal::canards> servo_lag_ms{20.0, 20.0, 20.0, 20.0};
  std::array<std::size_t, hal::canards> encoder_of{0, 1, 2, 3};  ///< which shaft each encoder sees
  hal::sim::CanWire can{};
  CountedWatchdog watchdog{};

 private:
  void power_up();
  void move_canards();
  void move_rocket();
  void look_at_faults();
  [[nodiscard]] bool switch_level();
  std::optional<fake::LineEdge> data_ready_edge();

  hal::sim::CanBus can_bus_{can};
  avionics::PcOnBus pc_{can};
  fake::FakeTimer servo_timer_{world_};
  fake::FakeCapture capture_{world_, clock_, 84e6, [this] { return data_ready_edge(); }};
  stm32::registers::Tim buzzer_timer_{};
  stm32::registers::Adc converter_{};
  stm32::registers::AdcCommon converter_common_{};
  stm32::registers::Rng rng_{};
  stm32::registers::Dwt dwt_{};
  stm32::registers::CoreDebug debug_{};
  std::uint32_t random_number_ = 1;
  bool numbers_come_ = [this] {  // before the driver asks for one
    world_.on_read(rng_.sr, [] { return 1U; });
    world_.on_read(rng_.dr, [this] { return random_number_ += 7; });
    world_.on_read(converter_.sr, [this] { return battery_answers ? 2U : 0U; });
    world_.on_read(converter_.dr, [] { return 2500U; });
    return true;
  }();

  stm32::SpiBus bus_1_{spi_1_.block(), apb2_hz}, bus_2_{spi_2_.block(), apb1_hz}, bus_3_{spi_3_.block(), apb1_hz};
  stm32::Battery battery_{converter_, converter_common_, {.channel = 12, .reference_mv = 3300, .divider = 11}};
  stm32::Entropy entropy_{rng_};
  stm32::Buzzer buzzer_{buzzer_timer_, timers_hz, 2'700};
  stm32::CycleCounter cycles_{dwt_, debug_};
  stm32::Board board_{{.light = stm32::Pin{port_b_.block(), 2},
                       .buzzer = buzzer_,
                       .battery = battery_,
                       .entropy = entropy_,
                       .cycles = cycles_},
                      hal::ResetCause::power_on};
  stm32::Contact arm_switch_{stm32::Pin{port_c_.block(), 3}, stm32::ClosedLevel::high};
  stm32::Contact abort_contact_{stm32::Pin{port_c_.block(), 1}, stm32::ClosedLevel::low};
  stm32::Servo servo_{servo_timer_.registers, timers_hz};
  stm32::Imu imu_{{bus_1_, stm32::Pin{port_a_.block(), 4}, stm32::icm42688::spi},
                  clock_,
                  stm32::EdgeTimer{capture_.registers, 84'000'000}};
  stm32::Accelerometer accelerometer_{{bus_3_, stm32::Pin{port_c_.block(), 4}, stm32::kx134::spi}, clock_};
  stm32::Encoder encoder_{{stm32::SpiDevice{bus_2_, stm32::Pin{port_b_.block(), 12}, stm32::as5047p::spi},
                           stm32::SpiDevice{bus_2_, stm32::Pin{port_b_.block(), 0}, stm32::as5047p::spi},
                           stm32::SpiDevice{bus_2_, stm32::Pin{port_b_.block(), 1}, stm32::as5047p::spi},
                           stm32::SpiDevice{bus_2_, stm32::Pin{port_c_.block(), 5}, stm32::as5047p::spi}},
                          clock_};
  stm32::Flash flash_{{bus_3_, stm32::Pin{port_a_.block(), 15}, stm32::w25q::spi}, clock_};
  hal::sim::BackupMemory backup_memory_{};
  DeafConsole console_{};
  std::optional<avionics::Avionics> avionics_;

  std::mt19937 random_{11};
  std::array<double, hal::canards> shaft_deg_{};
  double rate_rad_s_ = 0.0;
  double angle_rad_ = 0.0;
  std::optional<double> zero_rad_{};
  std::optional<Microseconds> lit_{};
  bool switch_closed_ = false;
  bool last_level_ = false;
  std::int64_t stormy_edges_ = 1'000'000'000;
  const core::TickRecord* record_ = nullptr;
  hal::BoardFaults seen_{};
  core::CanardVerdicts verdicts_{};
  bool flash_failed_ = false;
  double largest_deg_ = 0.0;
  double last_deg_ = 0.0;
  std::int64_t ticks_ = 0;
};

}  // namespace fantail::devices
