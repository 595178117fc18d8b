// SPDX-License-Identifier: MIT
#include "link/arm_steps.hpp"

#include "avionics/can_frame.hpp"
#include "link/session.hpp"
#include "replies/sentence.hpp"

namespace fantail::link {
namespace {

using hal::Microseconds;
using protocol::ArmAction;
using protocol::ArmRefusal;
using protocol::ArmReply;
using protocol::SelfTestState;

constexpr Microseconds glance{2'000};
constexpr Microseconds time_to_begin{2'000'000};
constexpr Microseconds step_time{1'000'000};

// The avionics repeats its answer ten times a second: after this long, what it says was said after the request, even if
// a busy PC slept through the beginning.
constexpr Microseconds answer_time{600'000};

}  // namespace

ArmReply ArmSteps::run_self_test(const std::function<void(const ArmReply&)>& progress) {
  const auto& earlier = link_.newest<ArmReply>();
  const ArmRefusal before = earlier ? earlier->message.refusal : ArmRefusal::none;
  send(ArmAction::self_test);
  Timeout until_answered{answer_time, place_.now()};
  Timeout until_begun{time_to_begin, place_.now()};
  bool begun = false;  // an answer to an earlier test must not be mistaken for this one's
  for (std::uint64_t seen = link_.count<ArmReply>();;) {
    look();
    const bool answered = until_answered.expired(place_.now());
    if (!begun && until_begun.expired(place_.now())) {
      throw LinkError{"the avionics does not start its self-test"};
    }
    if (link_.count<ArmReply>() == seen) {
      continue;
    }
    seen = link_.count<ArmReply>();
    const ArmReply reply = link_.newest<ArmReply>()->message;
    const bool runs = reply.self_test == SelfTestState::running;
    if (!begun && !runs && reply.refusal != ArmRefusal::none && (reply.refusal != before || answered)) {
      throw SelfTestRefused{replies::sentence(reply.refusal)};
    }
    // A test can fail in the tick in which it begins (no gyro), and then nobody hears that it ran.
    const bool failed = reply.self_test == SelfTestState::failed && answered;
    begun = begun || runs || failed;
    if (begun) {
      progress(reply);
    }
    if (begun && !runs) {
      return reply;
    }
  }
}

ArmReply ArmSteps::ask_for_nonce() {
  const std::uint64_t before = link_.count<ArmReply>();
  send(ArmAction::begin);
  for (Timeout timeout{step_time, place_.now()}; !timeout.expired(place_.now());) {
    look();
    if (link_.count<ArmReply>() > before && link_.newest<ArmReply>()->message.nonce) {
      return link_.newest<ArmReply>()->message;
    }
  }
  // Only now: a refusal that was on its way before this request would be an old one.
  if (link_.count<ArmReply>() > before && link_.newest<ArmReply>()->message.refusal != protocol::ArmRefusal::none) {
    return link_.newest<ArmReply>()->message;
  }
  throw LinkError{"the avionics does not answer the request to arm"};
}

bool ArmSteps::confirm(std::uint32_t nonce) {
  send(ArmAction::confirm, nonce);
  return reaches(core::Phase::armed);
}

bool ArmSteps::start_control(std::uint32_t nonce) {
  send(ArmAction::start, nonce);
  return reaches(core::Phase::controlling);
}

void ArmSteps::send(ArmAction action, std::uint32_t nonce) {
  const protocol::BusFrame frame = encode(protocol::ArmRequest{.action = action, .nonce = nonce}, counter_.next());
  (void)place_.bus().send(avionics::can_frame(frame));
}

void ArmSteps::look() {
  place_.wait(glance);
  link_.listen(place_.now());
  if (link_.has_fallen_silent()) {
    throw LinkError{"the avionics has stopped reporting"};
  }
}

// The status comes every 10 ms.
bool ArmSteps::reaches(core::Phase phase) {
  for (Timeout timeout{step_time, place_.now()}; !timeout.expired(place_.now());) {
    look();
    if (link_.newest<protocol::StatusReport>()->message.phase == phase) {
      return true;
    }
  }
  return false;
}

}  // namespace fantail::link
