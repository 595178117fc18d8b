// SPDX-License-Identifier: MIT
#include "protocol/log_losses.hpp"

#include <algorithm>

#include "protocol/log_notes.hpp"

namespace fantail::protocol {
namespace {

constexpr std::size_t page = 256;

std::optional<LogEvent> event_in(const LogFrame& frame) {
  return frame.head.type == static_cast<std::uint8_t>(LogRecord::event) ? unpack_event(frame.head.time, frame.payload)
                                                                        : std::nullopt;
}

// Of the frame with this number, if it begins here; else 0.
std::size_t size_of_frame(std::span<const std::byte> bytes, std::uint32_t sequence) {
  const bool begins = bytes.size() >= log_head_size && bytes[0] == log_sync && get<4>(bytes, 4) == sequence &&
                      get<2>(bytes, 2) <= largest_log_payload;
  return begins ? log_frame_overhead + static_cast<std::size_t>(get<2>(bytes, 2)) : 0;
}

}  // namespace

bool is_cut_off(const std::optional<LogFrame>& last, std::span<const std::byte> rest) {
  while (!rest.empty() && rest.back() == std::byte{0xFF}) {
    rest = rest.first(rest.size() - 1);
  }
  const auto event = last ? event_in(*last) : std::nullopt;
  const bool ended = event && event->kind == LogEventKind::recording_ended;
  return !ended && rest.size() <= page + size_of_frame(rest, last ? last->head.sequence + 1 : 0);
}

std::uint32_t dropped_before(const LogFrame& frame, std::uint32_t missing) {
  const auto event = event_in(frame);
  return event && event->kind == LogEventKind::records_dropped ? std::min(event->number, missing) : 0;
}

}  // namespace fantail::protocol
