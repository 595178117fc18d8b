// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <fantail_lcm/canards_t.hpp>
#include <fantail_lcm/event_t.hpp>
#include <fantail_lcm/health_t.hpp>
#include <fantail_lcm/state_t.hpp>

#include "telemetry/packet.hpp"
#include "telemetry/wire_values.hpp"

namespace fantail::telemetry {
namespace {

template <typename Message>
Message stamped(const Stamp& stamp) {
  Message message{};
  message.run = stamp.run;
  message.sequence = stamp.sequence;
  message.time_us = stamp.time.count();
  return message;
}

template <typename Message>
Packet packed(Channel channel, const Stamp& stamp, const Message& message) {
  Packet packet{.channel = channel, .time = stamp.time};
  const int size = message.encode(packet.bytes.data(), 0, static_cast<int>(packet.bytes.size()));
  if (size < 0) {
    throw std::logic_error{"a telemetry message is longer than a packet"};
  }
  packet.size = static_cast<std::size_t>(size);
  return packet;
}

}  // namespace

Packet encode(const Stamp& stamp, const State& state) {
  auto message = stamped<fantail_lcm::state_t>(stamp);
  message.phase = word(state.phase);
  message.reason = word(state.reason);
  message.command_status = word(state.command_status);
  message.timing_fault = word(state.timing_fault);
  message.saturated = word(state.saturated);
  message.roll_angle_rad = to_wire(state.roll_angle_rad);
  message.roll_rate_rad_s = to_wire(state.roll_rate_rad_s);
  message.reference_rad = to_wire(state.reference_rad);
  message.excitation_rad = to_wire(state.excitation_rad);
  message.unclamped_command_rad = to_wire(state.unclamped_command_rad);
  message.command_rad = to_wire(state.command_rad);
  message.specific_force_m_s2 = to_wire(state.specific_force_m_s2);
  message.height_m = to_wire(state.height_m);
  message.speed_m_s = to_wire(state.speed_m_s);
  message.vertical_speed_m_s = to_wire(state.vertical_speed_m_s);
  message.tilt_rad = to_wire(state.tilt_rad);
  return packed(Channel::state, stamp, message);
}

Packet encode(const Stamp& stamp, const Canards& canards) {
  auto message = stamped<fantail_lcm::canards_t>(stamp);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    message.command_rad[i] = to_wire(canards.command_rad[i]);
    message.encoder_rad[i] = to_wire(canards.encoder_rad[i]);
    message.limit_rad[i] = to_wire(canards.limit_rad[i]);
    message.limited[i] = word(canards.limited[i]);
    message.verdict[i] = canards.verdicts[i] ? word(*canards.verdicts[i]) : word(unknown_number);
  }
  message.canard_rad = to_wire(canards.canard_rad);
  return packed(Channel::canards, stamp, message);
}

Packet encode(const Stamp& stamp, const Event& event) {
  auto message = stamped<fantail_lcm::event_t>(stamp);
  message.phase_before = message.phase = message.reason = word(unknown_number);
  message.canard = message.verdict_before = message.verdict = word(unknown_number);
  if (event.phase) {
    message.kind = fantail_lcm::event_t::KIND_PHASE;
    message.phase_before = word(event.phase->before);
    message.phase = word(event.phase->phase);
    message.reason = word(event.phase->reason);
  } else if (event.verdict) {
    message.kind = fantail_lcm::event_t::KIND_CANARD;
    message.canard = static_cast<std::int8_t>(event.verdict->canard + 1);
    message.verdict_before = word(event.verdict->before);
    message.verdict = word(event.verdict->verdict);
  }
  return packed(Channel::event, stamp, message);
}

Packet encode(const Stamp& stamp, const Health& health) {
  auto message = stamped<fantail_lcm::health_t>(stamp);
  message.gyro = word(health.gyro);
  message.accelerometer = word(health.accelerometer);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    message.verdict[i] = word(health.verdicts[i]);
  }
  message.timing_fault = word(health.timing_fault);
  message.longest_tick_s = to_wire(health.longest_tick_s);
  message.late_ticks = to_wire(health.late_ticks);
  message.bus_state = health.bus ? word(health.bus->state) : word(unknown_number);
  message.bus_unsent = health.bus ? health.bus->unsent : unknown_number;
  message.bus_overrun = health.bus ? health.bus->overrun : unknown_number;
  message.bus_errors = health.bus ? health.bus->errors : unknown_number;
  message.gateway_bus_state = health.gateway ? word(health.gateway->state) : word(unknown_number);
  message.gateway_frames = health.gateway ? health.gateway->frames : unknown_number;
  message.gateway_lost = health.gateway ? health.gateway->lost : unknown_number;
  message.gateway_damaged = health.gateway ? health.gateway->damaged : unknown_number;
  message.gateway_foreign = health.gateway ? health.gateway->foreign : unknown_number;
  message.gateway_overrun = health.gateway ? health.gateway->overrun : unknown_number;
  return packed(Channel::health, stamp, message);
}

}  // namespace fantail::telemetry
