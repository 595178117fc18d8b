// SPDX-License-Identifier: MIT
#include "flight_log/event_text.hpp"

#include <fmt/core.h>

#include "flight/phase_names.hpp"
#include "hal/board.hpp"
#include "text/number.hpp"

namespace fantail::flight_log {
namespace {

std::string_view text(protocol::LogEnd end) {
  switch (end) {
    case protocol::LogEnd::flight_over: return "the flight is over";
    case protocol::LogEnd::returned_to_pad:
      return "the flight has ended: the rocket is at rest, or a minute has "
             "passed";
    case protocol::LogEnd::flash_full: return "the flash is full";
    case protocol::LogEnd::flash_failed: return "the flash failed";
  }
  return "unknown";
}

std::string_view text(core::CommandStatus status) {
  switch (status) {
    case core::CommandStatus::outside_control: return "the roll command is zero: outside control";
    case core::CommandStatus::controlling: return "the roll command follows the flight law";
    case core::CommandStatus::gyro_lost: return "the roll command is zero: no usable rate";
    case core::CommandStatus::not_finite:
      return "the roll command is zero: the flight law's result was not a finite number";
  }
  return "unknown";
}

std::string_view text(core::BarometerState state) {
  switch (state) {
    case core::BarometerState::silent: return "the barometer gives no usable pressure";
    case core::BarometerState::on_pad: return "the barometer reads the pressure of the pad";
    case core::BarometerState::used: return "height and vertical speed follow the barometer";
    case core::BarometerState::too_fast: return "the barometer is not used: the rocket is too fast";
    case core::BarometerState::disagrees: return "the barometer is not used: it disagrees with the accelerometer";
    case core::BarometerState::alone: return "the barometer is not used: no accelerometer measures the flight";
  }
  return "unknown";
}

std::string_view text(core::GyroVote vote) {
  switch (vote) {
    case core::GyroVote::both: return "the two gyros agree, and the first is used";
    case core::GyroVote::first: return "the first gyro is used, and the second is rejected";
    case core::GyroVote::second: return "the second gyro is used, and the first is rejected";
    case core::GyroVote::disagree: return "the two gyros disagree, and neither is used";
    case core::GyroVote::neither: return "neither gyro gives a usable rate";
  }
  return "unknown";
}

std::string sensor(std::string_view which, std::uint8_t state) {
  return fmt::format("{} {}", which, name(static_cast<core::SensorState>(state)));
}

std::string board(std::uint32_t bits) {
  std::string text;
  for (std::size_t i = 0; i < hal::board_faults; ++i) {
    if ((bits >> i & 1U) != 0) {
      text += fmt::format("{}{}", text.empty() ? "" : ", ", name(static_cast<hal::BoardFault>(i)));
    }
  }
  // A newer board may have more.
  if (bits >> hal::board_faults != 0) {
    text += text.empty() ? "" : ", ";
    text += fmt::format("unknown {:#x}", bits >> hal::board_faults << hal::board_faults);
  }
  return "board: " + (text.empty() ? "no fault" : text);
}

std::string ordinal(std::uint32_t number) {
  return number == 1 ? "first" : number == 2 ? "second" : number == 3 ? "third" : fmt::format("{}th", number);
}

}  // namespace

std::string event_text(const protocol::LogEvent& event, core::Microseconds log_begins) {
  using Kind = protocol::LogEventKind;
  switch (event.kind) {
    case Kind::recording_began:
      return fmt::format("recording began, in sector {} of the flight memory{}", event.number,
                         static_cast<protocol::LogBegin>(event.value) == protocol::LogBegin::acceleration
                             ? ": specific force beyond recording.threshold_g, before any detection"
                             : "");
    case Kind::recording_ended:
      return fmt::format("recording ended: {}", text(static_cast<protocol::LogEnd>(event.value)));
    case Kind::phase:
      return fmt::format("{}: {}", flight::display_name(static_cast<core::Phase>(event.value)),
                         flight::why_it_began(static_cast<core::PhaseReason>(event.detail), event.time <= log_begins));
    case Kind::canard_verdict:
      return fmt::format("canard {} {}", event.index + 1, name(static_cast<core::CanardVerdict>(event.value)));
    case Kind::gyro_state: return sensor("gyro", event.value);
    case Kind::accelerometer_state: return sensor("accelerometer", event.value);
    case Kind::command_status: return std::string{text(static_cast<core::CommandStatus>(event.value))};
    case Kind::records_dropped:
      return text::counted(event.number, "record was", "records were") + " not written, because the flash was too slow";
    case Kind::barometer_state: return std::string{text(static_cast<core::BarometerState>(event.value))};
    case Kind::gyro_vote: return std::string{text(static_cast<core::GyroVote>(event.value))};
    case Kind::longest_tick: return fmt::format("longest tick so far: {} cycles of the processor", event.number);
    case Kind::board_faults: return board(event.number);
    case Kind::resumed:
      return fmt::format("the flight was resumed after a reset ({}), for the {} time",
                         name(static_cast<protocol::ResumedAfter>(event.value)), ordinal(event.number));
  }
  return "unknown";
}

}  // namespace fantail::flight_log
