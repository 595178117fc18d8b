// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "flight_log/flight_log.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::flight_log {

/// One flight, made from its records as they come.
class FlightBuilder {
 public:
  /// A record of another flight: another header, a sequence that goes back, a clock that was set back.
  [[nodiscard]] bool begins_another(const protocol::LogFrame& frame) const;

  void add(const protocol::LogFrame& frame);

  /// The bytes of the frames are needed until here.
  [[nodiscard]] Flight take();

 private:
  void note_place(const protocol::LogFrameHead& head);
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

}  // namespace fantail::flight_log
