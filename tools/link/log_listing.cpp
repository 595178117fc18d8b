// SPDX-License-Identifier: MIT
#include "link/log_listing.hpp"

#include <algorithm>

#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"

namespace fantail::link {
namespace {

// Of the smallest sector that there is in NOR flash; larger ones are multiples of it.
constexpr std::uint32_t sector = 4096;

std::vector<std::byte> read_all(LogReader& reader, std::uint32_t offset, std::uint32_t size) {
  std::vector<std::byte> bytes;
  while (bytes.size() < size) {
    const auto done = static_cast<std::uint32_t>(bytes.size());
    const std::vector<std::byte> more = reader.read(offset + done, size - done);
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  return bytes;
}

std::optional<ListedFlight> flight_at(LogReader& reader, std::uint32_t offset, std::uint32_t room) {
  const std::vector<std::byte> head = read_all(reader, offset, protocol::log_head_size);
  const auto length = static_cast<std::uint32_t>(protocol::get<2>(head, 2));
  const bool first_header = head[0] == protocol::log_sync &&
                            head[1] == static_cast<std::byte>(protocol::LogRecord::header) &&
                            protocol::get<4>(head, 4) == 0;
  const std::uint32_t size = static_cast<std::uint32_t>(protocol::log_frame_overhead) + length;
  if (!first_header || length > protocol::largest_log_payload || size > room) {
    return std::nullopt;
  }
  const std::vector<std::byte> bytes = read_all(reader, offset, size);
  const auto frame = protocol::LogFrameReader{bytes}.next();
  const auto header = frame && frame->position == 0 ? protocol::decode_log_header(frame->payload) : std::nullopt;
  if (!header) {
    return std::nullopt;
  }
  return ListedFlight{
      .stretch = {.offset = offset}, .vehicle = std::string{header->vehicle}, .power_up = header->power_up};
}

}  // namespace

std::vector<ListedFlight> list_flights(LogReader& reader, std::uint32_t used_bytes,
                                       const std::function<void(std::uint32_t)>& progress) {
  std::vector<ListedFlight> flights;
  for (std::uint32_t offset = 0; offset + sector <= used_bytes; offset += sector) {
    if (auto flight = flight_at(reader, offset, used_bytes - offset)) {
      flights.push_back(std::move(*flight));
    }
    if (!flights.empty()) {
      flights.back().stretch.size = offset + sector - flights.back().stretch.offset;
    }
    progress(offset + sector);
  }
  return flights;
}

}  // namespace fantail::link
