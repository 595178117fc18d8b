// SPDX-License-Identifier: MIT
// From any state of Arming, one request or one tick:
//   - an arm command is made only by a confirm that brings back the nonce which is waiting, at most 5 s after that was
//     issued, in Safe, at rest, on a board without a fault, outside a bench session, with the arm switch closed and
//     seen open since power-up, an abort input that is ready or not fitted, and a self-test that passed at most 60 s
//     ago;
//   - a nonce is issued only to a begin under the same conditions, and only when the power-up has a number;
//   - after any confirm, right or wrong, no nonce waits: it was good for one attempt;
//   - a tick, an answer, or taking a command never makes one, and each command is taken once;
//   - a start command is made only for a tunnel plan, of an armed rocket at rest, with the nonce that it was armed
//   with.
// Because this holds from any state, it holds after any sequence of requests: who arms has begun, has read this board's
// answer, and had the switch closed and the self-test passed at both moments. Where the request comes from a frame of
// the bus, see bus_frames.c; that the flight law needs the switch beside the command is proved in flight_phase.cpp.
#include "avionics/arming.cpp"

#include "proof.hpp"

using namespace fantail;
using namespace fantail::avionics;
using namespace fantail::proof;

int main() {
  Arming arming;
  arming.switch_was_open_ = nondet_bool();
  if (nondet_bool()) {
    arming.issued_ = Arming::Issued{.nonce = nondet_u32(), .time = any_instant()};
  }
  arming.expired_ = nondet_bool();
  if (nondet_bool()) {
    arming.armed_with_ = nondet_u32();
  }
  arming.arm_command_ = nondet_bool();
  arming.start_command_ = nondet_bool();
  arming.requests_ = nondet_u32();

  const core::FlightPlan plan{};
  SelfTest self_test{plan};
  self_test.state_ = any_of<protocol::SelfTestState>(4);
  self_test.ended_ = any_instant();

  const Situation now{.time = any_instant(),
                      .phase = any_of<core::Phase>(6),
                      .at_rest = nondet_bool(),
                      .moves = nondet_bool(),
                      .arm_switch_closed = nondet_bool(),
                      .arm_switch_open = nondet_bool(),
                      .abort = any_of<protocol::AbortState>(4),
                      .board_faulty = nondet_bool()};
  Arming::Permission permission{.self_test_passed = self_test.passed(now.time),
                                .session_open = nondet_bool(),
                                .tunnel_plan = nondet_bool(),
                                .random = nondet_u32()};
  if (nondet_bool()) {
    permission.power_up = nondet_u32();
  }
  const protocol::ArmRequest request{.action = any_of<protocol::ArmAction>(4), .nonce = nondet_u32()};

  const bool tested = self_test.state_ == protocol::SelfTestState::passed &&
                      now.time - self_test.ended_ <= core::Microseconds{60'000'000};
  const bool may = now.phase == core::Phase::safe && now.at_rest && !now.board_faulty && !permission.session_open &&
                   now.arm_switch_closed && arming.switch_was_open_ && tested &&
                   now.abort != protocol::AbortState::asks_to_abort && now.abort != protocol::AbortState::unsettled;
  const bool waits = arming.issued_ && now.time - arming.issued_->time <= core::Microseconds{5'000'000};
  const bool right = waits && arming.issued_->nonce == request.nonce;
  const bool armed_with_it = arming.armed_with_ && *arming.armed_with_ == request.nonce;
  const bool commanded = arming.arm_command_;
  const bool started = arming.start_command_;
  const bool had_nonce = arming.nonce().has_value();
  const std::uint32_t requests = arming.requests_;

  if (nondet_bool()) {
    arming.receive(now, permission, request);

    CLAIM(!arming.arm_command_ || commanded || (request.action == protocol::ArmAction::confirm && right && may));
    CLAIM(!arming.nonce() || had_nonce || (request.action == protocol::ArmAction::begin && may && permission.power_up));
    CLAIM(!arming.nonce() || waits || arming.requests_ == requests + 1);  // a new one, of a new number
    CLAIM(request.action != protocol::ArmAction::confirm || !arming.nonce());
    CLAIM(!arming.start_command_ || started ||
          (request.action == protocol::ArmAction::start && permission.tunnel_plan && now.phase == core::Phase::armed &&
           now.at_rest && armed_with_it));

    REACHABLE(1, arming.arm_command_ && !commanded);
    REACHABLE(2, arming.nonce() && !had_nonce);
    REACHABLE(3, arming.start_command_ && !started);
  } else {
    const bool was_open = arming.switch_was_open_;
    arming.update(now);
    CLAIM(arming.switch_was_open_ == (was_open || now.arm_switch_open));
    CLAIM(arming.arm_command_ == commanded && arming.start_command_ == started);
    CLAIM(!arming.nonce() || had_nonce);
    CLAIM(!arming.nonce() || waits);
    const bool command = arming.take_arm_command();
    CLAIM(command == commanded && !arming.take_arm_command());
    const bool start = arming.take_start_command();
    CLAIM(start == started && !arming.take_start_command());
  }
  return 0;
}
