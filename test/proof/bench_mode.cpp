// SPDX-License-Identifier: MIT
// From any state of BenchMode, one message or one tick:
//   - a session is opened only in Safe, at rest, while no self-test runs and no other session is open;
//   - an angle is asked for only while a session is open; after a tick outside Safe, of a rocket that moves, or more
//   than
//     100 ms after the last heartbeat, none is open and none is asked for;
//   - what names another session changes nothing: neither who has the session, nor when it ends, nor what is asked for;
//   - a request for angles does not keep the session alive.
// That the flight law obeys a request in Safe only, whatever asks for it, is proved in autopilot.cpp.
#include "avionics/bench_mode.cpp"

#include "proof.hpp"

namespace fantail::protocol {

/// Two numbers that differ by more than their checksums do: any answer, the same for the same numbers, is as good here.
bool told_apart(std::uint16_t, std::uint16_t) { return nondet_bool(); }

}  // namespace fantail::protocol

using namespace fantail;
using namespace fantail::avionics;
using namespace fantail::proof;

int main() {
  BenchMode bench;
  if (nondet_bool()) {
    bench.session_ = nondet_u16();
  }
  if (nondet_bool()) {
    bench.before_ = nondet_u16();
  }
  bench.last_heard_ = any_instant();
  if (bench.session_ && nondet_bool()) {  // what is asked for ends with the session: kept by every step below
    bench.request_ = protocol::BenchRequest{
        .angle = {any_optional_angle(), any_optional_angle(), any_optional_angle(), any_optional_angle()}};
  }

  const Situation now{.time = any_instant(),
                      .phase = any_of<core::Phase>(5),
                      .at_rest = nondet_bool(),
                      .moves = nondet_bool(),
                      .arm_switch_closed = nondet_bool(),
                      .board_faulty = nondet_bool()};
  const bool self_test_runs = nondet_bool();
  core::CanardsPlan canards{};
  for (core::CanardPlan& canard : canards.each) {
    canard.trim = any_angle();
  }

  const std::optional<std::uint16_t> before = bench.session_;
  const core::Microseconds heard = bench.last_heard_;
  const bool asked = bench.request_.has_value();

  const std::uint8_t step = nondet_u8();
  if (step == 0) {
    const protocol::BenchSession message{.action = any_of<protocol::SessionAction>(3), .session = nondet_u16()};
    bench.receive(now, self_test_runs, message);
    const bool own = before && *before == message.session;
    CLAIM(before || !bench.open() ||
          (message.action == protocol::SessionAction::open && now.phase == core::Phase::safe && now.at_rest &&
           !self_test_runs && *bench.session() == message.session));
    CLAIM(!before || own ||
          (bench.session_ == before && bench.last_heard_ == heard && bench.request_.has_value() == asked));
    CLAIM(bench.last_heard_ == heard || bench.last_heard_ == now.time);
    REACHABLE(1, bench.open() && !before);
  } else if (step == 1) {
    const protocol::BenchRequest request{
        .angle = {any_optional_angle(), any_optional_angle(), any_optional_angle(), any_optional_angle()}};
    const bool taken = bench.receive(request);
    CLAIM(taken == before.has_value());
    CLAIM(bench.session_ == before && bench.last_heard_ == heard);
    REACHABLE(2, bench.canard_request(canards));
  } else {
    bench.update(now);
    CLAIM(!bench.open() || (before && *bench.session() == *before));
    CLAIM(!bench.open() ||
          (now.phase == core::Phase::safe && !now.moves && now.time - heard <= core::Microseconds{100'000}));
    REACHABLE(3, bench.open());
  }
  CLAIM(bench.open() || !bench.canard_request(canards));
  return 0;
}
