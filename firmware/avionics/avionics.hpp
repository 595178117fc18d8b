// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "avionics/arming.hpp"
#include "avionics/bench_mode.hpp"
#include "avionics/board_watch.hpp"
#include "avionics/bus_receiver.hpp"
#include "avionics/flash_service.hpp"
#include "avionics/flight_memory.hpp"
#include "avionics/identity.hpp"
#include "avionics/log_tick_of.hpp"
#include "avionics/memory_watch.hpp"
#include "avionics/mounting.hpp"
#include "avionics/self_test.hpp"
#include "avionics/situation.hpp"
#include "avionics/telemetry.hpp"
#include "core/autopilot.hpp"
#include "core/flight_plan.hpp"
#include "hal/accelerometer.hpp"
#include "hal/backup_memory.hpp"
#include "hal/barometer.hpp"
#include "hal/board.hpp"
#include "hal/can_bus.hpp"
#include "hal/clock.hpp"
#include "hal/console.hpp"
#include "hal/contact.hpp"
#include "hal/encoder.hpp"
#include "hal/entropy.hpp"
#include "hal/flash.hpp"
#include "hal/imu.hpp"
#include "hal/servo.hpp"
#include "hal/watchdog.hpp"

namespace fantail::avionics {

/// The devices of one rocket, whichever backend they come from.
struct Devices {
  hal::Clock& clock;
  hal::Imu& imu;
  hal::Accelerometer& accelerometer;
  hal::Servo& servo;
  hal::Encoder& encoder;
  hal::Contact& arm_switch;
  hal::Contact& abort_contact;  ///< of no use where the plan says that none is fitted
  hal::CanBus& can_bus;
  hal::Flash& flash;
  hal::Console& console;
  hal::Watchdog& watchdog;
  hal::Entropy& entropy;
  hal::Board& board;
  hal::BackupMemory& backup_memory;
  hal::Imu* second_imu = nullptr;       ///< null where none can be fitted; read only where the plan asks for two gyros
  hal::Barometer* barometer = nullptr;  ///< null where none can be fitted; read only where the plan asks for one
};

/// The application: reads the hardware layer, steps the autopilot, writes the hardware layer. A board's or a world's
/// main calls tick() every millisecond and does nothing else; whoever wants something of it says so on the bus.
class Avionics {
 public:
  /// `built_in` has passed core::validate(); a good plan in the flash goes before it. The devices outlive this object.
  [[gnu::cold]] Avionics(Devices devices, const core::FlightPlan& built_in, const Identity& identity = {});

  /// One control tick. The record is valid until the next one.
  const core::TickRecord& tick();

  /// Where the plan in force has its canards when nothing is asked of them: for a board that gives up.
  [[nodiscard, gnu::cold]] std::array<std::optional<hal::Pulse>, hal::canards> pulses_at_trim() const;

 private:
  void look_for_new_plan();
  [[gnu::cold]] void resume_flight(const core::Inputs& first);
  [[gnu::cold]] void adopt(const core::FlightPlan& plan);
  [[gnu::cold]] void mend_memory(const core::Inputs& next);
  void listen(core::Microseconds now);
  void obey(const protocol::BenchSession& message);
  void obey(const protocol::BenchRequest& message);
  [[gnu::cold]] void obey(const protocol::ArmRequest& message);
  [[nodiscard, gnu::cold]] std::optional<hal::ImuSample> read_second_imu();
  [[nodiscard, gnu::cold]] std::optional<hal::BarometerSample> read_barometer(core::Microseconds now);
  [[nodiscard]] core::Inputs read_devices(core::Microseconds now);
  void follow(const core::TickRecord& record, const core::Inputs& inputs, const FlashFacts& flash);
  void watch_board(const core::TickRecord& record, const FlashFacts& flash);
  void report(const core::TickRecord& record, const core::Inputs& inputs);
  void tell_person(const core::TickRecord& record);
  [[nodiscard]] bool plan_may_change() const;
  [[nodiscard]] LogTransfer::Right right_to_log() const;

  Devices devices_;
  FlashService flash_;
  FlightMemory flight_memory_;
  bool flash_was_read_ = false;
  core::FlightPlan plan_;
  std::uint32_t plan_crc_ = 0;
  std::optional<core::Autopilot> autopilot_;  ///< never empty; a new plan makes a new one
  MemoryWatch memory_watch_;
  bool memory_was_damaged_ = false;  ///< since power-up
  /// No copy of it is left: the trims are unknown. A word that no single bit makes, because it takes all pulses away.
  [[nodiscard]] bool plan_is_lost() const { return lost_plan_ == plan_lost; }
  static constexpr std::uint32_t plan_lost = 0x9E37'79B9;
  static_assert(std::popcount(plan_lost) > 1);
  std::uint32_t lost_plan_ = 0;
  BusReceiver receiver_;
  BenchMode bench_mode_;
  SelfTest self_test_;
  Arming arming_;
  BoardWatch board_watch_;
  bool board_is_news_ = false;
  Telemetry telemetry_;
  Situation situation_{};
  RawSamples raw_{};
  SampleScales scales_{};
  core::Microseconds pressure_time_{};  ///< of the last one
  core::Microseconds tick_duration_{};
};

}  // namespace fantail::avionics
