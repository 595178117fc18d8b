// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flight_region.hpp"
#include "core/time.hpp"
#include "hal/can_bus.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// The flight record on its way to the bench, one chunk at a time, and its erase on the bench's word; and, by the same
/// frames, the block of the plan in force.
///
/// A chunk is read from the flash five frames at a time and sent as fast as the bus takes it; its CRC-32C comes last. A
/// chunk of the plan needs no flash.
/// A new request takes the place of the one before, unless it is refused: then the one before goes on. An erase begins,
/// and goes on, only in Safe while the session of the bench that asked is open: without it the erase stops after the
/// sector that it is at, which leaves a record whose beginning is whole.
class LogTransfer {
 public:
  /// With all other frames of a millisecond in Safe, the bus carries so many; every millisecond of an open bench
  /// session has two reports more, and a request.
  static constexpr std::size_t frames_a_tick = 5;
  static constexpr std::size_t frames_a_tick_in_session = 3;
  static constexpr core::Microseconds report_period{100'000};
  /// Two replies are at least this far apart, whoever asks.
  static constexpr core::Microseconds reply_gap{20'000};

  struct Right {
    bool safe = false;                       ///< the phase is Safe
    std::optional<std::uint16_t> session{};  ///< of a bench
    bool flash_in_use = false;               ///< by somebody who goes first
  };

  /// The region outlives this object and is updated by its owner; so does the block, which keeps its size.
  explicit LogTransfer(FlightRegion& flights, std::span<const std::byte> plan_block = {})
      : flights_{flights}, plan_block_{plan_block} {}

  void receive(const protocol::LogRequest& request, const Right& right);

  /// Once a tick, after what it received and before the region is updated. No call to the flash.
  void update(core::Microseconds now, const Right& right);
  /// In a tick in which nobody else has the flash: true when it has made its one call.
  bool read(core::Microseconds now);
  /// Once a tick, behind the reports, which are more urgent.
  void send(core::Microseconds now, const Right& right, hal::CanBus& bus);

 private:
  static constexpr std::size_t bytes_a_frame = std::tuple_size_v<decltype(protocol::LogData::bytes)>;

  void answer(protocol::LogState state, std::uint32_t number = 0, std::uint16_t extra = 0);
  void give_up(protocol::LogFault fault);
  [[nodiscard]] std::optional<protocol::LogFault> refusal(const protocol::LogRequest& request,
                                                          const Right& right) const;
  [[nodiscard]] std::optional<protocol::LogFault> refusal_of_erase(const protocol::LogRequest& request,
                                                                   const Right& right) const;
  void begin_read(const protocol::LogRequest& request);
  void begin_erase(const protocol::LogRequest& request);
  void read_plan();
  void keep_to_send(std::span<const std::byte> bytes);
  [[nodiscard]] std::span<std::byte> room_for_next_bytes();
  [[nodiscard]] bool may_reply(core::Microseconds now) const;
  void follow_erase(core::Microseconds now, const Right& right);
  [[nodiscard]] bool send_data(hal::CanBus& bus);
  void send_replies(core::Microseconds now, hal::CanBus& bus);
  [[nodiscard]] std::uint16_t free_kib() const;

  FlightRegion& flights_;
  std::span<const std::byte> plan_block_;
  protocol::LogReply reply_{};
  bool reply_due_ = false;
  std::optional<protocol::LogReply> refusal_;  ///< of a request, beside what goes on
  std::optional<core::Microseconds> last_reply_;
  std::uint8_t tag_ = 0;  ///< of the newest request that was not refused

  bool erasing_ = false;
  std::uint32_t eraser_ = 0;  ///< the session of the bench that asked for it

  bool of_plan_ = false;                                           ///< the chunk that is being sent
  std::uint32_t offset_ = 0;                                       ///< of it
  std::uint16_t size_ = 0;                                         ///< of it; 0: none
  std::uint16_t read_ = 0;                                         ///< bytes of it that have been read
  std::uint32_t crc_ = 0;                                          ///< of these
  std::array<std::byte, frames_a_tick * bytes_a_frame> buffer_{};  ///< the last of these
  std::size_t buffered_ = 0;
  std::size_t sent_ = 0;  ///< bytes of the buffer
  std::uint8_t index_ = 0;
};

}  // namespace fantail::avionics
