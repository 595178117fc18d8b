// SPDX-License-Identifier: MIT
#include <algorithm>

#include "link/log_download.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_losses.hpp"

namespace fantail::link {
namespace {

std::optional<protocol::LogHeader> header_of(const protocol::LogFrame& frame) {
  return frame.head.type == static_cast<std::uint8_t>(protocol::LogRecord::header)
             ? protocol::decode_log_header(frame.payload)
             : std::nullopt;
}

/// Takes the frames of a record in their order.
class Splitter {
 public:
  explicit Splitter(std::span<const std::byte> record) : record_{record} {}

  void take(const protocol::LogFrame& frame, std::size_t foreign_before) {
    const auto header = header_of(frame);
    const bool other = header && numbered_ && number_ != header->flight;
    const bool first = flights_.empty();
    const bool begins = first || frame.head.sequence < next_sequence_ || other;
    if (!first && begins) {
      end_flight(frame.position, foreign_before);
    } else if (!first) {
      flights_.back().damaged_bytes += foreign_before;
    }
    if (begins) {
      flights_.push_back({.begin = first ? 0 : frame.position, .first_time = frame.head.time});
      numbered_ = false;
      next_sequence_ = 0;
    }
    RecordedFlight& flight = flights_.back();
    if (header && !numbered_) {
      numbered_ = true;
      number_ = header->flight;
      flight.vehicle = header->vehicle;
      flight.power_up = header->power_up;
    }
    // A flight's first frame carries 0, and what was lost before it was its own.
    const std::uint32_t missing = frame.head.sequence - next_sequence_;
    flight.missing_records += missing - protocol::dropped_before(frame, missing);
    flight.damaged_bytes += first ? foreign_before : 0;
    next_sequence_ = frame.head.sequence + 1;
    flight.records += 1;
    flight.last_time = frame.head.time;
    flight.end = frame.position + protocol::log_frame_overhead + frame.payload.size();
    last_ = frame;
  }

  /// What lies between its last intact frame and here belongs to the newest flight.
  void end_flight(std::size_t limit, std::size_t foreign) {
    RecordedFlight& flight = flights_.back();
    const bool cut_off = protocol::is_cut_off(last_, record_.subspan(flight.end, limit - flight.end));
    (cut_off ? flight.cut_off_bytes : flight.damaged_bytes) += foreign;
  }

  [[nodiscard]] std::vector<RecordedFlight>& flights() { return flights_; }

 private:
  std::span<const std::byte> record_;
  std::optional<protocol::LogFrame> last_;
  std::vector<RecordedFlight> flights_;
  bool numbered_ = false;  ///< the flight's header has been seen
  std::uint32_t number_ = 0;
  std::uint32_t next_sequence_ = 0;
};

}  // namespace

std::vector<RecordedFlight> split_flights(std::span<const std::byte> record) {
  protocol::LogFrameReader reader{record};
  Splitter splitter{record};
  std::size_t foreign = 0;
  while (const auto frame = reader.next()) {
    splitter.take(*frame, reader.foreign_bytes() - foreign);
    foreign = reader.foreign_bytes();
  }
  std::vector<RecordedFlight>& flights = splitter.flights();
  if (!flights.empty()) {
    splitter.end_flight(record.size(), reader.foreign_bytes() - foreign);
  }
  // Damaged bytes behind a flight's last intact record stay with it.
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const std::size_t limit = i + 1 < flights.size() ? flights[i + 1].begin : record.size();
    std::size_t end = limit;
    while (end > flights[i].end && record[end - 1] == std::byte{0xFF}) {
      end -= 1;
    }
    flights[i].end = end;
  }
  return flights;
}

}  // namespace fantail::link
