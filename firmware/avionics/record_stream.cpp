// SPDX-License-Identifier: MIT
#include "avionics/record_stream.hpp"

#include <algorithm>

namespace fantail::avionics {

using protocol::LogEnd;
using protocol::LogFrameWriter;
using protocol::LogRecord;

namespace {

constexpr core::Microseconds header_period{5'000'000};
constexpr std::uint32_t room_to_look_back = 40;  // ticks
constexpr std::size_t last_frame_size = protocol::log_frame_overhead + protocol::log_event_size;

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span{text}); }

}  // namespace

void RecordStream::begin(const protocol::LogHeader& header) {
  header_ = header;
  std::ranges::copy(encode(header), header_begin_.begin());
  std::ranges::copy(encode_second_rate_scale(header), header_begin_.begin() + protocol::log_header_fixed_size);
  header_time_.reset();
  source_.reset();
  page_size_ = 0;
  page_state_ = Page::fills;
  sequence_ = 0;
  open_ = true;
  finishing_ = false;
  broken_off_.reset();
}

void RecordStream::update(core::Microseconds now) {
  if (!open_ || !settle_page(now)) {
    return;
  }
  room_ = std::min(page_.size(), region_.page_room());
  fill_page();
  const bool nothing_more = page_size_ < room_;
  if (page_size_ == room_ || (finishing_ && nothing_more && page_size_ > 0)) {
    const Access access = region_.append(now, std::span{page_}.first(page_size_));
    if (access == Access::failed) {
      broken_off_ = LogEnd::flash_failed;
      return close();
    }
    if (access == Access::done) {
      page_state_ = Page::is_looked_back_at;
      return;
    }
  }
  if (finishing_ && nothing_more && page_size_ == 0) {
    close();
  }
}

bool RecordStream::settle_page(core::Microseconds now) {
  if (page_state_ == Page::fills) {
    return true;
  }
  if (page_state_ == Page::is_passed_over) {
    const Access access = region_.pass_over(now, page_size_);
    if (access == Access::failed) {
      broken_off_ = LogEnd::flash_failed;
      close();
    } else if (access == Access::done) {
      page_state_ = Page::fills;  // it is full, and goes to the next sector
    }
    return false;
  }
  if (queue_.ticks.size() + room_to_look_back >= queue_.ticks.capacity()) {
    page_size_ = 0;
    page_state_ = Page::fills;
    return true;
  }
  switch (region_.look_back(now, std::span{page_}.first(page_size_))) {
    case FlightRegion::Kept::yes:
      page_size_ = 0;
      page_state_ = Page::fills;
      break;
    case FlightRegion::Kept::no: page_state_ = Page::is_passed_over; break;
    case FlightRegion::Kept::again: break;
    case FlightRegion::Kept::failed:
      broken_off_ = LogEnd::flash_failed;
      close();
      break;
  }
  return false;
}

void RecordStream::fill_page() {
  while (page_size_ < room_) {
    if (!frame_.done()) {
      page_size_ += frame_.write(rest_of_page());
    } else if (!begin_next()) {
      return;
    }
    if (frame_.done()) {
      release();
    }
  }
}

// The order in which records stand: what is noted before a tick, the header when it is due, the checkpoint, the tick.
bool RecordStream::begin_next() {
  const TickQueue& ticks = queue_.ticks;
  const WaitingCheckpoint& checkpoint = queue_.checkpoint;
  const bool tick_waits = ticks.size() > 0;
  if (broken_off_) {
    return false;
  }
  if (!header_time_ && tick_waits) {
    begin_header(ticks.time());
    return true;
  }
  if (!queue_.notes.empty() && queue_.notes.front().before <= ticks.first()) {
    const Note& note = queue_.notes.front();
    sequence_ += note.lost;
    begin_frame(note.type, note.time, {std::span{note.payload}.first(note.size)});
    return true;
  }
  if (!tick_waits) {
    return false;
  }
  const core::Microseconds time = ticks.time();
  if (time - *header_time_ >= header_period) {
    begin_header(time);
  } else if (checkpoint.in_the_making) {
    return false;
  } else if (checkpoint.size > 0 && checkpoint.before == ticks.first()) {
    begin_frame(LogRecord::checkpoint, time, {checkpoint.bytes()});
  } else {
    begin_frame(LogRecord::tick, time, {protocol::without_empty_room(ticks.tick())});
  }
  return true;
}

void RecordStream::begin_header(core::Microseconds time) {
  header_time_ = time;
  const std::size_t begin_size =
      header_.second_rate_scale_rad_s ? header_begin_.size() : protocol::log_header_fixed_size;
  begin_frame(LogRecord::header, time,
              {std::span{header_begin_}.first(begin_size), header_.plan_block, bytes_of(header_.schema),
               bytes_of(header_.rest_of_schema)});
}

void RecordStream::begin_frame(LogRecord type, core::Microseconds time, const LogFrameWriter::Parts& payload) {
  // There is always room for the event that says that the flash was full.
  if (page_size_ + LogFrameWriter::frame_size(payload) + last_frame_size > region_.room()) {
    begin_end_of_flash(time);
    return;
  }
  page_size_ += frame_.begin({.type = static_cast<std::uint8_t>(type), .sequence = sequence_, .time = time}, payload,
                             rest_of_page());
  source_ = type;
  sequence_ += 1;
}

void RecordStream::begin_end_of_flash(core::Microseconds time) {
  broken_off_ = LogEnd::flash_full;
  finishing_ = true;
  source_.reset();
  last_event_ = protocol::pack(protocol::LogEvent{.time = time,
                                                  .kind = protocol::LogEventKind::recording_ended,
                                                  .value = static_cast<std::uint8_t>(LogEnd::flash_full)});
  page_size_ += frame_.begin({.type = static_cast<std::uint8_t>(LogRecord::event), .sequence = sequence_, .time = time},
                             {last_event_}, rest_of_page());
}

void RecordStream::release() {
  if (!source_) {
    return;
  }
  switch (*source_) {
    case LogRecord::tick: queue_.ticks.pop(); break;
    case LogRecord::checkpoint: queue_.checkpoint.size = 0; break;
    case LogRecord::event:
    case LogRecord::health: queue_.notes.pop(); break;
    case LogRecord::header: break;
  }
  source_.reset();
}

void RecordStream::close() {
  open_ = false;
  frame_.abandon();
  queue_.clear();
}

}  // namespace fantail::avionics
