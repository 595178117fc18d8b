// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "flight_log/flight_log.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_losses.hpp"
#include "protocol/log_schema.hpp"
#include "protocol/plan_block.hpp"
#include "text/quoting.hpp"

namespace fantail::flight_log {
namespace {

using protocol::LogRecord;

// Records of one flight are written nearly in the order of their times; the ring of ticks from before the launch is
// half a second long.
constexpr core::Microseconds clock_was_set_back = std::chrono::seconds{10};

bool is(const protocol::LogFrame& frame, LogRecord type) { return frame.head.type == static_cast<std::uint8_t>(type); }

core::Microseconds get_time(std::span<const std::byte> payload, std::size_t at) {
  return core::Microseconds{static_cast<std::int64_t>(protocol::get<8>(payload, at))};
}

// A time that a clock of 48 bits can show. A checkpoint is not told from noise by more than its checksum.
bool is_clock_time(core::Microseconds time) { return time.count() >= 0 && (time.count() >> 48U) == 0; }

// Why a plan block holds no plan that can be used, as the end of a sentence.
std::string fault_text(const protocol::PlanBlockReading& reading) {
  switch (reading.fault) {
    case protocol::PlanBlockFault::too_short:
    case protocol::PlanBlockFault::no_plan_block: return "there is none in the header";
    case protocol::PlanBlockFault::wrong_length: return "its length is wrong";
    case protocol::PlanBlockFault::wrong_checksum: return "its checksum is wrong";
    case protocol::PlanBlockFault::older_version: return "it was written by an older version";
    case protocol::PlanBlockFault::newer_version: return "it was written by a newer version";
    case protocol::PlanBlockFault::other_schema: return "it was written for a different list of plan values";
    case protocol::PlanBlockFault::refused: break;
  }
  if (!reading.plan_fault) {
    return "one of its values is not allowed";
  }
  const core::PlanField& field = core::flight_plan_fields()[reading.plan_fault->field];
  return fmt::format("one of its values is not allowed: {}.{}, {}", field.section, field.key,
                     core::sentence(reading.plan_fault->rule));
}

/// One flight, made from its records as they come.
class FlightBuilder {
 public:
  /// A record of another flight: another header, a sequence that goes back, a clock that was set back.
  [[nodiscard]] bool begins_another(const protocol::LogFrame& frame) const;

  void add(const protocol::LogFrame& frame);

  /// The bytes of the frames are needed until here.
  [[nodiscard]] Flight take();

 private:
  void note_place(const protocol::LogFrame& frame);
  void add_header(const protocol::LogFrame& frame);
  void add_checkpoint(const protocol::LogFrame& frame);
  void add_event(const protocol::LogFrame& frame);
  void add_tick(const protocol::LogFrame& frame);
  void add_waiting_ticks();

  Flight flight_;
  std::optional<std::uint32_t> last_sequence_;
  std::span<const std::byte> header_;
  bool schema_is_ours_ = true;
  protocol::SampleTimes times_;
  std::vector<protocol::LogFrame> waiting_;  ///< ticks and checkpoints before the header: what they mean is not known
};

bool FlightBuilder::begins_another(const protocol::LogFrame& frame) const {
  if (!last_sequence_) {
    return false;
  }
  if (frame.head.sequence <= *last_sequence_ || frame.head.time + clock_was_set_back < flight_.last_time) {
    return true;
  }
  return is(frame, LogRecord::header) && flight_.has_header && !std::ranges::equal(frame.payload, header_) &&
         protocol::decode_log_header(frame.payload).has_value();
}

void FlightBuilder::add(const protocol::LogFrame& frame) {
  note_place(frame);
  switch (static_cast<LogRecord>(frame.head.type)) {
    case LogRecord::header: add_header(frame); return;
    case LogRecord::checkpoint: add_checkpoint(frame); return;
    case LogRecord::tick: add_tick(frame); return;
    case LogRecord::event: add_event(frame); return;
    case LogRecord::health:
      if (const auto health = protocol::unpack_health(frame.head.time, frame.payload)) {
        flight_.health.push_back(*health);
        return;
      }
      break;
  }
  flight_.unknown_records += 1;
}

void FlightBuilder::note_place(const protocol::LogFrame& frame) {
  const protocol::LogFrameHead& head = frame.head;
  const std::uint32_t expected = last_sequence_ ? *last_sequence_ + 1 : 0;
  if (head.sequence != expected) {
    flight_.gaps.push_back({.first_missing = expected,
                            .count = head.sequence - expected,
                            .before = last_sequence_ ? flight_.last_time : head.time,
                            .after = head.time,
                            .dropped = protocol::dropped_before(frame, head.sequence - expected)});
  }
  if (!last_sequence_) {
    flight_.first_time = head.time;
  }
  flight_.records += 1;
  flight_.last_time = head.time;
  last_sequence_ = head.sequence;
}

void FlightBuilder::add_header(const protocol::LogFrame& frame) {
  const auto header = protocol::decode_log_header(frame.payload);
  if (!header) {
    flight_.unknown_records += 1;
    return;
  }
  if (flight_.has_header) {
    return;
  }
  header_ = frame.payload;
  flight_.has_header = true;
  flight_.format_version = header->format_version;
  flight_.flight = header->flight;
  flight_.power_up = header->power_up;
  flight_.state_layout = header->state_layout;
  flight_.rate_scale_rad_s = header->rate_scale_rad_s;
  flight_.specific_force_scale_m_s2 = header->specific_force_scale_m_s2;
  flight_.accelerometer_scale_m_s2 = header->accelerometer_scale_m_s2;
  flight_.second_rate_scale_rad_s = header->second_rate_scale_rad_s;
  flight_.firmware_version = text::printable(header->firmware_version);
  flight_.git_hash = text::printable(header->git_hash);
  flight_.vehicle = text::printable(header->vehicle);
  flight_.sensors = text::printable(header->sensors);
  flight_.schema = header->schema;
  flight_.plan_block.assign(header->plan_block.begin(), header->plan_block.end());
  const auto reading = protocol::read_plan_block(header->plan_block);
  flight_.plan = reading.plan;
  flight_.plan_fault = reading.plan ? "" : fault_text(reading);
  const std::string_view schema =
      header->second_rate_scale_rad_s ? protocol::log_schema_of_two_gyros() : protocol::log_schema();
  const std::string_view rest = header->schema.substr(std::min(schema.size(), header->schema.size()));
  schema_is_ours_ = header->schema.starts_with(schema) && (rest.empty() || rest == protocol::log_schema_of_barometer());
  add_waiting_ticks();
}

void FlightBuilder::add_event(const protocol::LogFrame& frame) {
  const auto event = protocol::unpack_event(frame.head.time, frame.payload);
  if (!event) {
    flight_.unknown_records += 1;
    return;
  }
  flight_.events.push_back(*event);
}

void FlightBuilder::add_checkpoint(const protocol::LogFrame& frame) {
  if (!flight_.has_header) {
    waiting_.push_back(frame);
    return;
  }
  if (frame.payload.size() < protocol::log_checkpoint_times_size) {
    flight_.unknown_records += 1;
    return;
  }
  const protocol::SampleTimes times{
      .imu = get_time(frame.payload, 0), .accelerometer = get_time(frame.payload, 8), .second_gyro = {}};
  if (!is_clock_time(times.imu) || !is_clock_time(times.accelerometer)) {
    flight_.unknown_records += 1;
    return;
  }
  times_.imu = times.imu;
  times_.accelerometer = times.accelerometer;
  const auto state = frame.payload.subspan(protocol::log_checkpoint_times_size);
  flight_.checkpoints.push_back({.sequence = frame.head.sequence,
                                 .time = frame.head.time,
                                 .times = times,
                                 .state = {state.begin(), state.end()}});
}

void FlightBuilder::add_tick(const protocol::LogFrame& frame) {
  if (!flight_.has_header) {
    waiting_.push_back(frame);
    return;
  }
  if (!schema_is_ours_) {
    flight_.foreign_ticks.push_back({.sequence = frame.head.sequence,
                                     .time = frame.head.time,
                                     .payload = {frame.payload.begin(), frame.payload.end()}});
    return;
  }
  if (const auto tick = protocol::unpack_tick(frame.head.time, frame.payload, times_)) {
    flight_.ticks.push_back({.sequence = frame.head.sequence, .tick = *tick});
    return;
  }
  flight_.unknown_records += 1;
  flight_.unknown_ticks.push_back(frame.head.sequence);
}

void FlightBuilder::add_waiting_ticks() {
  for (const protocol::LogFrame& frame : std::exchange(waiting_, {})) {
    if (is(frame, LogRecord::tick)) {
      add_tick(frame);
    } else {
      add_checkpoint(frame);
    }
  }
}

Flight FlightBuilder::take() {
  if (!waiting_.empty()) {
    // No header was left. Payloads that this version can read are most likely its own.
    flight_.has_header = true;
    add_waiting_ticks();
    flight_.has_header = false;
  }
  return std::move(flight_);
}

}  // namespace

LogFile parse_log(std::span<const std::byte> bytes, std::string name) {
  LogFile file;
  file.name = std::move(name);
  file.bytes = bytes.size();
  protocol::LogFrameReader reader{bytes};
  FlightBuilder builder;
  bool begun = false;
  std::size_t foreign_before = 0;
  std::optional<protocol::LogFrame> last;
  std::size_t last_end = 0;
  const auto end_flight = [&](std::size_t limit) {
    const std::size_t foreign = reader.foreign_bytes() - foreign_before;
    file.cut_off_bytes += protocol::is_cut_off(last, bytes.subspan(last_end, limit - last_end)) ? foreign : 0;
  };
  const auto keep = [&file](Flight flight) {
    flight.number = file.flights.size() + 1;
    if (!file.flights.empty()) {
      file.flights.back().goes_on = is_rest_of(flight, file.flights.back());
    }
    file.flights.push_back(std::move(flight));
  };
  while (const auto frame = reader.next()) {
    if (builder.begins_another(*frame)) {
      end_flight(frame->position);
      keep(builder.take());
      builder = {};
      begun = false;
    }
    file.foreign_places += reader.foreign_bytes() > foreign_before ? 1 : 0;
    foreign_before = reader.foreign_bytes();
    last = frame;
    last_end = reader.position();
    if (file.flights.size() == most_flights) {
      file.records_left_out += 1;
      continue;
    }
    builder.add(*frame);
    begun = true;
  }
  if (begun) {
    keep(builder.take());
  }
  end_flight(bytes.size());
  file.foreign_bytes = reader.foreign_bytes();
  file.foreign_places += file.foreign_bytes > foreign_before ? 1 : 0;
  return file;
}

}  // namespace fantail::flight_log
