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
// Twelve seconds in which it may come to rest and the flash is scanned, and four for the canards.
constexpr Microseconds test_time{30'000'000};

// The avionics repeats its answer ten times a second: after this long, what it says was said after the request, even if
// a busy PC slept through the beginning.
constexpr Microseconds answer_time{600'000};

// States in a row, 10 ms apart: a frame of somebody else between them is not taken for the avionics'.
constexpr int states_that_agree = 3;
constexpr int replies_asked = 3;
constexpr int most_contradictions = 5;
constexpr const char* arming = "answer to arming";

bool same_answer(const ArmReply& one, const ArmReply& other) {
  return one.self_test == other.self_test && one.failure == other.failure && one.canard == other.canard &&
         one.refusal == other.refusal;
}

}  // namespace

std::optional<std::size_t> CanardUnderTest::news(const ArmReply& reply) {
  // While it runs no canard is named before the first one moves, and between two frames anybody's may come.
  if (reply.self_test != SelfTestState::running || !reply.canard || reply.canard == last_) {
    return std::nullopt;
  }
  last_ = reply.canard;
  return reply.canard;
}

ArmReply ArmSteps::run_self_test(const std::function<void(const ArmReply&)>& progress) {
  const auto& earlier = link_.newest<ArmReply>();
  const ArmRefusal before = earlier ? earlier->message.refusal : ArmRefusal::none;
  send(ArmAction::self_test);
  Timeout until_answered{answer_time, place_.now()};
  Timeout until_begun{time_to_begin, place_.now()};
  Timeout until_over{test_time, place_.now()};
  contradictions_ = 0;
  bool begun = false;  // an answer to an earlier test must not be mistaken for this one's
  for (std::uint64_t seen = link_.count<ArmReply>();;) {
    look();
    const bool answered = until_answered.expired(place_.now());
    if (!begun && until_begun.expired(place_.now())) {
      throw LinkError{"the avionics does not start its self-test"};
    }
    if (until_over.expired(place_.now())) {
      throw LinkError{"the avionics does not end its self-test"};
    }
    if (link_.count<ArmReply>() == seen) {
      continue;
    }
    seen = link_.count<ArmReply>();
    const ArmReply reply = link_.reported<ArmReply>("self-test");
    const bool runs = reply.self_test == SelfTestState::running;
    const bool is_refused = !begun && !runs && reply.refusal != ArmRefusal::none;
    if (is_refused && (reply.refusal != before || answered) && stands(reply)) {
      throw SelfTestRefused{replies::sentence(reply.refusal)};
    }
    // A test can fail in the tick in which it begins (no gyro), and then nobody hears that it ran.
    const bool failed = reply.self_test == SelfTestState::failed && answered;
    begun = begun || runs || failed;
    if (begun) {
      progress(reply);
    }
    if (begun && !runs && stands(reply)) {
      return reply;
    }
  }
}

ArmReply ArmSteps::ask_for_nonce() {
  const std::uint64_t before = link_.count<ArmReply>();
  send(ArmAction::begin);
  for (Timeout timeout{step_time, place_.now()}; !timeout.expired(place_.now());) {
    look();
    if (link_.count<ArmReply>() > before && link_.reported<ArmReply>(arming).nonce) {
      return link_.reported<ArmReply>(arming);
    }
  }
  // Only now: a refusal that was on its way before this request would be an old one.
  if (link_.count<ArmReply>() > before && link_.reported<ArmReply>(arming).refusal != ArmRefusal::none) {
    return link_.reported<ArmReply>(arming);
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
  link_.expect_one_rocket();
  if (link_.has_fallen_silent()) {
    throw LinkError{"the avionics has stopped reporting"};
  }
}

// The answer comes again every 100 ms; the state, every 10 ms, says whether the self-test runs.
bool ArmSteps::stands(const ArmReply& reply) {
  std::uint64_t seen_states = link_.count<protocol::StatusReport>();
  std::uint64_t seen_replies = link_.count<ArmReply>();
  int idle = 0;
  int replies = 0;
  int same = 0;
  for (Timeout timeout{step_time, place_.now()}; replies < replies_asked && !timeout.expired(place_.now());) {
    look();
    if (link_.count<protocol::StatusReport>() != seen_states) {
      seen_states = link_.count<protocol::StatusReport>();
      idle = link_.reported<protocol::StatusReport>("state").self_test_running ? 0 : idle + 1;
    }
    if (link_.count<ArmReply>() != seen_replies) {
      seen_replies = link_.count<ArmReply>();
      replies += 1;
      same += same_answer(link_.reported<ArmReply>(arming), reply) ? 1 : 0;
    }
  }
  if (idle >= states_that_agree && 2 * same > replies_asked) {
    return true;
  }
  if (++contradictions_ >= most_contradictions) {
    throw LinkError{
        "the answers about the self-test contradict each other: another node on this bus sends them too (frame 0x121)"};
  }
  return false;
}

bool ArmSteps::reaches(core::Phase phase) {
  std::uint64_t seen = link_.count<protocol::StatusReport>();
  int agree = 0;
  for (Timeout timeout{step_time, place_.now()}; !timeout.expired(place_.now());) {
    look();
    if (link_.count<protocol::StatusReport>() != seen) {
      seen = link_.count<protocol::StatusReport>();
      agree = link_.reported<protocol::StatusReport>("state").phase == phase ? agree + 1 : 0;
    }
    if (agree >= states_that_agree) {
      return true;
    }
  }
  (void)link_.reported<protocol::StatusReport>("state");  // who never reports one has refused nothing
  return false;
}

}  // namespace fantail::link
