// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "core/flight_phase.hpp"
#include "core/tick_record.hpp"
#include "hal/can_bus.hpp"

namespace fantail::telemetry {

// The content of the LCM messages of types/*.lcm in the program's types: unknown values are empty here, and NaN or -1
// on the wire. The channel's name is that of the struct: FANTAIL_STATE, FANTAIL_CANARDS, FANTAIL_EVENT, FANTAIL_HEALTH.

enum class Channel : std::uint8_t { state, canards, event, health };
inline constexpr std::size_t channel_count = 4;

template <typename Value>
using Each = std::array<Value, core::canard_count>;

/// What every message begins with.
struct Stamp {
  std::int64_t run = 0;       ///< the sender, from its start to its end
  std::int64_t sequence = 0;  ///< of the channel: 0, 1, 2, ...
  core::Microseconds time{};  ///< since the avionics was switched on
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

struct State {
  core::Phase phase = core::Phase::safe;
  core::PhaseReason reason = core::PhaseReason::power_on;
  core::CommandStatus command_status = core::CommandStatus::outside_control;
  bool timing_fault = false;
  bool saturated = false;
  std::optional<double> roll_angle_rad{};
  std::optional<double> roll_rate_rad_s{};
  std::optional<double> reference_rad{};
  std::optional<double> excitation_rad{};
  std::optional<double> unclamped_command_rad{};
  std::optional<double> command_rad{};
  std::optional<double> specific_force_m_s2{};  ///< along the rocket's axis
  std::optional<double> height_m{};
  std::optional<double> speed_m_s{};
  std::optional<double> vertical_speed_m_s{};
  std::optional<double> tilt_rad{};
  friend bool operator==(const State&, const State&) = default;
};

struct Canards {
  Each<std::optional<double>> command_rad{};  ///< empty: not driven
  Each<std::optional<double>> encoder_rad{};
  Each<std::optional<double>> limit_rad{};
  std::optional<double> canard_rad{};  ///< mean of the encoders
  Each<bool> limited{};
  Each<std::optional<core::CanardVerdict>> verdicts{};
  friend bool operator==(const Canards&, const Canards&) = default;
};

/// The phase or the verdict on one canard has changed: one of the two is there.
struct Event {
  struct PhaseChange {
    core::Phase before = core::Phase::safe;
    core::Phase phase = core::Phase::safe;
    core::PhaseReason reason = core::PhaseReason::power_on;
    friend bool operator==(const PhaseChange&, const PhaseChange&) = default;
  };
  struct VerdictChange {
    std::size_t canard = 0;  ///< 0 to 3
    core::CanardVerdict before = core::CanardVerdict::healthy;
    core::CanardVerdict verdict = core::CanardVerdict::healthy;
    friend bool operator==(const VerdictChange&, const VerdictChange&) = default;
  };
  std::optional<PhaseChange> phase{};
  std::optional<VerdictChange> verdict{};
  friend bool operator==(const Event&, const Event&) = default;
};

struct Health {
  /// One end of a CAN bus.
  struct Bus {
    hal::CanState state = hal::CanState::error_active;
    std::int64_t unsent = 0;
    std::int64_t overrun = 0;
    std::int64_t errors = 0;
    friend bool operator==(const Bus&, const Bus&) = default;
  };
  /// How well a gateway receives the avionics.
  struct Gateway {
    hal::CanState state = hal::CanState::error_active;
    std::int64_t frames = 0;
    std::int64_t lost = 0;
    std::int64_t damaged = 0;
    std::int64_t foreign = 0;
    std::int64_t overrun = 0;
    friend bool operator==(const Gateway&, const Gateway&) = default;
  };
  core::SensorState gyro = core::SensorState::failed;
  core::SensorState accelerometer = core::SensorState::failed;
  Each<core::CanardVerdict> verdicts{};
  bool timing_fault = false;
  std::optional<double> longest_tick_s{};    ///< in the last 0.1 s
  std::optional<std::int64_t> late_ticks{};  ///< since the start
  std::optional<Bus> bus{};
  std::optional<Gateway> gateway{};
  friend bool operator==(const Health&, const Health&) = default;
};

/// One encoded message. Of fixed size, so that handing it on needs no memory.
struct Packet {
  static constexpr std::size_t capacity = 192;
  Channel channel{};
  core::Microseconds time{};
  std::size_t size = 0;
  std::array<std::byte, capacity> bytes{};
  [[nodiscard]] std::span<const std::byte> content() const { return std::span{bytes}.first(size); }
};

[[nodiscard]] std::string_view name(Channel channel);
/// Empty for a channel that is not ours.
[[nodiscard]] std::optional<Channel> channel_named(std::string_view name);

[[nodiscard]] Packet encode(const Stamp& stamp, const State& state);
[[nodiscard]] Packet encode(const Stamp& stamp, const Canards& canards);
[[nodiscard]] Packet encode(const Stamp& stamp, const Event& event);
[[nodiscard]] Packet encode(const Stamp& stamp, const Health& health);

struct Decoded {
  Stamp stamp{};
  std::variant<State, Canards, Event, Health> content{};
};

/// Empty for bytes that are no message of that channel: another type, another version of it, another length, or a word
/// that there is not.
[[nodiscard]] std::optional<Decoded> decode(Channel channel, std::span<const std::byte> bytes);

/// The files of types/, made into constants when the program is built.
namespace type_texts {
extern const std::string_view state_t;
extern const std::string_view canards_t;
extern const std::string_view event_t;
extern const std::string_view health_t;
}  // namespace type_texts

struct TypeFile {
  std::string_view name;  ///< "state_t.lcm"
  std::string_view text;
};

/// All that lcm-gen needs to decode the messages.
[[nodiscard]] inline std::array<TypeFile, 4> type_files() {
  return {{{"state_t.lcm", type_texts::state_t},
           {"canards_t.lcm", type_texts::canards_t},
           {"event_t.lcm", type_texts::event_t},
           {"health_t.lcm", type_texts::health_t}}};
}

}  // namespace fantail::telemetry
