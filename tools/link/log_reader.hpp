// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "link/avionics_link.hpp"
#include "link/place.hpp"
#include "link/session.hpp"

namespace fantail::link {

struct LogInfo {
  std::uint32_t used_bytes = 0;
  std::uint32_t free_bytes = 0;  ///< in whole KiB
};

/// Reads the flight record of the avionics, and the plan in force. Lost parts are requested again, so results are
/// complete. Every call throws LinkError when the avionics refuses, with the reason, or when nothing complete arrives
/// for five seconds.
class LogReader {
 public:
  LogReader(Place& place, AvionicsLink& link) : place_{place}, link_{link} {}

  /// Waits while the avionics looks through its flash, some seconds after power-up.
  [[nodiscard]] LogInfo info();

  /// Bytes of the record from `offset` on: as many as one request yields, at most `size`, at least one. Verified by
  /// the CRC-32C that the avionics gave. On a bus that loses frames they become fewer.
  [[nodiscard]] std::vector<std::byte> read(std::uint32_t offset, std::uint32_t size);

  /// The block of the plan in force, as long as its header says it is; it is not looked into further.
  [[nodiscard]] std::vector<std::byte> plan_block();

  /// Erases the record, after enough heartbeats to exclude a second rocket. `progress` is called with the bytes that
  /// are left. Throws LinkError when the session ends; TwoRockets.
  void erase(Session& session, const std::function<void(std::uint32_t)>& progress);

  /// Chunks that had to be requested again.
  [[nodiscard]] std::uint64_t repeated() const { return repeated_; }

 private:
  void expect_one_rocket(Session& session);
  void ask(protocol::LogAction action, std::uint32_t offset, std::uint16_t size);
  [[nodiscard]] std::vector<std::byte> read(protocol::LogAction what, std::uint32_t offset, std::uint32_t size);
  [[nodiscard]] std::optional<protocol::LogReply> answer() const;
  [[nodiscard]] std::optional<std::vector<std::byte>> try_to_read(protocol::LogAction what, std::uint32_t offset,
                                                                  std::uint16_t size);
  [[nodiscard]] bool take_data(std::vector<std::byte>& bytes);

  Place& place_;
  AvionicsLink& link_;
  protocol::FrameCounter counter_;
  std::uint8_t tag_ = 0;
  std::uint64_t heard_before_ = 0;  ///< replies, when the newest request was sent
  std::size_t frames_at_once_ = most_frames;
  std::vector<bool> arrived_;  ///< of the frames that are waited for
  std::uint64_t repeated_ = 0;

  static constexpr std::size_t most_frames = 256;
};

}  // namespace fantail::link
