// SPDX-License-Identifier: MIT
#include "telemetry/lcm_format.hpp"

#include <algorithm>

namespace fantail::telemetry {
namespace {

constexpr std::uint32_t short_message = 0x4C43'3032;  // "LC02"
constexpr std::size_t header_size = 8;                // that word, and a number of the sender's
constexpr std::size_t longest_channel = 63;
constexpr std::size_t event_head_size = 28;
constexpr std::uint32_t log_event = 0xEDA1'DA01;
constexpr std::size_t portion_size = std::size_t{1} << 16U;

std::uint32_t first_word(std::span<const std::byte> bytes) {
  std::uint32_t word = 0;
  for (const std::byte byte : bytes.first(4)) {
    word = word << 8U | static_cast<std::uint32_t>(byte);
  }
  return word;
}

}  // namespace

std::optional<MessageView> read_datagram(std::span<const std::byte> datagram) {
  if (datagram.size() < header_size || datagram.size() > longest_datagram || first_word(datagram) != short_message) {
    return std::nullopt;
  }
  const auto rest = datagram.subspan(header_size);
  const auto end = std::ranges::find(rest, std::byte{0});
  const auto length = static_cast<std::size_t>(end - rest.begin());
  if (end == rest.end() || length > longest_channel) {
    return std::nullopt;
  }
  return MessageView{.channel = {reinterpret_cast<const char*>(rest.data()), length},  // NOLINT: bytes as characters
                     .bytes = rest.subspan(length + 1)};
}

std::optional<LcmLog::Event> LcmLog::next() {
  while (find_event()) {
    const auto number_of_event = number(8);
    const auto time_us = number(8);
    const auto channel_size = number(4);
    const auto size = number(4);
    if (!number_of_event || !time_us || !channel_size || !size) {
      return std::nullopt;
    }
    if (*channel_size == 0 || *channel_size > longest_channel) {
      continue;
    }
    Event event{.time_us = static_cast<std::int64_t>(*time_us), .channel = {}, .bytes = {}};
    if (!take(event.channel, *channel_size)) {
      return std::nullopt;
    }
    const bool is_ours = event.channel.starts_with(channel_prefix);
    if (is_ours && *size > longest_datagram) {
      continue;
    }
    if (!(is_ours ? take(event.bytes, *size) : skip(*size))) {
      return std::nullopt;
    }
    whole_ += event_head_size + *channel_size + *size;
    return event;
  }
  return std::nullopt;
}

std::optional<std::uint8_t> LcmLog::byte() {
  if (used_ == portion_.size()) {
    portion_.resize(portion_size);
    portion_.resize(read_(portion_));
    used_ = 0;
  }
  if (used_ == portion_.size()) {
    return std::nullopt;
  }
  passed_ += 1;
  return static_cast<std::uint8_t>(portion_[used_++]);
}

std::optional<std::uint64_t> LcmLog::number(std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const auto next = byte();
    if (!next) {
      return std::nullopt;
    }
    value = value << 8U | *next;
  }
  return value;
}

bool LcmLog::find_event() {
  for (std::uint32_t word = 0; const auto next = byte();) {
    word = word << 8U | *next;
    if (word == log_event) {
      return true;
    }
  }
  return false;
}

template <typename Bytes>
bool LcmLog::take(Bytes& to, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const auto next = byte();
    if (!next) {
      return false;
    }
    to.push_back(static_cast<typename Bytes::value_type>(*next));
  }
  return true;
}

bool LcmLog::skip(std::uint64_t size) {
  for (std::uint64_t i = 0; i < size; ++i) {
    if (!byte()) {
      return false;
    }
  }
  return true;
}

}  // namespace fantail::telemetry
