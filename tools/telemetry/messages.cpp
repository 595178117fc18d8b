// SPDX-License-Identifier: MIT
#include "telemetry/messages.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fantail_lcm/canards_t.hpp>
#include <fantail_lcm/event_t.hpp>
#include <fantail_lcm/health_t.hpp>
#include <fantail_lcm/state_t.hpp>

namespace fantail::telemetry {
namespace {

using core::CanardVerdict;
using core::CommandStatus;
using core::Phase;
using core::PhaseReason;
using core::SensorState;
using hal::CanState;

constexpr std::array<std::string_view, channel_count> names{"FANTAIL_STATE", "FANTAIL_CANARDS", "FANTAIL_EVENT",
                                                            "FANTAIL_HEALTH"};
constexpr int unknown = -1;

// Enumerations are sent as the enumerators' numbers; this is the highest of each.
constexpr int highest(Phase /*of*/) { return fantail_lcm::state_t::PHASE_FINISHED; }
constexpr int highest(PhaseReason /*of*/) { return fantail_lcm::state_t::REASON_FLEW_WITHOUT_LAUNCH; }
constexpr int highest(CommandStatus /*of*/) { return fantail_lcm::state_t::COMMAND_NOT_FINITE; }
constexpr int highest(CanardVerdict /*of*/) { return fantail_lcm::canards_t::VERDICT_DISAGREEING; }
constexpr int highest(SensorState /*of*/) { return fantail_lcm::health_t::SENSOR_FAILED; }
constexpr int highest(CanState /*of*/) { return fantail_lcm::health_t::BUS_DOWN; }
static_assert(static_cast<int>(Phase::finished) == highest(Phase{}));
static_assert(static_cast<int>(PhaseReason::flew_without_launch) == highest(PhaseReason{}));
static_assert(static_cast<int>(CommandStatus::not_finite) == highest(CommandStatus{}));
static_assert(static_cast<int>(CanardVerdict::disagreeing) == highest(CanardVerdict{}));
static_assert(static_cast<int>(SensorState::failed) == highest(SensorState{}));
static_assert(static_cast<int>(CanState::down) == highest(CanState{}));

/// Copies values into a message.
struct Writer {
  void operator()(double& wire, const std::optional<double>& value) {
    wire = value.value_or(std::numeric_limits<double>::quiet_NaN());
  }
  void operator()(std::int64_t& wire, std::int64_t value) { wire = value; }
  void operator()(std::int64_t& wire, const std::optional<std::int64_t>& value) { wire = value.value_or(unknown); }
  template <typename T>
  void operator()(std::int8_t& wire, T value) {
    wire = static_cast<std::int8_t>(value);
  }
  template <typename Enum>
  void operator()(std::int8_t& wire, const std::optional<Enum>& value) {
    wire = value ? static_cast<std::int8_t>(*value) : static_cast<std::int8_t>(unknown);
  }
  /// Whether there is a part, which begins with its state.
  template <typename Part>
  bool has(std::int8_t& wire, const std::optional<Part>& part) {
    (*this)(wire, part ? std::optional{part->state} : std::nullopt);
    return part.has_value();
  }
  template <typename... Numbers>
  void absent(Numbers&... numbers) {
    ((numbers = unknown), ...);
  }
};

/// Copies them back, and remembers whether every number was one that the type has.
struct Reader {
  bool all_known = true;

  void operator()(double wire, std::optional<double>& value) {
    value = wire == wire ? std::optional{wire} : std::nullopt;  // NaN alone differs from itself
  }
  void operator()(std::int64_t wire, std::int64_t& value) { value = wire; }
  void operator()(std::int64_t wire, std::optional<std::int64_t>& value) {
    value = wire >= 0 ? std::optional{wire} : std::nullopt;
  }
  void operator()(std::int8_t wire, bool& value) {
    all_known = all_known && (wire == 0 || wire == 1);
    value = wire == 1;
  }
  template <typename Enum>
  void operator()(std::int8_t wire, Enum& value) {
    const bool known = wire >= 0 && wire <= highest(Enum{});
    all_known = all_known && known;
    value = known ? static_cast<Enum>(wire) : Enum{};
  }
  template <typename Enum>
  void operator()(std::int8_t wire, std::optional<Enum>& value) {
    value.reset();
    if (wire != unknown) {
      (*this)(wire, value.emplace());
    }
  }
  template <typename Part>
  bool has(std::int8_t wire, std::optional<Part>& part) {
    if (wire != unknown) {
      (*this)(wire, part.emplace(Part{}).state);
    }
    return part.has_value();
  }
  template <typename... Numbers>
  void absent(const Numbers&... /*numbers*/) {}
};

// What belongs to what, for both directions: `copy` is a Writer or a Reader, and the side that it reads is const.

void visit(auto& copy, auto& message, auto& state)
  requires requires { state.roll_angle_rad; }
{
  copy(message.phase, state.phase);
  copy(message.reason, state.reason);
  copy(message.command_status, state.command_status);
  copy(message.timing_fault, state.timing_fault);
  copy(message.saturated, state.saturated);
  copy(message.roll_angle_rad, state.roll_angle_rad);
  copy(message.roll_rate_rad_s, state.roll_rate_rad_s);
  copy(message.reference_rad, state.reference_rad);
  copy(message.excitation_rad, state.excitation_rad);
  copy(message.unclamped_command_rad, state.unclamped_command_rad);
  copy(message.command_rad, state.command_rad);
  copy(message.specific_force_m_s2, state.specific_force_m_s2);
  copy(message.height_m, state.height_m);
  copy(message.speed_m_s, state.speed_m_s);
  copy(message.vertical_speed_m_s, state.vertical_speed_m_s);
  copy(message.tilt_rad, state.tilt_rad);
}

void visit(auto& copy, auto& message, auto& canards)
  requires requires { canards.canard_rad; }
{
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    copy(message.command_rad[i], canards.command_rad[i]);
    copy(message.encoder_rad[i], canards.encoder_rad[i]);
    copy(message.limit_rad[i], canards.limit_rad[i]);
    copy(message.limited[i], canards.limited[i]);
    copy(message.verdict[i], canards.verdicts[i]);
  }
  copy(message.canard_rad, canards.canard_rad);
}

void visit(auto& copy, auto& message, auto& health)
  requires requires { health.gyro; }
{
  copy(message.gyro, health.gyro);
  copy(message.accelerometer, health.accelerometer);
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    copy(message.verdict[i], health.verdicts[i]);
  }
  copy(message.timing_fault, health.timing_fault);
  copy(message.longest_tick_s, health.longest_tick_s);
  copy(message.late_ticks, health.late_ticks);
  if (copy.has(message.bus_state, health.bus)) {
    copy(message.bus_unsent, health.bus->unsent);
    copy(message.bus_overrun, health.bus->overrun);
    copy(message.bus_errors, health.bus->errors);
  } else {
    copy.absent(message.bus_unsent, message.bus_overrun, message.bus_errors);
  }
  if (copy.has(message.gateway_bus_state, health.gateway)) {
    copy(message.gateway_frames, health.gateway->frames);
    copy(message.gateway_lost, health.gateway->lost);
    copy(message.gateway_damaged, health.gateway->damaged);
    copy(message.gateway_foreign, health.gateway->foreign);
    copy(message.gateway_overrun, health.gateway->overrun);
  } else {
    copy.absent(message.gateway_frames, message.gateway_lost, message.gateway_damaged, message.gateway_foreign,
                message.gateway_overrun);
  }
}

// An event is one of two things, so each direction is written out.
void visit(Writer& write, fantail_lcm::event_t& message, const Event& event) {
  write.absent(message.phase_before, message.phase, message.reason, message.canard, message.verdict_before,
               message.verdict);
  if (event.phase) {
    message.kind = fantail_lcm::event_t::KIND_PHASE;
    write(message.phase_before, event.phase->before);
    write(message.phase, event.phase->phase);
    write(message.reason, event.phase->reason);
  } else if (event.verdict) {
    message.kind = fantail_lcm::event_t::KIND_CANARD;
    write(message.canard, event.verdict->canard + 1);
    write(message.verdict_before, event.verdict->before);
    write(message.verdict, event.verdict->verdict);
  }
}

void visit(Reader& read, const fantail_lcm::event_t& message, Event& event) {
  const bool is_canard = message.canard >= 1 && message.canard <= static_cast<int>(core::canard_count);
  if (message.kind == fantail_lcm::event_t::KIND_PHASE) {
    auto& change = event.phase.emplace(Event::PhaseChange{});
    read(message.phase_before, change.before);
    read(message.phase, change.phase);
    read(message.reason, change.reason);
  } else if (message.kind == fantail_lcm::event_t::KIND_CANARD && is_canard) {
    auto& change = event.verdict.emplace(Event::VerdictChange{});
    change.canard = static_cast<std::size_t>(message.canard - 1);
    read(message.verdict_before, change.before);
    read(message.verdict, change.verdict);
  } else {
    read.all_known = false;
  }
}

template <typename Message>
Packet packed(Channel channel, const Stamp& stamp, const auto& content) {
  Message message{};
  message.run = stamp.run;
  message.sequence = stamp.sequence;
  message.time_us = stamp.time.count();
  Writer writer;
  visit(writer, message, content);
  Packet packet{.channel = channel, .time = stamp.time};
  const int size = message.encode(packet.bytes.data(), 0, static_cast<int>(packet.bytes.size()));
  if (size < 0) {
    throw std::logic_error{"a telemetry message is longer than a packet"};
  }
  packet.size = static_cast<std::size_t>(size);
  return packet;
}

// The types have no parts of variable length, so there is one right length, and what was generated reads no further.
template <typename Message, typename Content>
std::optional<Decoded> unpacked(std::span<const std::byte> bytes) {
  Message message{};
  if (bytes.size() != static_cast<std::size_t>(message.getEncodedSize()) ||
      message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0 || message.sequence < 0) {
    return std::nullopt;
  }
  Content content;
  Reader reader;
  visit(reader, std::as_const(message), content);
  const Stamp stamp{.run = message.run, .sequence = message.sequence, .time = core::Microseconds{message.time_us}};
  return reader.all_known ? std::optional{Decoded{.stamp = stamp, .content = content}} : std::nullopt;
}

}  // namespace

std::string_view name(Channel channel) { return names[static_cast<std::size_t>(channel)]; }

std::optional<Channel> channel_named(std::string_view name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? std::nullopt : std::optional{static_cast<Channel>(found - names.begin())};
}

Packet encode(const Stamp& stamp, const State& state) {
  return packed<fantail_lcm::state_t>(Channel::state, stamp, state);
}
Packet encode(const Stamp& stamp, const Canards& canards) {
  return packed<fantail_lcm::canards_t>(Channel::canards, stamp, canards);
}
Packet encode(const Stamp& stamp, const Event& event) {
  return packed<fantail_lcm::event_t>(Channel::event, stamp, event);
}
Packet encode(const Stamp& stamp, const Health& health) {
  return packed<fantail_lcm::health_t>(Channel::health, stamp, health);
}

std::optional<Decoded> decode(Channel channel, std::span<const std::byte> bytes) {
  switch (channel) {
    case Channel::state: return unpacked<fantail_lcm::state_t, State>(bytes);
    case Channel::canards: return unpacked<fantail_lcm::canards_t, Canards>(bytes);
    case Channel::event: return unpacked<fantail_lcm::event_t, Event>(bytes);
    case Channel::health: return unpacked<fantail_lcm::health_t, Health>(bytes);
  }
  return std::nullopt;
}

}  // namespace fantail::telemetry
