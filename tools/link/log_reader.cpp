// SPDX-License-Identifier: MIT
#include "link/log_reader.hpp"

#include <algorithm>
#include <string>

#include "avionics/can_frame.hpp"
#include "protocol/crc32c.hpp"
#include "replies/sentence.hpp"

namespace fantail::link {
namespace {

using hal::Microseconds;
using protocol::LogAction;
using protocol::LogFault;
using protocol::LogState;

constexpr std::size_t bytes_a_frame = std::tuple_size_v<decltype(protocol::LogData::bytes)>;
constexpr std::size_t fewest_frames = 8;
constexpr Microseconds glance{2'000};
constexpr Microseconds repeat_after{100'000};
// A chunk takes 90 ms at its slowest, and the answer may overtake the last of its frames.
constexpr Microseconds silence{150'000};
constexpr Microseconds straggling{20'000};
constexpr Microseconds answer_time{5'000'000};
// The look through 16 MiB takes four seconds.
constexpr Microseconds look_time{15'000'000};
// An erase of one sector may take 400 ms.
constexpr Microseconds erase_time{3'000'000};
// Of one rocket alone: two seconds, and on a busy PC longer. Of a second one some would have come between them.
constexpr std::uint64_t heartbeats_before_erase = 20;
constexpr Microseconds time_to_be_sure{15'000'000};

std::string name(LogAction what) { return what == LogAction::plan ? "plan" : "flight record"; }

[[noreturn]] void refuse(LogAction what, LogFault fault) {
  throw LinkError{"the " + name(what) + " of the avionics cannot be read: " + replies::sentence(fault)};
}

[[noreturn]] void silent(LogAction what) {
  throw LinkError{"the avionics does not answer when asked for its " + name(what) +
                  (what == LogAction::plan ? "; is its firmware older than this program?" : "")};
}

}  // namespace

void LogReader::ask(LogAction action, std::uint32_t offset, std::uint16_t size) {
  link_.listen(place_.now());
  link_.expect_one_rocket();
  link_.forget_log_data();
  tag_ = (tag_ + 1U) & 0x0FU;
  heard_before_ = link_.count<protocol::LogReply>();
  const protocol::LogRequest request{.action = action, .tag = tag_, .offset = offset, .size = size};
  (void)place_.bus().send(avionics::can_frame(encode(request, counter_.next())));
}

std::optional<protocol::LogReply> LogReader::answer() const {
  const auto& newest = link_.newest<protocol::LogReply>();
  const bool is_new = newest && newest->count > heard_before_ && newest->message.tag == tag_;
  return is_new ? std::optional{newest->message} : std::nullopt;
}

LogInfo LogReader::info() {
  Timeout look{look_time, place_.now()};
  Timeout any_answer{answer_time, place_.now()};
  while (true) {
    ask(LogAction::info, 0, 0);
    std::optional<protocol::LogReply> reply;
    for (const Microseconds end = place_.now() + repeat_after; !reply && place_.now() < end; reply = answer()) {
      place_.wait(glance);
      link_.listen(place_.now());
    }
    if (reply && reply->state == LogState::ready) {
      return {.used_bytes = reply->number, .free_bytes = 1024U * reply->extra};
    }
    // Another bench may be erasing, which is not waited for either.
    if (reply && reply->state == LogState::refused && reply->fault != LogFault::not_counted_yet) {
      refuse(LogAction::info, reply->fault);
    }
    const bool too_long = look.expired(place_.now());
    if (reply) {
      if (too_long) {
        refuse(LogAction::info, reply->state == LogState::refused ? reply->fault : LogFault::busy);
      }
      any_answer.restart();
      place_.wait(repeat_after);
    } else if (any_answer.expired(place_.now())) {
      silent(LogAction::info);
    }
  }
}

std::vector<std::byte> LogReader::read(std::uint32_t offset, std::uint32_t size) {
  return read(LogAction::read, offset, size);
}

std::vector<std::byte> LogReader::plan_block() {
  const std::vector<std::byte> header = read(LogAction::plan, 0, protocol::plan_block_header_size);
  const std::size_t size = protocol::announced_plan_block_size(header);
  std::vector<std::byte> block;
  while (block.size() < size) {
    const auto begin = static_cast<std::uint32_t>(block.size());
    const std::vector<std::byte> part = read(LogAction::plan, begin, static_cast<std::uint32_t>(size) - begin);
    block.insert(block.end(), part.begin(), part.end());
  }
  return block;
}

std::vector<std::byte> LogReader::read(LogAction what, std::uint32_t offset, std::uint32_t size) {
  const std::uint64_t answers_before = link_.count<protocol::LogReply>();
  Timeout timeout{answer_time, place_.now()};
  while (true) {
    const auto now_size = static_cast<std::uint16_t>(std::min<std::size_t>(size, frames_at_once_ * bytes_a_frame));
    if (auto bytes = try_to_read(what, offset, now_size)) {
      frames_at_once_ = std::min(2 * frames_at_once_, most_frames);
      return *bytes;
    }
    repeated_ += 1;
    frames_at_once_ = std::max(frames_at_once_ / 2, fewest_frames);
    if (timeout.expired(place_.now())) {
      if (link_.count<protocol::LogReply>() == answers_before) {
        silent(what);
      }
      throw LinkError{"the " + name(what) + " of the avionics does not arrive complete: is the bus disturbed?"};
    }
  }
}

// Empty: something was lost or damaged on the way.
std::optional<std::vector<std::byte>> LogReader::try_to_read(LogAction what, std::uint32_t offset, std::uint16_t size) {
  std::vector<std::byte> bytes((size + bytes_a_frame - 1) / bytes_a_frame * bytes_a_frame);
  arrived_.assign(bytes.size() / bytes_a_frame, false);
  ask(what, offset, size);
  Microseconds last_heard = place_.now();
  std::optional<Microseconds> answered;
  while (true) {
    place_.wait(glance);
    link_.listen(place_.now());
    last_heard = take_data(bytes) ? place_.now() : last_heard;
    const auto reply = answer();
    if (reply && reply->state == LogState::refused) {
      if (reply->fault == LogFault::busy || reply->fault == LogFault::not_counted_yet) {
        place_.wait(repeat_after);
        return std::nullopt;
      }
      refuse(what, reply->fault);
    }
    const bool complete = std::ranges::find(arrived_, false) == arrived_.end();
    if (reply && complete) {
      bytes.resize(size);
      const bool whole = reply->state == LogState::read && reply->extra == size;
      return whole && reply->number == protocol::crc32c(bytes) ? std::optional{std::move(bytes)} : std::nullopt;
    }
    answered = reply && !answered ? place_.now() : answered;
    if ((answered && place_.now() - *answered > straggling) || place_.now() - last_heard > silence) {
      return std::nullopt;
    }
  }
}

bool LogReader::take_data(std::vector<std::byte>& bytes) {
  bool any = false;
  while (const auto data = link_.take_log_data()) {
    any = true;
    if (data->index < arrived_.size()) {
      std::ranges::copy(data->bytes, bytes.begin() + static_cast<std::ptrdiff_t>(data->index * bytes_a_frame));
      arrived_[data->index] = true;
    }
  }
  return any;
}

// A second rocket would have heard the session begin, too, and obey it.
void LogReader::expect_one_rocket(Session& session) {
  Timeout timeout{time_to_be_sure, place_.now()};
  const std::uint64_t enough = link_.count<protocol::HeartbeatReport>() + heartbeats_before_erase;
  while (link_.count<protocol::HeartbeatReport>() < enough) {
    session.wait();
    if (timeout.expired(place_.now())) {
      throw LinkError{"too few heartbeats arrived to be sure that only one rocket is on the bus; nothing is erased"};
    }
  }
}

void LogReader::erase(Session& session, const std::function<void(std::uint32_t)>& progress) {
  expect_one_rocket(session);
  ask(LogAction::erase, session.number(), 0);
  Microseconds asked = place_.now();
  Timeout any_answer{answer_time, asked};
  Timeout next_sector{erase_time, asked};
  std::uint64_t seen = heard_before_;
  while (true) {
    session.wait();
    const Microseconds now = place_.now();
    const auto reply = answer();
    const std::uint64_t count = reply ? link_.count<protocol::LogReply>() : seen;
    if (reply && count != seen) {
      seen = count;
      any_answer.restart();
      next_sector.restart();
      if (reply->state == LogState::erased) {
        return;
      }
      if (reply->state == LogState::refused && reply->fault != LogFault::busy) {
        throw LinkError{"the avionics does not erase its flight record: " + replies::sentence(reply->fault)};
      }
      progress(reply->number);
    }
    const bool waits = reply && reply->state == LogState::erasing;
    if (!waits && now - asked > repeat_after) {
      ask(LogAction::erase, session.number(), 0);
      asked = now;
      seen = heard_before_;
    }
    const bool no_answer = any_answer.expired(now);
    const bool no_sector = next_sector.expired(now);
    if (waits ? no_sector : no_answer) {
      throw LinkError{"the avionics stopped answering while it erased its flight record; try again"};
    }
  }
}

}  // namespace fantail::link
