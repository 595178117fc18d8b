// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/tick_record.hpp"
#include "hal/flash.hpp"
#include "hal/sim/world_side.hpp"
#include "sim/active_faults.hpp"
#include "sim/barometer_model.hpp"
#include "sim/canard_set.hpp"
#include "sim/disturbance.hpp"
#include "sim/environment.hpp"
#include "sim/fin_wash.hpp"
#include "sim/flight_computer.hpp"
#include "sim/pad_crew.hpp"
#include "sim/scenario.hpp"
#include "sim/sensor_models.hpp"
#include "sim/vibration.hpp"

namespace fantail::sim {

/// What is really so at one tick; only the world knows.
struct Truth {
  double roll_angle_rad;
  double roll_rate_rad_s;
  double canard_rad;  ///< u_fin as the air answers it: mean of the four, less what stalls and what the fins take back
  double height_m;
  double speed_m_s;        ///< through the air, along the axis
  double disturbance_rad;  ///< equivalent fin offset, swirl included
  /// The roll angle as a camera sees it (Twist), since the pad; in six degrees of freedom only.
  std::optional<double> geometric_roll_rad{};
};

/// One run of one scenario. The world owns time: it fills the simulated hardware, lets the avionics have its tick, and
/// then moves everything to the next millisecond. One thread, fixed order, every random stream seeded by the scenario:
/// the same scenario and seed give the same bytes.
///
///   while (!world.over()) { record = world.tick(); truth = world.truth(); ...; world.advance(); }
class World {
 public:
  /// Too small for any record: for those who do not read it.
  static constexpr hal::FlashGeometry small_flash{.size = 5U << 12U, .sector_size = 4096, .page_size = 256};
  /// As a W25Q64: two minutes. Twice the size would be looked through only after the self-test has begun to wait for
  /// it, and the flash would be seen in the flight.
  static constexpr hal::FlashGeometry large_flash{.size = 8U << 20U, .sector_size = 4096, .page_size = 256};

  /// The scenario outlives the world. Its pad crew arms the avionics and ignites the motor by the scenario's clock.
  explicit World(const Scenario& scenario, const hal::FlashGeometry& flash = small_flash,
                 const MakeFlightComputer& make = simulated_board);

  /// Bus, flash, console and entropy are somebody else's, and so is the pad: nothing happens until set_arm_switch() and
  /// ignite().
  World(const Scenario& scenario, const BoardPorts& ports, const MakeFlightComputer& make = simulated_board);
  ~World();
  World(const World&) = delete;  // the devices point into it
  World& operator=(const World&) = delete;

  /// Sensors, one avionics tick, and what it wrote to the servos. The record is valid until the next tick. While the
  /// processor is down there is no tick, and this is the last record.
  const core::TickRecord& tick();

  /// Was there no avionics to have the last tick()?
  [[nodiscard]] bool is_down() const { return is_held_down() || !hardware_.had_tick; }

  /// The truth that belongs to the last tick.
  [[nodiscard]] Truth truth() const;

  /// Where the rocket is at the last tick, in six degrees of freedom or on a prescribed path; else empty.
  [[nodiscard]] std::optional<Path> path() const { return environment_.path(); }

  [[nodiscard]] bool is_on_ground() const { return environment_.is_on_ground(); }  ///< in flight: pad or ground

  /// How the rocket truly moves at the last tick, at its centre of gravity.
  [[nodiscard]] BodyMotion motion() const { return environment_.motion(roll_, roll_acceleration_rad_s2_); }

  /// What the four canards do to the side, as CanardSet::across_rad.
  [[nodiscard]] Vector3 canards_across_rad() const {
    return canards_.across_rad(roll_.rate_rad_s, environment_.speed_m_s());
  }

  /// Where the four canard shafts truly stand at the last tick, as an encoder without an error would read them.
  [[nodiscard]] std::array<double, hal::canards> shafts_rad() const { return canards_.shafts_rad(); }

  /// What the tunnel's own instruments read at the last tick; empty in flight and between two readings.
  [[nodiscard]] std::optional<WindReading> wind_reading() const;

  /// What the devices showed the avionics in the last tick, and what it wrote to the servos.
  [[nodiscard]] const hal::sim::WorldSide& hardware() const { return hardware_; }

  /// Moves servos, air and rocket through one millisecond.
  void advance();

  void set_arm_switch(bool closed) { hardware_.arm_switch_closed = closed; }

  /// Of the abort input that is wired as the scenario's plan says; one that is not fitted stays open.
  void press_abort(bool pressed) { abort_is_pressed_ = pressed; }

  /// Milliseconds by which this world fell behind a clock outside of it, since power-up: the board tells them on the
  /// bus.
  void set_ticks_left_out(std::uint32_t ticks) { hardware_.board.ticks_left_out = ticks; }

  /// The motor burns from the next millisecond on; in the tunnel nothing happens. Only the first time counts.
  void ignite();

  /// What the avionics answered the world's own pad crew when it would not be armed.
  [[nodiscard]] std::optional<protocol::ArmReply> refusal_to_arm() const;
  /// What it told them meanwhile of its board, a bit for each hal::BoardFault.
  [[nodiscard]] std::uint32_t faults_told_to_crew() const;

  /// Past burn-out and apogee, or past the end of control in the tunnel, by the scenario's time.
  [[nodiscard]] bool over() const { return end_ && now_ >= *end_; }

  /// What the avionics recorded into the world's own flash up to now, to the last whole record: what would be found
  /// there if the power were cut. Empty when nothing was.
  [[nodiscard]] std::span<const std::byte> recorded() const;
  /// The flash was too small for it.
  [[nodiscard]] bool record_is_full() const;

  [[nodiscard]] core::Microseconds now() const { return now_; }

  /// Instants on the world's clock, each that of a tick.
  struct Events {
    std::optional<core::Microseconds> liftoff;  ///< first net upward acceleration; in the tunnel control start
    std::optional<core::Microseconds> guide_clear;
    std::optional<core::Microseconds> burnout;
    std::optional<core::Microseconds> apogee;
    std::optional<core::Microseconds> parachute;  ///< it began to open
  };
  [[nodiscard]] const Events& events() const { return events_; }

  /// A gap in which the processor was down: from the first tick that it missed to the first that it had again.
  struct Gap {
    core::Microseconds from{};
    std::optional<core::Microseconds> to{};
    std::optional<hal::ResetCause> cause{};  ///< empty: ticks went missing without a reset
    bool resumed = false;                    ///< the flight went on after it
  };
  [[nodiscard]] const std::vector<Gap>& gaps() const { return gaps_; }

 private:
  void begin_faults();
  void begin_reset(const Reset& reset);
  void follow_reset();
  void restart_board();
  void put_samples_on_clock_of_board(core::Microseconds ahead);
  [[nodiscard]] bool is_held_down() const {
    return down_until_.has_value() || (faults_ && faults_->processor_stands() && last_record_ != nullptr);
  }
  void note_own_gap();
  void note_resume();
  void spoil_hardware();
  void fill_hardware();
  [[nodiscard]] AirAtPorts air_at_ports() const;
  struct LonePad;
  World(const Scenario& scenario, std::unique_ptr<LonePad> pad, const MakeFlightComputer& make);
  World(const Scenario& scenario, const BoardPorts& ports, std::unique_ptr<LonePad> pad,
        const MakeFlightComputer& make);
  void let_crew_act();
  void follow_events();
  void follow_tunnel();
  void follow_flight();
  void impose_roll();
  [[nodiscard]] double disturbance_now_rad() const;
  [[nodiscard]] bool abort_contact_is_closed() const;
  [[nodiscard]] bool motor_burns() const {
    return scenario_.surroundings == Surroundings::flight && now_ > ignition_ && !events_.burnout;
  }

  const Scenario& scenario_;
  core::Microseconds now_{};
  core::Microseconds ignition_;  ///< in the tunnel: the start command
  bool waits_for_ignition_;
  core::Microseconds time_after_end_;
  core::Microseconds wind_sensor_period_;
  core::Microseconds imposed_roll_after_liftoff_{};
  std::optional<core::Microseconds> end_;
  Events events_;
  std::vector<Gap> gaps_;

  Environment environment_;
  RollPlant roll_plant_;
  Disturbance disturbance_;
  double disturbance_rad_;  ///< at now_
  RollState roll_;
  double roll_acceleration_rad_s2_ = 0.0;
  CanardSet canards_;
  FinWash fin_wash_;
  Vibration vibration_;
  FeltMotion imu_feels_;
  FeltMotion second_imu_feels_;
  FeltMotion accelerometer_feels_;
  ImuModel imu_model_;
  ImuModel second_imu_model_;
  AccelerometerModel accelerometer_model_;
  BarometerModel barometer_model_;
  SensorFaults sensor_faults_;
  bool roll_is_imposed_ = false;
  bool abort_is_pressed_ = false;
  std::optional<core::Microseconds> down_until_{};
  Reset reset_{};                                  ///< the last one
  const core::TickRecord* last_record_ = nullptr;  ///< of the board, which has it until its next tick
  core::Microseconds board_ahead_{};               ///< of now_ is the board's clock; not 0 only after a reset

  std::unique_ptr<LonePad> pad_;        ///< empty when somebody else is there
  std::optional<ActiveFaults> faults_;  ///< empty where there are none; goes before the wire it may be on
  std::string sensors_;                 ///< as the record's header has it; outlives the board
  std::unique_ptr<FlightComputer> board_;
  hal::sim::WorldSide& hardware_;  ///< of the board
  core::Phase phase_ = core::Phase::safe;
};

}  // namespace fantail::sim
