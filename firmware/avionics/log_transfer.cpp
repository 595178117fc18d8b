// SPDX-License-Identifier: MIT
#include "avionics/log_transfer.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "avionics/can_frame.hpp"
#include "protocol/bus_codec.hpp"
#include "protocol/crc32c.hpp"

namespace fantail::avionics {

using protocol::LogAction;
using protocol::LogFault;
using protocol::LogState;

void LogTransfer::answer(LogState state, std::uint32_t number, std::uint16_t extra) {
  reply_ = {.state = state, .tag = tag_, .number = number, .extra = extra};
  reply_due_ = true;
}

void LogTransfer::give_up(LogFault fault) {
  answer(LogState::refused);
  reply_.fault = fault;
}

void LogTransfer::receive(const protocol::LogRequest& request, const Right& right) {
  if (const auto fault = refusal(request, right)) {
    refusal_ = {.state = LogState::refused, .fault = *fault, .tag = request.tag};
    return;
  }
  refusal_.reset();
  tag_ = request.tag;
  size_ = 0;
  reply_due_ = false;
  switch (request.action) {
    case LogAction::info:
      erasing_ ? answer(LogState::erasing, flights_.used_bytes())
               : answer(LogState::ready, flights_.used_bytes(), free_kib());
      break;
    case LogAction::read:
    case LogAction::plan: begin_read(request); break;
    case LogAction::erase: begin_erase(request); break;
  }
}

void LogTransfer::begin_read(const protocol::LogRequest& request) {
  of_plan_ = request.action == LogAction::plan;
  offset_ = request.offset;
  size_ = request.size;
  read_ = 0;
  crc_ = 0;
  buffered_ = 0;
  sent_ = 0;
  index_ = 0;
}

// Meets BUS-1, REC-1.
std::optional<LogFault> LogTransfer::refusal(const protocol::LogRequest& request, const Right& right) const {
  if (!right.safe) {
    return LogFault::not_safe;
  }
  const auto is_within = [&request](std::size_t bytes) {
    return request.size > 0 && request.size <= protocol::largest_log_chunk && request.size <= bytes &&
           request.offset <= bytes - request.size;
  };
  if (request.action == LogAction::plan) {
    return is_within(plan_block_.size()) ? std::nullopt : std::optional{LogFault::out_of_range};
  }
  if (request.action == LogAction::erase && right.session != request.offset) {
    return LogFault::no_session;
  }
  if (flights_.failed()) {
    return LogFault::flash_failed;
  }
  if (!flights_.finished()) {
    return LogFault::not_counted_yet;
  }
  if (request.action == LogAction::erase) {
    return refusal_of_erase(request, right);
  }
  if (request.action == LogAction::info) {
    return std::nullopt;
  }
  if (flights_.erasing()) {
    return LogFault::busy;
  }
  return is_within(flights_.used_bytes()) ? std::nullopt : std::optional{LogFault::out_of_range};
}

std::optional<LogFault> LogTransfer::refusal_of_erase(const protocol::LogRequest& request, const Right& right) const {
  const bool goes_on = erasing_ && eraser_ == request.offset;
  const bool busy = right.flash_in_use || flights_.erasing();  // also with the last sector of an erase that was stopped
  return !goes_on && busy ? std::optional{LogFault::busy} : std::nullopt;
}

void LogTransfer::begin_erase(const protocol::LogRequest& request) {
  if (!erasing_ && flights_.used_bytes() == 0) {
    answer(LogState::erased, 0, free_kib());
  } else if (erasing_ || flights_.begin_erase()) {
    erasing_ = true;
    eraser_ = request.offset;
    answer(LogState::erasing, flights_.used_bytes());
  } else {
    give_up(LogFault::busy);
  }
}

void LogTransfer::update(core::Microseconds now, const Right& right) {
  if (erasing_) {
    follow_erase(now, right);
  }
  if (size_ > 0 && !right.safe) {
    size_ = 0;
    give_up(LogFault::not_safe);
  }
}

void LogTransfer::follow_erase(core::Microseconds now, const Right& right) {
  if (!right.safe || right.session != eraser_) {
    flights_.stop_erase();
    erasing_ = false;
    give_up(right.safe ? LogFault::no_session : LogFault::not_safe);
  } else if (flights_.failed()) {
    erasing_ = false;
    give_up(LogFault::flash_failed);
  } else if (!flights_.erasing()) {
    erasing_ = false;
    answer(LogState::erased, flights_.used_bytes(), free_kib());
  } else if (!reply_due_ && (!last_reply_ || now - *last_reply_ >= report_period)) {
    answer(LogState::erasing, flights_.used_bytes());
  }
}

bool LogTransfer::read(core::Microseconds now) {
  if (read_ >= size_ || sent_ < buffered_ || of_plan_) {
    return false;
  }
  const auto bytes = room_for_next_bytes();
  const Access access = flights_.read(now, offset_ + read_, bytes);
  if (access == Access::failed) {
    size_ = 0;
    give_up(LogFault::flash_failed);
  } else if (access == Access::done) {
    keep_to_send(bytes);
  }
  return true;
}

void LogTransfer::read_plan() {
  const auto bytes = room_for_next_bytes();
  std::ranges::copy(plan_block_.subspan(offset_ + read_, bytes.size()), bytes.begin());
  keep_to_send(bytes);
}

std::span<std::byte> LogTransfer::room_for_next_bytes() {
  return std::span{buffer_}.first(std::min<std::size_t>(buffer_.size(), size_ - read_));
}

// They stand at the beginning of the buffer.
void LogTransfer::keep_to_send(std::span<const std::byte> bytes) {
  crc_ = protocol::crc32c(crc_, bytes);
  read_ = static_cast<std::uint16_t>(read_ + bytes.size());
  buffered_ = bytes.size();
  sent_ = 0;
}

void LogTransfer::send(core::Microseconds now, const Right& right, hal::CanBus& bus) {
  if (of_plan_ && read_ < size_ && sent_ == buffered_) {
    read_plan();
  }
  const std::size_t most = right.session ? frames_a_tick_in_session : frames_a_tick;
  for (std::size_t i = 0; i < most && size_ > 0 && sent_ < buffered_; ++i) {
    if (!send_data(bus)) {
      return;  // nor is there room for the answer
    }
  }
  if (size_ > 0 && read_ == size_ && sent_ == buffered_) {
    answer(LogState::read, crc_, size_);
    size_ = 0;
  }
  send_replies(now, bus);
}

void LogTransfer::send_replies(core::Microseconds now, hal::CanBus& bus) {
  if (refusal_ && may_reply(now) && bus.send(can_frame(encode(*refusal_)))) {
    refusal_.reset();
    last_reply_ = now;
  }
  if (reply_due_ && may_reply(now) && bus.send(can_frame(encode(reply_)))) {
    reply_due_ = false;
    last_reply_ = now;
  }
}

bool LogTransfer::may_reply(core::Microseconds now) const { return !last_reply_ || now - *last_reply_ >= reply_gap; }

bool LogTransfer::send_data(hal::CanBus& bus) {
  const auto rest = std::span{buffer_}.first(buffered_).subspan(sent_);
  protocol::LogData data{.index = index_};
  std::ranges::copy(rest.first(std::min(rest.size(), bytes_a_frame)), data.bytes.begin());
  if (!bus.send(can_frame(encode(data)))) {
    return false;
  }
  sent_ += std::min(rest.size(), bytes_a_frame);
  index_ += 1;
  return true;
}

std::uint16_t LogTransfer::free_kib() const {
  constexpr std::uint32_t most = std::numeric_limits<std::uint16_t>::max();
  return static_cast<std::uint16_t>(std::min(flights_.free_bytes().value_or(0) / 1024U, most));
}

}  // namespace fantail::avionics
