// SPDX-License-Identifier: MIT
#include "link/session.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "avionics/can_frame.hpp"
#include "replies/sentence.hpp"

namespace fantail::link {
namespace {

using hal::Microseconds;
using protocol::SessionAction;

constexpr Microseconds heartbeat_period{20'000};
constexpr Microseconds request_period{5'000};
constexpr Microseconds longest_pause{60'000};  // 80 ms since the last heartbeat; the avionics waits for 100
constexpr Microseconds glance{2'000};
constexpr int portion = 32;  // frames
constexpr int most_portions = 30;
constexpr Microseconds answer_time{2'000'000};
// The very first motion after power-up is slow, down to 5 deg/s from wherever the canards were left.
constexpr Microseconds centring_look{500'000};
constexpr Microseconds centring_time{10'000'000};

std::string tenths(Microseconds time) { return fmt::format("{:.1f} s", 1e-6 * static_cast<double>(time.count())); }

void send(Place& place, const protocol::BusFrame& frame) {
  // A frame that finds no room is not missed: there will be another within 20 ms.
  (void)place.bus().send(avionics::can_frame(frame));
}

LinkError another_bench() {
  return LinkError{"another bench has the session; end that one, or wait until it has ended"};
}

}  // namespace

Session::Session(Place& place, AvionicsLink& link, std::uint16_t number) : place_{place}, link_{link}, number_{number} {
  look_for_another_bench();
  open();
  try {
    learn_trims();
  } catch (...) {
    (void)close();
    throw;
  }
}

// Meets BEN-9.
Session::~Session() {
  try {
    (void)close();
  } catch (...) {  // NOLINT(bugprone-empty-catch): a second Ctrl-C; without heartbeats the avionics centres the canards
  }
}

// The status comes every 10 ms. Who asks while another bench is at work is refused; a look asks for nothing.
void Session::look_for_another_bench() {
  link_.listen(place_.now());
  const std::uint64_t before = link_.count<protocol::StatusReport>();
  for (Timeout timeout{answer_time, place_.now()}; link_.count<protocol::StatusReport>() == before;) {
    if (timeout.expired(place_.now())) {
      throw LinkError{"the avionics has stopped reporting"};
    }
    place_.wait(glance);
    link_.listen(place_.now());
  }
  link_.expect_one_rocket();
  if (link_.reported<protocol::StatusReport>("state").session_open) {
    throw another_bench();
  }
}

void Session::open() {
  protocol::SessionReply answer = ask_to_open();  // NOLINT(misc-const-correctness): it is assigned below
  if (answer.reason == protocol::SessionReason::number_too_similar) {
    number_ ^= 1U;  // a single bit always makes another CRC-8
    answer = ask_to_open();
  }
  if (answer.state != protocol::SessionState::open) {
    if (answer.reason == protocol::SessionReason::heartbeat_lost) {  // it had opened, while this process stood still
      tell_end(answer.reason);
    }
    link::look_for_second_rocket(place_, link_);
    throw answer.reason == protocol::SessionReason::other_session
        ? another_bench()
        : LinkError{"the avionics refuses a bench session: " + replies::sentence(answer.reason)};
  }
  open_ = true;
}

protocol::SessionReply Session::ask_to_open() {
  const std::uint64_t before = link_.count<protocol::SessionReply>();
  Timeout timeout{answer_time, place_.now()};
  std::optional<protocol::SessionReply> answer;
  last_look_ = place_.now();
  while (!(answer = answer_since(before))) {
    if (timeout.expired(place_.now())) {
      throw LinkError{"the avionics did not answer the request for a bench session"};
    }
    if (place_.now() >= next_heartbeat_) {
      next_heartbeat_ = place_.now() + heartbeat_period;
      say(SessionAction::open);
    }
    place_.wait(glance);
    link_.listen(place_.now());
    note_look(place_.now());
  }
  return *answer;
}

// By what they are told when nobody asks for anything, once that stands still.
void Session::learn_trims() {
  std::optional<protocol::PerCanard> before;
  for (Timeout timeout{centring_time, place_.now()}; !timeout.expired(place_.now());) {
    wait(centring_look);
    const auto& report = link_.newest<protocol::CommandReport>();
    if (report && before == report->message.angle) {
      break;
    }
    before = report ? std::optional{report->message.angle} : std::nullopt;
  }
  for (std::size_t i = 0; before && i < trims_.size(); ++i) {
    trims_[i] = (*before)[i].value_or(core::Angle{});
  }
}

void Session::wait(Microseconds duration) {
  for (const Microseconds end = place_.now() + duration; place_.now() < end;) {
    wait();
  }
}

void Session::wait() {
  speak();
  place_.wait(glance);
  // In portions, with heartbeats in between: on a busy PC the frames that have come may be many.
  for (int portions = 0; portions < most_portions; ++portions) {
    speak();
    if (!link_.listen(place_.now(), portion)) {
      break;
    }
  }
  check_still_open();
}

void Session::speak() {
  const Microseconds now = place_.now();
  note_look(now);
  if (open_ && now > next_heartbeat_ + longest_pause) {
    // Meets BEN-3.
    // This process stood still for so long that the session may be over, and another bench at work: a request waits
    // until the avionics has named this session once more.
    (void)link_.listen(now);
    unsure_since_ = link_.count<protocol::SessionReply>();
  }
  if (now >= next_heartbeat_) {
    next_heartbeat_ = now + heartbeat_period;
    say(SessionAction::keep);
  }
  if (const auto answer = unsure_since_ ? answer_since(*unsure_since_) : std::nullopt;
      answer && answer->state == protocol::SessionState::open) {
    unsure_since_.reset();
  }
  if (wanted_ && !unsure_since_ && now >= next_request_) {
    next_request_ = now + request_period;
    send(place_, encode(protocol::BenchRequest{*wanted_}, request_counter_.next(), number_));
  }
}

void Session::note_look(Microseconds now) {
  longest_gap_ = std::max(longest_gap_, now - std::exchange(last_look_, now));
}

void Session::say(SessionAction action) {
  send(place_, encode(protocol::BenchSession{.action = action, .session = number_}, heartbeat_counter_.next()));
}

std::optional<protocol::SessionReply> Session::answer_since(std::uint64_t before) const {
  const auto& heard = link_.newest<protocol::SessionReply>();
  return heard && heard->count > before && heard->message.session == number_ ? std::optional{heard->message}
                                                                             : std::nullopt;
}

void Session::check_still_open() const {
  if (place_.bus().state() == hal::CanState::down) {
    throw LinkError{
        "the CAN interface is down; the avionics centres the canards by itself 0.1 s after the last heartbeat"};
  }
  link_.expect_one_rocket();
  const auto& reply = link_.reported<protocol::SessionReply>("bench session");
  if (reply.session == number_ && reply.state == protocol::SessionState::closed) {
    tell_end(reply.reason);
  }
  // Whoever was stopped for a while may find somebody else at work, and must not speak into that.
  if (reply.session != number_ && reply.state == protocol::SessionState::open) {
    throw LinkError{"the bench session has ended, and another bench has opened one"};
  }
  if (link_.has_fallen_silent()) {
    throw LinkError{"the avionics has stopped reporting; it centres the canards by itself if it still runs"};
  }
}

void Session::tell_end(protocol::SessionReason reason) const {
  link::look_for_second_rocket(place_, link_);
  std::string known;  // NOLINT(misc-const-correctness): it is assigned below
  if (reason == protocol::SessionReason::heartbeat_lost) {
    known =
        longest_gap_ > longest_pause
            ? ", and this PC, suspended or too busy, sent no heartbeat for " + tenths(longest_gap_)
            : fmt::format(
                  ", although this PC never paused for more than {} ms: frames were lost, or the avionics stood still",
                  longest_gap_.count() / 1000);
  }
  throw LinkError{"the avionics has ended the bench session: " + replies::sentence(reason) + known};
}

void Session::look_for_second_rocket() {
  link::look_for_second_rocket(place_, link_, [this] { speak(); });
}

bool Session::close() {
  if (!open_) {
    return true;
  }
  const std::uint64_t before = link_.count<protocol::CommandReport>();
  Timeout timeout{answer_time, place_.now()};
  const auto at_trims = [&] {
    const auto& report = link_.newest<protocol::CommandReport>();
    const auto& reply = link_.newest<protocol::SessionReply>();
    if (!report || report->count == before || !reply || reply->message.state == protocol::SessionState::open) {
      return false;
    }
    for (std::size_t i = 0; i < trims_.size(); ++i) {
      if (report->message.angle[i] && abs(*report->message.angle[i] - trims_[i]) > core::Angle::from_degrees(0.1F)) {
        return false;
      }
    }
    return true;
  };
  for (int i = 0; !at_trims(); ++i) {
    if (timeout.expired(place_.now())) {
      open_ = false;  // nothing more can be done from here
      return false;
    }
    if (i % 10 == 0) {
      say(SessionAction::close);
    }
    place_.wait(glance);  // may throw: then the canards have not been seen at their trims, and the next call goes on
    link_.listen(place_.now());
  }
  open_ = false;
  return true;
}

}  // namespace fantail::link
