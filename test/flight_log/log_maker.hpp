// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "core/autopilot.hpp"
#include "flight_log/regenerate.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_notes.hpp"
#include "protocol/log_schema.hpp"
#include "protocol/log_tick.hpp"
#include "protocol/plan_block.hpp"
#include "protocol/state_block.hpp"

namespace fantail::flight_log {

/// Writes a log in the simplest way, record behind record. Nothing of the product's recorder is used.
class LogMaker {
 public:
  void record(protocol::LogRecord type, core::Microseconds time, std::span<const std::byte> payload) {
    const std::size_t begin = bytes_.size();
    append(protocol::encode(protocol::LogFrameHead{.type = static_cast<std::uint8_t>(type),
                                                   .length = static_cast<std::uint16_t>(payload.size()),
                                                   .sequence = sequence_,
                                                   .time = time}));
    append(payload);
    std::array<std::byte, 4> checksum{};
    protocol::put<4>(checksum, 0, protocol::crc32c(std::span{bytes_}.subspan(begin)));
    append(checksum);
    sequence_ += 1;
  }

  void header(core::Microseconds time, protocol::LogHeader header, const core::FlightPlan& plan) {
    std::array<std::byte, protocol::largest_plan_block> block{};
    header.plan_block = std::span{block}.first(protocol::write_plan_block(plan, block));
    const auto fixed = protocol::encode(header);
    std::vector<std::byte> payload{fixed.begin(), fixed.end()};
    std::ranges::copy(header.plan_block, std::back_inserter(payload));
    std::ranges::transform(header.schema, std::back_inserter(payload),
                           [](char c) { return static_cast<std::byte>(c); });
    record(protocol::LogRecord::header, time, payload);
  }

  void checkpoint(core::Microseconds time, core::Autopilot& law) {
    std::array<std::byte, 2048> payload{};
    protocol::put<8>(payload, 0, static_cast<std::uint64_t>(times_.imu.count()));
    protocol::put<8>(payload, 8, static_cast<std::uint64_t>(times_.accelerometer.count()));
    const auto room = std::span{payload}.subspan(protocol::log_checkpoint_times_size);
    protocol::StateWriter writer{room};
    law.visit_state(writer);
    record(protocol::LogRecord::checkpoint, time,
           std::span{payload}.first(protocol::log_checkpoint_times_size + writer.size()));
  }

  void tick(const protocol::LogTick& tick) {
    record(protocol::LogRecord::tick, tick.time, protocol::pack(tick, times_));
  }
  void event(const protocol::LogEvent& event) { record(protocol::LogRecord::event, event.time, protocol::pack(event)); }
  void health(const protocol::LogHealth& health) {
    record(protocol::LogRecord::health, health.time, protocol::pack(health));
  }

  void append(std::span<const std::byte> more) { std::ranges::copy(more, std::back_inserter(bytes_)); }

  /// What the next record is numbered.
  [[nodiscard]] std::uint32_t sequence() const { return sequence_; }
  void skip_to(std::uint32_t sequence) { sequence_ = sequence; }
  /// Sample times as they stand before the next tick, where a log does not begin at power-up.
  void set_times(const protocol::SampleTimes& times) { times_ = times; }

  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  std::uint32_t sequence_ = 0;
  protocol::SampleTimes times_;
};

/// A header of this version, of a rocket that does not exist.
inline protocol::LogHeader some_header(std::uint32_t flight = 1) {
  return {.flight = flight,
          .power_up = 7,
          .state_layout = state_layout(),
          .rate_scale_rad_s = 0.001F,
          .specific_force_scale_m_s2 = 0.00980665F,
          .accelerometer_scale_m_s2 = 0.0980665F,
          .firmware_version = "0.1.0",
          .git_hash = "0123456789abcdef",
          .vehicle = "paper dart",
          .sensors = "imu x, accelerometer y",
          .schema = protocol::log_schema()};
}

}  // namespace fantail::flight_log
