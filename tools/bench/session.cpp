// SPDX-License-Identifier: MIT
#include "bench/session.hpp"

#include "avionics/can_frame.hpp"
#include "bench/words.hpp"

namespace fantail::bench {
namespace {

using hal::Microseconds;
using protocol::SessionAction;

constexpr Microseconds heartbeat_period{20'000};
constexpr Microseconds request_period{5'000};
constexpr Microseconds glance{2'000};
constexpr Microseconds patience{2'000'000};
constexpr Microseconds answer_time{500'000};
// The very first motion after power-up is slow: 30 deg/s from wherever the canards were left.
constexpr Microseconds centring_time{1'500'000};

template <typename Message>
std::uint64_t count(const AvionicsLink& link) {
  const auto& heard = link.newest<Message>();
  return heard ? heard->count : 0;
}

void send(Place& place, const protocol::BusFrame& frame) {
  // A frame that finds no room is not missed: there will be another within 20 ms.
  (void)place.bus().send(avionics::can_frame(frame));
}

}  // namespace

void await_avionics(Place& place, AvionicsLink& link) {
  const Microseconds give_up = place.now() + patience;
  const auto complete = [&] {
    return count<protocol::HeartbeatReport>(link) > 0 && count<protocol::LimitReport>(link) > 0;
  };
  for (link.listen(place.now()); !complete(); link.listen(place.now())) {
    if (place.now() >= give_up) {
      throw LinkError{
          link.figures().frames == 0
              ? "the avionics is silent: is it powered, is the bus terminated at both ends, and does it run "
                "at 1 Mbit/s?"
              : "the avionics speaks, but its heartbeat does not come: is the bus overloaded?"};
    }
    place.wait(glance);
  }
  const int version = link.newest<protocol::HeartbeatReport>()->message.version;
  if (version != protocol::bus_protocol_version) {
    throw LinkError{"the avionics speaks version " + std::to_string(version) +
                    " of the bus protocol; this program knows " + std::to_string(int{protocol::bus_protocol_version})};
  }
}

Session::Session(Place& place, AvionicsLink& link, std::uint16_t number) : place_{place}, link_{link}, number_{number} {
  open();
  try {
    learn_trims();
  } catch (...) {
    (void)close();
    throw;
  }
}

Session::~Session() {
  try {
    (void)close();
  } catch (...) {  // a second Ctrl-C: the avionics centres the canards by itself, 100 ms after the last heartbeat
  }
}

void Session::open() {
  const std::uint64_t before = count<protocol::SessionReply>(link_);
  const Microseconds give_up = place_.now() + answer_time;
  std::optional<protocol::SessionReply> answer;
  while (!(answer = answer_since(before))) {
    if (place_.now() >= give_up) {
      throw LinkError{"the avionics did not answer the request for a bench session"};
    }
    if (place_.now() >= next_heartbeat_) {
      next_heartbeat_ = place_.now() + heartbeat_period;
      say(SessionAction::open);
    }
    place_.wait(glance);
    link_.listen(place_.now());
  }
  if (answer->state != protocol::SessionState::open) {
    throw LinkError{"the avionics refuses a bench session: " + words(answer->reason)};
  }
  open_ = true;
}

// By what they are told when nobody asks for anything.
void Session::learn_trims() {
  wait(centring_time);
  const auto& report = link_.newest<protocol::CommandReport>();
  for (std::size_t i = 0; report && i < trims_.size(); ++i) {
    trims_[i] = report->message.angle[i].value_or(core::Angle{});
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
  link_.listen(place_.now());
  speak();
  check_still_open();
}

void Session::speak() {
  const Microseconds now = place_.now();
  if (now >= next_heartbeat_) {
    next_heartbeat_ = now + heartbeat_period;
    say(SessionAction::keep);
  }
  if (wanted_ && now >= next_request_) {
    next_request_ = now + request_period;
    send(place_, encode(protocol::BenchRequest{*wanted_}, request_counter_));
    request_counter_ = (request_counter_ + 1U) & 0xFU;
  }
}

void Session::say(SessionAction action) {
  send(place_, encode(protocol::BenchSession{.action = action, .session = number_}, heartbeat_counter_));
  heartbeat_counter_ = (heartbeat_counter_ + 1U) & 0xFU;
}

std::optional<protocol::SessionReply> Session::answer_since(std::uint64_t before) const {
  const auto& heard = link_.newest<protocol::SessionReply>();
  return heard && heard->count > before && heard->message.session == number_ ? std::optional{heard->message}
                                                                             : std::nullopt;
}

void Session::check_still_open() const {
  const auto& reply = link_.newest<protocol::SessionReply>()->message;
  if (reply.session == number_ && reply.state == protocol::SessionState::closed) {
    throw LinkError{"the avionics has ended the bench session: " + words(reply.reason)};
  }
  if (!link_.recent<protocol::StatusReport>(place_.now(), patience)) {
    throw LinkError{"the avionics has fallen silent; it centres the canards by itself"};
  }
}

bool Session::close() {
  if (!open_) {
    return true;
  }
  open_ = false;
  const std::uint64_t before = count<protocol::CommandReport>(link_);
  const Microseconds give_up = place_.now() + answer_time;
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
    if (place_.now() >= give_up) {
      return false;
    }
    if (i % 10 == 0) {
      say(SessionAction::close);
    }
    place_.wait(glance);
    link_.listen(place_.now());
  }
  return true;
}

Recording perform(const Exercise& exercise, Session& session, AvionicsLink& link,
                  const std::function<void(double)>& progress) {
  Recording recording;
  link.forget_ticks();
  std::optional<std::int64_t> first;
  double done_s = 0.0;
  session.request(exercise.asked(0.0));
  while (done_s < exercise.duration_s()) {
    session.wait();
    while (auto tick = link.take_tick()) {
      first = first.value_or(tick->number);
      done_s = 1e-3 * static_cast<double>(tick->number - *first);
      tick->stretch = exercise.stretch_at(done_s);
      (void)recording.add(*tick);
    }
    session.request(exercise.asked(done_s));
    progress(done_s);
  }
  return recording;
}

}  // namespace fantail::bench
