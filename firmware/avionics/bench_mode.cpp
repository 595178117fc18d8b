// SPDX-License-Identifier: MIT
#include "avionics/bench_mode.hpp"

#include "protocol/bus_codec.hpp"

namespace fantail::avionics {

using protocol::SessionAction;
using protocol::SessionReason;
using protocol::SessionState;

bool BenchMode::receive(const Situation& now, bool self_test_runs, const protocol::BenchSession& message) {
  const bool own = session_ == message.session;
  switch (message.action) {
    case SessionAction::keep:
      if (own) {
        last_heard_ = now.time;
      }
      return own;
    case SessionAction::close:
      if (own) {
        close(SessionReason::closed_by_bench);
      }
      return own;
    case SessionAction::open: break;
  }
  if (own) {  // the bench repeats itself until it has seen the answer
    last_heard_ = now.time;
    become(SessionState::open, SessionReason::opened, message.session);
  } else if (const auto reason = objection(now, self_test_runs, message.session)) {
    // A bench whose session has just ended must hear that, so this does not take the place of the state.
    refusal_ = {.state = SessionState::closed, .reason = *reason, .session = message.session};
  } else {
    session_ = message.session;
    last_heard_ = now.time;
    become(SessionState::open, SessionReason::opened, message.session);
  }
  return true;
}

// Meets BEN-2, BEN-6, BEN-7, BUS-1.
std::optional<SessionReason> BenchMode::objection(const Situation& now, bool self_test_runs,
                                                  std::uint16_t session) const {
  if (session_) {
    return SessionReason::other_session;
  }
  if (now.phase != core::Phase::safe) {
    return SessionReason::not_safe;
  }
  if (!now.at_rest) {
    return SessionReason::not_at_rest;
  }
  if (self_test_runs) {
    return SessionReason::self_test_runs;
  }
  // The same number is the same bench, which has begun anew.
  if (before_ && *before_ != session && !protocol::told_apart(*before_, session)) {
    return SessionReason::number_too_similar;
  }
  return std::nullopt;
}

bool BenchMode::receive(const protocol::BenchRequest& message) {
  if (session_) {
    request_ = message;
  }
  return session_.has_value();
}

std::optional<std::array<core::Angle, core::canard_count>> BenchMode::canard_request(
    const core::CanardsPlan& canards) const {
  if (!request_) {
    return std::nullopt;
  }
  std::array<core::Angle, core::canard_count> angles;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = request_->angle[i].value_or(canards.each[i].trim);
  }
  return angles;
}

// Meets BEN-4, BEN-5.
void BenchMode::update(const Situation& now) {
  if (!session_) {
    return;
  }
  if (now.phase != core::Phase::safe) {
    close(SessionReason::not_safe);
  } else if (now.moves) {
    close(SessionReason::not_at_rest);  // somebody has picked the rocket up
  } else if (now.time - last_heard_ > patience) {
    close(SessionReason::heartbeat_lost);
  }
}

void BenchMode::become(SessionState state, SessionReason reason, std::uint16_t session) {
  reply_ = {.state = state, .reason = reason, .session = session};
  news_ = true;
}

void BenchMode::close(SessionReason reason) {
  const std::uint16_t session = *session_;
  session_.reset();
  before_ = session;
  request_.reset();
  become(SessionState::closed, reason, session);
}

}  // namespace fantail::avionics
