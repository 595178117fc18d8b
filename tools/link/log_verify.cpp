// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "link/log_download.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::link {
namespace {

using Bytes = std::vector<std::byte>;

// Within the first `end` bytes, what lies between the intact records.
std::vector<LogStretch> uncovered(std::span<const std::byte> record, std::uint32_t end) {
  std::vector<LogStretch> gaps;
  std::uint32_t covered = 0;
  const auto add = [&](std::size_t next) {
    const std::uint32_t to = std::min(static_cast<std::uint32_t>(next), end);
    if (to > covered) {
      gaps.push_back({.offset = covered, .size = to - covered});
    }
  };
  protocol::LogFrameReader reader{record};
  while (const auto frame = reader.next()) {
    add(frame->position);
    covered = static_cast<std::uint32_t>(frame->position + protocol::log_frame_overhead + frame->payload.size());
  }
  add(record.size());
  return gaps;
}

bool all_of_flights(std::span<const std::byte> record, bool (*holds)(const RecordedFlight&)) {
  const auto flights = split_flights(record);
  return !flights.empty() && std::ranges::all_of(flights, holds);
}

bool is_intact(const RecordedFlight& flight) { return flight.intact(); }

// A record that was not cut off in the flash may have been on its way.
bool is_whole(const RecordedFlight& flight) { return flight.intact() && flight.cut_off_bytes == 0; }

std::uint32_t differing(const Bytes& one, const Bytes& other) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    count += one[i] == other[i] ? 0U : 1U;
  }
  return count;
}

class Check {
 public:
  Check(LogReader& reader, std::uint32_t offset, LogPart& part, const std::function<void(std::uint32_t)>& progress)
      : reader_{reader}, offset_{offset}, part_{part}, progress_{progress} {}

  void fetch_again(const LogStretch& range) {
    for (std::uint32_t at = range.offset; at < range.offset + range.size;) {
      const Bytes now = reader_.read(offset_ + at, range.offset + range.size - at);
      const auto size = static_cast<std::uint32_t>(now.size());
      if (const Bytes before = part_.read(at, size); before != now) {
        settle(at, before, now);
      }
      at += size;
      fetched_ += size;
      progress_(fetched_);
    }
  }

  LogCheck found;

 private:
  void settle(std::uint32_t at, const Bytes& before, const Bytes& now) {
    const auto size = static_cast<std::uint32_t>(now.size());
    if (read_all(reader_, offset_ + at, size) != now) {
      found.unsteady_bytes += size;
      return;
    }
    part_.overwrite(at, now);
    found.mended_bytes += differing(before, now);
  }

  LogReader& reader_;
  std::uint32_t offset_;
  LogPart& part_;
  const std::function<void(std::uint32_t)>& progress_;
  std::uint32_t fetched_ = 0;
};

}  // namespace

LogCheck verify(LogReader& reader, const LogStretch& stretch, LogPart& part, std::uint32_t resumed_bytes,
                const std::function<void(std::uint32_t)>& progress) {
  Check check{reader, stretch.offset, part, progress};
  for (const LogStretch& gap : uncovered(part.read(0, stretch.size), resumed_bytes)) {
    check.fetch_again(gap);
  }
  if (!all_of_flights(part.read(0, stretch.size), is_whole)) {
    check.fetch_again({.offset = 0, .size = stretch.size});
  }
  check.found.intact = all_of_flights(part.read(0, stretch.size), is_intact);
  return check.found;
}

}  // namespace fantail::link
