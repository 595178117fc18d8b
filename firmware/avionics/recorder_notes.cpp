// SPDX-License-Identifier: MIT
// What a recorder puts between the ticks.
#include <algorithm>
#include <limits>
#include <utility>

#include "avionics/recorder.hpp"
#include "avionics/write_state.hpp"

namespace fantail::avionics {

using core::Microseconds;
using protocol::LogEventKind;
using protocol::LogRecord;

namespace {

// A whole state in four ticks.
constexpr std::size_t state_part = 450;
constexpr std::uint32_t ticks_per_health = 100;
constexpr Microseconds pause_between_faults{100'000};
// The other half is for events, which do not come again.
constexpr std::uint32_t most_waiting_health = NoteQueue::capacity / 2;

// A sensor that is slower than the ticks coasts between two samples; that is no news.
core::SensorState worth_telling(core::SensorState state) {
  return state == core::SensorState::coasting ? core::SensorState::fresh : state;
}

std::uint16_t at_most_16_bits(std::int64_t value) {
  return static_cast<std::uint16_t>(std::clamp<std::int64_t>(value, 0, std::numeric_limits<std::uint16_t>::max()));
}

void put_times(const protocol::SampleTimes& times, std::span<std::byte> payload) {
  protocol::put<8>(payload, 0, static_cast<std::uint64_t>(times.imu.count()));
  protocol::put<8>(payload, 8, static_cast<std::uint64_t>(times.accelerometer.count()));
}

template <typename Enumeration>
std::uint8_t byte(Enumeration value) {
  return static_cast<std::uint8_t>(value);
}

}  // namespace

void Recorder::queue_changes(const core::TickRecord& record) {
  const std::uint32_t before = queue_.ticks.end();
  const auto tell = [&](auto& told, auto now, protocol::LogEvent event) {
    if (told != now) {
      told = now;
      event.time = record.time;
      event.value = byte(now);
      queue_event(event, before);
    }
  };
  if (record.phase != told_.phase || record.reason != told_.reason) {
    told_.phase = record.phase;
    told_.reason = record.reason;
    queue_event(
        {.time = record.time, .kind = LogEventKind::phase, .value = byte(record.phase), .detail = byte(record.reason)},
        before);
  }
  const bool usual = all_healthy(told_.verdicts) && all_healthy(record.verdicts);
  for (std::size_t i = 0; i < core::canard_count && !usual; ++i) {
    tell(told_.verdicts[i], record.verdicts[i],
         {.kind = LogEventKind::canard_verdict, .index = static_cast<std::uint8_t>(i)});
  }
  tell(told_.gyro, worth_telling(record.motion.gyro), {.kind = LogEventKind::gyro_state});
  tell(told_.gyro_vote, record.gyro_vote.value_or(core::GyroVote::both), {.kind = LogEventKind::gyro_vote});
  tell(told_.barometer, record.barometer_state.value_or(core::BarometerState::on_pad),
       {.kind = LogEventKind::barometer_state});
  tell(told_.accelerometer, worth_telling(record.motion.accelerometer), {.kind = LogEventKind::accelerometer_state});
  tell(told_.command_status, record.command_status, {.kind = LogEventKind::command_status});
}

void Recorder::queue_faults(const Tick& tick) {
  if (tick.record.time >= told_.next_faults) {
    told_.faults = tick.faults;
    told_.next_faults = tick.record.time + pause_between_faults;
    queue_event({.time = tick.record.time, .kind = LogEventKind::board_faults, .number = tick.faults.bits()},
                queue_.ticks.end());
  }
}

void Recorder::queue_health(const Tick& tick) {
  longest_tick_ = std::max(longest_tick_, tick.duration_before);
  longest_queue_ = std::max(longest_queue_, queue_.ticks.size());
  ticks_to_health_ = ticks_to_health_ > 0 ? ticks_to_health_ - 1 : ticks_per_health - 1;
  if (ticks_to_health_ > 0 || queue_.notes.size() >= most_waiting_health) {
    return;
  }
  const hal::CanCounters counters = tick.bus.counters();
  const protocol::LogHealth health{.time = tick.record.time,
                                   .verdicts = tick.record.verdicts,
                                   .gyro = tick.record.motion.gyro,
                                   .accelerometer = tick.record.motion.accelerometer,
                                   .bus_state = byte(tick.bus.state()),
                                   .longest_tick_us = at_most_16_bits(longest_tick_.count()),
                                   .longest_queue = at_most_16_bits(longest_queue_),
                                   .ticks_dropped = ticks_dropped_,
                                   .unsent = counters.unsent,
                                   .bus_errors = counters.errors};
  queue_note(health.time, LogRecord::health, pack(health), queue_.ticks.end());
  longest_tick_ = {};
  longest_queue_ = 0;
  tell_longest_tick(tick);
}

// Only what is longer than all before it, so that a record has a handful.
void Recorder::tell_longest_tick(const Tick& tick) {
  const auto cycles = tick.board != nullptr ? tick.board->take_longest_tick_cycles() : std::nullopt;
  if (cycles && *cycles > longest_tick_cycles_) {
    longest_tick_cycles_ = *cycles;
    queue_event({.time = tick.record.time, .kind = LogEventKind::longest_tick, .number = *cycles}, queue_.ticks.end());
  }
}

// Of the law half a second behind, which has stopped where the record begins.
void Recorder::begin_first_checkpoint() {
  WaitingCheckpoint& checkpoint = queue_.checkpoint;
  put_times(ring_.times(), checkpoint.payload);
  checkpoint.before = queue_.ticks.first();
  checkpoint.in_the_making = true;
  first_checkpoint_made_ = 0;
}

void Recorder::go_on_with_first_checkpoint() {
  WaitingCheckpoint& checkpoint = queue_.checkpoint;
  const std::size_t begin = std::exchange(first_checkpoint_made_, first_checkpoint_made_ + state_part);
  const std::size_t size =
      write_state(ring_.law(), std::span{checkpoint.payload}.subspan(protocol::log_checkpoint_times_size),
                  protocol::StateExtent::whole, {.begin = begin, .size = state_part});
  if (first_checkpoint_made_ >= size) {
    checkpoint.finish(protocol::log_checkpoint_times_size + size);
  }
}

void Recorder::queue_checkpoint(Microseconds time, core::Autopilot& law, protocol::StateExtent extent) {
  WaitingCheckpoint& checkpoint = queue_.checkpoint;
  put_times(times_, checkpoint.payload);
  const std::size_t size =
      write_state(law, std::span{checkpoint.payload}.subspan(protocol::log_checkpoint_times_size), extent);
  checkpoint.before = queue_.ticks.end();
  checkpoint.finish(protocol::log_checkpoint_times_size + size);
  checkpoint_due_ = time + checkpoint_period;
}

void Recorder::tell_what_was_dropped(Microseconds time) {
  if (dropped_ == 0 || queue_.notes.size() == NoteQueue::capacity) {
    return;
  }
  const std::uint32_t lost = std::exchange(dropped_, 0);
  const protocol::LogEvent event{.time = time, .kind = LogEventKind::records_dropped, .number = lost};
  queue_note(time, LogRecord::event, pack(event), queue_.ticks.end(), lost);
}

void Recorder::queue_event(const protocol::LogEvent& event, std::uint32_t before) {
  queue_note(event.time, LogRecord::event, pack(event), before);
}

void Recorder::queue_note(Microseconds time, LogRecord type, std::span<const std::byte> payload, std::uint32_t before,
                          std::uint32_t lost) {
  if (queue_.notes.size() == NoteQueue::capacity) {
    dropped_ += 1;
    return;
  }
  Note note{.time = time, .before = before, .lost = lost, .type = type};
  note.size = static_cast<std::uint8_t>(payload.size());
  std::ranges::copy(payload, note.payload.begin());
  queue_.notes.push(note);
}

}  // namespace fantail::avionics
