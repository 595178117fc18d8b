// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "telemetry/messages.hpp"

namespace fantail::telemetry {

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

}  // namespace fantail::telemetry
