// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flight_region.hpp"
#include "avionics/record_queue.hpp"
#include "core/time.hpp"
#include "protocol/log_frame_writer.hpp"
#include "protocol/log_header.hpp"
#include "protocol/log_notes.hpp"

namespace fantail::avionics {

/// Takes records out of the queue, in their order, and brings them as frames into the flash, page by page. Every five
/// seconds it repeats the header.
///
/// Each page is read back when it has been written, and what did not keep it is passed over: one more tick a page. Only
/// while the queue is nearly full is that left out; with a flash that takes 3 ms a page that is so, as long as the half
/// second before the launch waits, and of every third page.
class RecordStream {
 public:
  RecordStream(RecordQueue& queue, FlightRegion& region) : queue_{queue}, region_{region} {}
  RecordStream(const RecordStream&) = delete;
  RecordStream& operator=(const RecordStream&) = delete;

  /// Begins with a header. `header` fits into a payload, and what it refers to stays as it is while open().
  void begin(const protocol::LogHeader& header);

  /// Nothing more will come into the queue: what is in it is written, to the last byte, and then it is closed.
  void finish() { finishing_ = true; }

  /// Once a tick while it is open: at most a page (or 256 bytes of a larger one) is framed, and at most one program is
  /// begun. A busy flash is asked again in the next tick.
  void update(core::Microseconds now);

  /// From begin() until everything lies in the flash, or it is full, or it has failed.
  [[nodiscard]] bool open() const { return open_; }

 private:
  /// False: the page is not free yet, or the flash has been used in this tick.
  [[nodiscard]] bool settle_page(core::Microseconds now);
  void fill_page();
  [[nodiscard]] std::span<std::byte> rest_of_page() { return {page_.data() + page_size_, room_ - page_size_}; }
  [[nodiscard]] bool begin_next();
  void begin_frame(protocol::LogRecord type, core::Microseconds time, const protocol::LogFrameWriter::Parts& payload);
  void begin_header(core::Microseconds time);
  void begin_end_of_flash(core::Microseconds time);
  void release();
  void close();

  RecordQueue& queue_;
  FlightRegion& region_;
  protocol::LogHeader header_{};
  std::array<std::byte, protocol::log_header_fixed_size + protocol::second_rate_scale_size> header_begin_{};
  std::array<std::byte, protocol::log_event_size> last_event_{};
  protocol::LogFrameWriter frame_;
  std::optional<protocol::LogRecord> source_{};  ///< what the queue may forget when the frame is done
  std::array<std::byte, FlashAccess::read_size> page_{};
  std::size_t page_size_ = 0;  ///< bytes in it
  std::size_t room_ = 0;       ///< bytes of it that may be programmed at once
  std::uint32_t sequence_ = 0;
  std::optional<core::Microseconds> header_time_{};  ///< of the last one
  enum class Page : std::uint8_t { fills, is_looked_back_at, is_passed_over };
  Page page_state_ = Page::fills;
  bool open_ = false;
  bool finishing_ = false;
  std::optional<protocol::LogEnd> broken_off_{};  ///< why it ends without finish()
};

}  // namespace fantail::avionics
