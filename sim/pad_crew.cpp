// SPDX-License-Identifier: MIT
#include "sim/pad_crew.hpp"

#include "avionics/can_frame.hpp"

namespace fantail::sim {

using protocol::ArmAction;
using protocol::ArmReply;
using protocol::SelfTestState;

namespace {

/// Sensors of a board test themselves for more than a second after its power-up.
constexpr hal::Microseconds patience{1'000'000};
constexpr hal::Microseconds between_tries{250'000};

}  // namespace

void PadCrew::act(hal::Microseconds now) {
  if (stage_ == Stage::done && !refusal_) {
    bus_.pass_over();
    return;
  }
  const std::optional<ArmReply> reply = newest_reply();
  if (stage_ == Stage::done) {
    return;  // and still hears which faults the board tells
  }
  const bool failed = stage_ == Stage::testing && reply && reply->self_test == SelfTestState::failed;
  const bool refused = reply && reply->refusal != protocol::ArmRefusal::none;
  if (stage_ == Stage::waiting && now >= next_try_) {
    stage_ = Stage::testing;
    send(ArmAction::self_test);
  } else if ((failed || refused) && stage_ == Stage::testing && now < arm_time_ + patience) {
    stage_ = Stage::waiting;
    next_try_ = now + between_tries;
  } else if (stage_ == Stage::testing && reply && reply->self_test == SelfTestState::passed) {
    stage_ = Stage::asking;
    send(ArmAction::begin);
  } else if (failed || refused) {
    give_up(*reply);
  } else if (stage_ == Stage::asking && reply && reply->nonce) {
    stage_ = Stage::confirming;
    nonce_ = reply->nonce;
    send(ArmAction::confirm, *nonce_);
  } else if (stage_ == Stage::confirming && reply) {
    stage_ = Stage::done;
  }
}

void PadCrew::start_tunnel() {
  if (nonce_) {
    send(ArmAction::start, *nonce_);
  }
}

std::optional<ArmReply> PadCrew::newest_reply() {
  std::optional<ArmReply> newest;
  if (stage_ == Stage::waiting) {
    bus_.pass_over();
    return newest;
  }
  static const std::uint16_t arm_reply_id = encode(ArmReply{}).id;
  static const std::uint16_t board_report_id = encode(protocol::BoardReport{}).id;
  while (const auto frame = bus_.receive()) {
    if (frame->id != arm_reply_id && frame->id != board_report_id) {
      continue;
    }
    const auto decoded = protocol::decode_from_avionics(avionics::bus_frame(*frame));
    if (!decoded.message) {
      continue;
    }
    if (const auto* board = std::get_if<protocol::BoardReport>(&*decoded.message)) {
      board_faults_ |= board->faults;
    } else {
      newest = std::get<ArmReply>(*decoded.message);
    }
  }
  return newest;
}

void PadCrew::send(ArmAction action, std::uint32_t nonce) {
  const protocol::BusFrame frame = encode(protocol::ArmRequest{.action = action, .nonce = nonce}, counter_.next());
  (void)bus_.send(avionics::can_frame(frame));
}

void PadCrew::give_up(const ArmReply& reply) {
  stage_ = Stage::done;
  refusal_ = reply;
}

}  // namespace fantail::sim
