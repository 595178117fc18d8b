// SPDX-License-Identifier: MIT
#include <fantail_lcm/canards_t.hpp>
#include <fantail_lcm/event_t.hpp>
#include <fantail_lcm/health_t.hpp>
#include <fantail_lcm/state_t.hpp>

#include "telemetry/packet.hpp"
#include "telemetry/wire_values.hpp"

namespace fantail::telemetry {
namespace {

using core::CanardVerdict;
using core::CommandStatus;
using core::Phase;
using core::PhaseReason;
using core::SensorState;
using hal::CanState;

// The words of the wire are the enumerators' numbers; these are the highest of each.
static_assert(static_cast<int>(Phase::finished) == fantail_lcm::state_t::PHASE_FINISHED);
static_assert(static_cast<int>(PhaseReason::canard_fault) == fantail_lcm::state_t::REASON_CANARD_FAULT);
static_assert(static_cast<int>(CommandStatus::not_finite) == fantail_lcm::state_t::COMMAND_NOT_FINITE);
static_assert(static_cast<int>(CanardVerdict::disagreeing) == fantail_lcm::canards_t::VERDICT_DISAGREEING);
static_assert(static_cast<int>(SensorState::failed) == fantail_lcm::health_t::SENSOR_FAILED);
static_assert(static_cast<int>(CanState::down) == fantail_lcm::health_t::BUS_DOWN);

// The types have no parts of variable length, so there is one right length, and what was generated reads no further.
template <typename Message>
std::optional<Message> unpacked(std::span<const std::byte> bytes) {
  Message message{};
  const bool whole = bytes.size() == static_cast<std::size_t>(message.getEncodedSize());
  return whole && message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) >= 0 ? std::optional{message}
                                                                                       : std::nullopt;
}

State content(const fantail_lcm::state_t& message, WordReader& words) {
  return {.phase = words.read(message.phase, Phase::finished),
          .reason = words.read(message.reason, PhaseReason::canard_fault),
          .command_status = words.read(message.command_status, CommandStatus::not_finite),
          .timing_fault = words.boolean(message.timing_fault),
          .saturated = words.boolean(message.saturated),
          .roll_angle_rad = from_wire(message.roll_angle_rad),
          .roll_rate_rad_s = from_wire(message.roll_rate_rad_s),
          .reference_rad = from_wire(message.reference_rad),
          .excitation_rad = from_wire(message.excitation_rad),
          .unclamped_command_rad = from_wire(message.unclamped_command_rad),
          .command_rad = from_wire(message.command_rad),
          .specific_force_m_s2 = from_wire(message.specific_force_m_s2),
          .height_m = from_wire(message.height_m),
          .speed_m_s = from_wire(message.speed_m_s),
          .vertical_speed_m_s = from_wire(message.vertical_speed_m_s),
          .tilt_rad = from_wire(message.tilt_rad)};
}

Canards content(const fantail_lcm::canards_t& message, WordReader& words) {
  Canards canards;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    canards.command_rad[i] = from_wire(message.command_rad[i]);
    canards.encoder_rad[i] = from_wire(message.encoder_rad[i]);
    canards.limit_rad[i] = from_wire(message.limit_rad[i]);
    canards.limited[i] = words.boolean(message.limited[i]);
    canards.verdicts[i] = words.read_if_known(message.verdict[i], CanardVerdict::disagreeing);
  }
  canards.canard_rad = from_wire(message.canard_rad);
  return canards;
}

Event content(const fantail_lcm::event_t& message, WordReader& words) {
  Event event;
  if (message.kind == fantail_lcm::event_t::KIND_PHASE) {
    event.phase = Event::PhaseChange{.before = words.read(message.phase_before, Phase::finished),
                                     .phase = words.read(message.phase, Phase::finished),
                                     .reason = words.read(message.reason, PhaseReason::canard_fault)};
  } else if (message.kind == fantail_lcm::event_t::KIND_CANARD && message.canard >= 1 &&
             message.canard <= static_cast<int>(core::canard_count)) {
    event.verdict = Event::VerdictChange{.canard = static_cast<std::size_t>(message.canard - 1),
                                         .before = words.read(message.verdict_before, CanardVerdict::disagreeing),
                                         .verdict = words.read(message.verdict, CanardVerdict::disagreeing)};
  } else {
    words.refuse();
  }
  return event;
}

Health content(const fantail_lcm::health_t& message, WordReader& words) {
  Health health{.gyro = words.read(message.gyro, SensorState::failed),
                .accelerometer = words.read(message.accelerometer, SensorState::failed),
                .verdicts = {},
                .timing_fault = words.boolean(message.timing_fault),
                .longest_tick_s = from_wire(message.longest_tick_s)};
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    health.verdicts[i] = words.read(message.verdict[i], CanardVerdict::disagreeing);
  }
  if (message.late_ticks >= 0) {
    health.late_ticks = message.late_ticks;
  }
  if (const auto state = words.read_if_known(message.bus_state, CanState::down)) {
    health.bus = Health::Bus{
        .state = *state, .unsent = message.bus_unsent, .overrun = message.bus_overrun, .errors = message.bus_errors};
  }
  if (const auto state = words.read_if_known(message.gateway_bus_state, CanState::down)) {
    health.gateway = Health::Gateway{.state = *state,
                                     .frames = message.gateway_frames,
                                     .lost = message.gateway_lost,
                                     .damaged = message.gateway_damaged,
                                     .foreign = message.gateway_foreign,
                                     .overrun = message.gateway_overrun};
  }
  return health;
}

template <typename Message>
std::optional<Decoded> decoded(std::span<const std::byte> bytes) {
  const auto message = unpacked<Message>(bytes);
  if (!message || message->sequence < 0) {
    return std::nullopt;
  }
  WordReader words;
  Decoded result{
      .stamp = {.run = message->run, .sequence = message->sequence, .time = core::Microseconds{message->time_us}},
      .content = content(*message, words)};
  return words.all_known() ? std::optional{result} : std::nullopt;
}

}  // namespace

std::optional<Decoded> decode(Channel channel, std::span<const std::byte> bytes) {
  switch (channel) {
    case Channel::state: return decoded<fantail_lcm::state_t>(bytes);
    case Channel::canards: return decoded<fantail_lcm::canards_t>(bytes);
    case Channel::event: return decoded<fantail_lcm::event_t>(bytes);
    case Channel::health: return decoded<fantail_lcm::health_t>(bytes);
  }
  return std::nullopt;
}

}  // namespace fantail::telemetry
