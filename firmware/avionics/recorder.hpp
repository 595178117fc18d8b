// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flight_region.hpp"
#include "avionics/identity.hpp"
#include "avionics/log_tick_of.hpp"
#include "avionics/pad_ring.hpp"
#include "avionics/record_queue.hpp"
#include "avionics/record_stream.hpp"
#include "core/autopilot.hpp"
#include "core/flight_plan.hpp"
#include "hal/board.hpp"
#include "hal/can_bus.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/plan_block.hpp"
#include "protocol/state_block.hpp"

namespace fantail::avionics {

/// Records a flight, from half a second before its launch was detected (in the tunnel: before control) until it has
/// been over for half a minute or the flash is full. On the pad nothing is written: an armed rocket, or one that has
/// stood still in Safe, keeps its last half second in memory.
///
/// A launch that nobody detects is recorded too, because that is the flight somebody will want to understand: one
/// accelerometer beyond the plan's recording threshold for 50 ms, in any direction, begins a record. In Safe that may
/// be somebody who handles the rocket: three such records since power-up, and no more. A record outside a flight ends
/// when the rocket is at rest again, or after a minute.
///
/// It never waits for the flash. Ticks that come while the queue is full are counted and left out, and with a
/// checkpoint the record goes on where there is room again: with a flash of 85 kB/s (W25Q128 at its slowest) that does
/// not happen.
///
/// Time in a tick, at worst: one tick packed and summed up, one of half a second ago flown again (armed only), one
/// state of the flight law written out (once a second; the first, which is larger, in four ticks), 256 bytes framed
/// with their CRC, and one program of the flash begun.
class Recorder {
 public:
  /// The region outlives this object.
  explicit Recorder(FlightRegion& region) : region_{region} {}
  Recorder(const Recorder&) = delete;  // its stream refers to its queue
  Recorder& operator=(const Recorder&) = delete;

  struct Tick {
    const RawSamples& raw;
    const SampleScales& scales;
    const core::Inputs& inputs;  ///< made of them
    const core::TickRecord& record;
    core::Microseconds duration_before{};  ///< of the tick before
    const hal::CanBus& bus;
    std::optional<std::uint32_t> power_up{};
    hal::Board* board = nullptr;  ///< which may know the cycles of the longest tick
    hal::BoardFaults faults{};    ///< its own, and what the avionics found
  };

  /// In Safe, while nothing is busy().
  void take_plan(const core::FlightPlan& plan);
  /// Of the plan that was taken, for whoever asks.
  [[nodiscard]] std::span<const std::byte> plan_block() const { return plan_block_; }
  void introduce(const Identity& identity) { identity_ = identity; }

  struct Resume {
    protocol::ResumedAfter cause{};
    std::uint32_t resumes = 0;  ///< of this flight, this one included
  };
  /// The rocket flies already: a record begins as soon as the flash can take one, with what the law then remembers.
  void resume_flight(const Resume& resume) { resumed_ = resume; }

  /// The law has another state than it stepped to, as no replay can know: it wants to be written down.
  void restate() { checkpoint_due_.reset(); }

  /// Once a tick, when the flight law has stepped: `law` is what it is now. No call to the flash.
  void note(const Tick& tick, core::Autopilot& law);

  /// Once a tick while busy() and the flash is free: at most one call to it.
  void update(core::Microseconds now);

  /// Something is being written.
  [[nodiscard]] bool busy() const { return stream_.open(); }
  /// Since power-up.
  [[nodiscard]] std::uint32_t ticks_dropped() const { return ticks_dropped_; }

 private:
  static constexpr core::Microseconds checkpoint_period{1'000'000};

  enum class Stage : std::uint8_t { idle, on_pad, flying, closing };
  /// What the events have told so far.
  struct Told {
    core::Phase phase = core::Phase::armed;
    core::PhaseReason reason = core::PhaseReason::power_on;
    core::CanardVerdicts verdicts{};
    core::SensorState gyro = core::SensorState::fresh;
    core::SensorState accelerometer = core::SensorState::fresh;
    core::GyroVote gyro_vote = core::GyroVote::both;
    core::BarometerState barometer = core::BarometerState::on_pad;
    core::CommandStatus command_status = core::CommandStatus::outside_control;
    hal::BoardFaults faults{};
    core::Microseconds next_faults{};  ///< not before: a plug that comes and goes does not fill the record
  };

  [[nodiscard]] bool may_wait(const Tick& tick) const;
  [[nodiscard]] bool is_pushed(const core::Inputs& inputs);
  [[gnu::cold]] void begin_on_pad(const Tick& tick, core::Autopilot& law);
  void wait_on_pad(const Tick& tick, core::Autopilot& law);
  [[gnu::cold]] void begin_flight(const Tick& tick, protocol::LogBegin why);
  void fly_on(const Tick& tick, core::Autopilot& law);
  [[nodiscard]] std::optional<protocol::LogEnd> reason_to_end(const Tick& tick);

  // `before`: number of the tick that follows.
  void queue_tick(const Tick& tick);
  void queue_changes(const core::TickRecord& record);
  [[gnu::cold]] void queue_faults(const Tick& tick);
  [[gnu::cold]] void tell_longest_tick(const Tick& tick);
  void queue_health(const Tick& tick);
  void begin_first_checkpoint();
  void go_on_with_first_checkpoint();
  void queue_checkpoint(core::Microseconds time, core::Autopilot& law, protocol::StateExtent extent);
  void tell_what_was_dropped(core::Microseconds time);
  void queue_event(const protocol::LogEvent& event, std::uint32_t before);
  void queue_note(core::Microseconds time, protocol::LogRecord type, std::span<const std::byte> payload,
                  std::uint32_t before, std::uint32_t lost = 0);

  FlightRegion& region_;
  Identity identity_{};
  core::CanardsPlan canards_{};
  bool has_barometer_ = false;  ///< by the plan
  std::array<std::byte, protocol::plan_block_size> plan_block_{};

  Stage stage_ = Stage::idle;
  RecordQueue queue_{};
  RecordStream stream_{queue_, region_};
  PadRing ring_{};
  protocol::SampleTimes times_{};  ///< of the newest tick
  Told told_{};
  std::uint32_t state_layout_ = 0;
  std::size_t first_checkpoint_made_ = 0;  ///< bytes of its state
  std::uint32_t ticks_to_health_ = 0;
  std::optional<core::Microseconds> checkpoint_due_{};  ///< empty: one is wanted now
  std::optional<core::Microseconds> over_since_{};      ///< Finished, or in no flight
  core::Microseconds rest_time_{};
  float threshold_m_s2_ = 0.0F;
  std::uint8_t pushed_ticks_ = 0;
  std::uint8_t records_in_safe_ = 0;
  std::optional<Resume> resumed_{};  ///< and no record has begun since
  bool overflowed_ = false;          ///< no tick is taken until there is room again
  std::uint32_t dropped_ = 0;        ///< records, since that was last said
  std::uint32_t ticks_dropped_ = 0;
  core::Microseconds longest_tick_{};
  std::uint32_t longest_tick_cycles_ = 0;  ///< of this record, as told
  std::uint32_t longest_queue_ = 0;
};

}  // namespace fantail::avionics
