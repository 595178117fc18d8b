// SPDX-License-Identifier: MIT
#include <utility>

#include "flight_log/flight_builder.hpp"
#include "flight_log/flight_log.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::flight_log {

LogFile parse_log(std::span<const std::byte> bytes, std::string name) {
  LogFile file;
  file.name = std::move(name);
  file.bytes = bytes.size();
  protocol::LogFrameReader reader{bytes};
  FlightBuilder builder;
  bool begun = false;
  std::size_t foreign_before = 0;
  while (const auto frame = reader.next()) {
    file.foreign_places += reader.foreign_bytes() > foreign_before ? 1 : 0;
    foreign_before = reader.foreign_bytes();
    if (builder.begins_another(*frame)) {
      file.flights.push_back(builder.take());
      builder = {};
      begun = false;
    }
    if (file.flights.size() == most_flights) {
      file.records_left_out += 1;
      continue;
    }
    builder.add(*frame);
    begun = true;
  }
  if (begun) {
    file.flights.push_back(builder.take());
  }
  file.foreign_bytes = reader.foreign_bytes();
  file.cut_off_bytes = file.foreign_bytes - foreign_before;
  file.foreign_places += file.cut_off_bytes > 0 ? 1 : 0;
  return file;
}

}  // namespace fantail::flight_log
