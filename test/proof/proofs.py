# SPDX-License-Identifier: MIT
"""What ./dev prove proves: a row for each property. Each names errors that would break it; the same run must refute them."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Bug:
    says: str
    file: str  # below firmware/
    text: str  # stands in it exactly once
    replacement: str


@dataclasses.dataclass(frozen=True, eq=False)
class Proof:
    name: str
    says: str  # the requirement, in one sentence
    harness: str
    places: int  # its REACHABLE(1 ...) to this
    bugs: tuple
    options: tuple = ("--unwind", "5")
    stubs: tuple = ()  # folders that are searched before the sources
    checks: bool = False  # the prover's own, too: array bounds, pointers, division by zero
    refuted_by: tuple = ("claim: ",)  # how the violated property of a seeded bug begins
    quick: bool = False
    seconds: int = 120  # of the processor, for each run
    megabytes: int = 3000  # of address space


INSIDE = ("--unwind", "5", "-f", "no-access-control")  # the harness looks at private members

MIXER = "core/canard_mixer.cpp"
PHASE = "core/flight_phase.cpp"
DETECTOR = "core/launch_detector.cpp"
AUTOPILOT = "core/autopilot.cpp"
ARMING = "avionics/arming.cpp"
BENCH = "avionics/bench_mode.cpp"
TRANSFER = "avionics/plan_transfer.cpp"
FRAMES = "protocol/generated/canard_bus.c"

NO_CLAMP = Bug("the clamp of the first motion is gone", MIXER,
               "limited_to(canard.limit, canard.trim, *canard.position + clamp(remaining, largest_step))",
               "*canard.position + clamp(remaining, largest_step)")
NO_LIMIT = Bug("what is asked for is not clamped", MIXER, "angle = clamp(wanted, canard.limit);", "angle = wanted;")
NO_HARD_LIMIT = Bug("the smallest limit leaves out the mechanical stop", MIXER,
                    "std::min({plan_limit, hard_canard_limit, plan.mechanical_stop})", "std::min(plan_limit, hard_canard_limit) + plan.trim")

PROOFS = [
    Proof("canard_limits", "No command to a canard exceeds the plan limit, the hard limit or its mechanical stop: all four canards",
          "canard_mixer.cpp", 3, (NO_LIMIT,), options=(*INSIDE, "-D", "CANARDS=4"), seconds=300),
    Proof("first_canard_limit", "The same of the first canard alone, in the first motion and after it", "canard_mixer.cpp", 3,
          (NO_LIMIT, NO_CLAMP, NO_HARD_LIMIT), options=(*INSIDE, "-D", "CANARDS=1"), quick=True),
    Proof("canard_pulse", "The pulse to a canard is within 800.2 us of the plan's centre, and none where it is not driven",
          "canard_pulse.cpp", 2,
          (Bug("the angle counts twice", MIXER, "canard.pulse_per_radian_us * angle.radians()", "canard.pulse_per_radian_us * 2.0F * angle.radians()"),
           Bug("the pulse is that of what was wanted", MIXER, "canard.pulse_per_radian_us * angle.radians()", "canard.pulse_per_radian_us * wanted.radians()")),
          options=INSIDE),
    Proof("canard_trim", "Without roll command and request a canard is commanded to its trim", "canard_trim.cpp", 3,
          (Bug("the trim is left out", MIXER, "canard.sense * roll_command + canard.trim", "canard.sense * roll_command"),
           Bug("what is no number means zero", MIXER, "wanted = is_finite(wanted.radians()) ? wanted : canard.trim;",
               "wanted = is_finite(wanted.radians()) ? wanted : Angle{};")),
          options=INSIDE),
    Proof("flight_phase", "Safe becomes Controlling only by way of switch and command; the switch disarms; no command starts a "
          "launch plan; Finished is final", "flight_phase.cpp", 4,
          (Bug("the switch alone arms", PHASE, "inputs.arm_switch_closed && inputs.arm_command", "inputs.arm_switch_closed"),
           Bug("the switch does not disarm", PHASE, "if (!inputs.arm_switch_closed) {", "if (false) {"),
           Bug("a command starts a launch plan", PHASE, "run_.start == Start::tunnel && inputs.start_command", "inputs.start_command"),
           Bug("control begins inside the guide", PHASE, "beyond_guide && motion.speed_m_s", "motion.speed_m_s"),
           Bug("Finished is not final", PHASE, "case Phase::finished: break;", "case Phase::finished: next = from_armed(inputs, motion); break;")),
          quick=True),
    Proof("launch_detector", "A launch is detected never before its hold, and at the first sample that completes it",
          "launch_detector.cpp", 3,
          (Bug("half the hold is enough", DETECTOR, "*channel.above_since >= plan_.hold", "*channel.above_since >= plan_.hold / 2"),
           Bug("one sample late", DETECTOR, "*channel.above_since >= plan_.hold", "*channel.above_since > plan_.hold"),
           Bug("a hold reaches across a gap", DETECTOR, "sample.time - *channel.last_time > stale_time_", "false"),
           Bug("of two accelerometers one is enough", DETECTOR, "channels_[0].hold_complete && channels_[1].hold_complete",
               "channels_[0].hold_complete || channels_[1].hold_complete")),
          options=INSIDE, stubs=("any_filter",)),
    Proof("control_law", "The command of the control law is a number within the plan limit, whatever its inputs are",
          "pd_controller.cpp", 3,
          (Bug("no clamp", "core/pd_controller.hpp", "clamp(unclamped, plan.canard_limit)", "unclamped"),
           Bug("what is no number is let through", "core/pd_controller.hpp", "if (!is_finite(unclamped.radians())) {", "if (false) {")),
          quick=True),
    Proof("chirp", "The excitation is zero outside of its window, and never more than its amplitude", "chirp.cpp", 1,
          (Bug("it goes on after its window", "core/chirp.cpp", "since_control_start >= plan_.end", "since_control_start > plan_.end"),
           Bug("twice the amplitude", "core/chirp.cpp", "amplitude * sin_turns(turns)", "2.0F * amplitude * sin_turns(turns)")),
          options=INSIDE, quick=True),
    Proof("autopilot", "A step asks the mixer for a request in Safe only and for a roll command in Controlling only",
          "autopilot.cpp", 3,
          (Bug("a request is obeyed in Armed", AUTOPILOT, "record.phase == Phase::safe ? inputs.canard_request",
               "record.phase <= Phase::armed ? inputs.canard_request"),
           Bug("the law acts in Launched, too", AUTOPILOT, "if (record.phase == Phase::controlling) {", "if (record.phase >= Phase::launched) {"),
           Bug("the record has the command before the limit", AUTOPILOT, "clamp(roll.command, controller_.canard_limit)", "roll.command"),
           Bug("control without a rate", AUTOPILOT, "if (record.motion.gyro == SensorState::lost) {", "if (false) {"),
           Bug("the phase is taken back after the step", AUTOPILOT, "record.phase = flight_phase_.phase();", "record.phase = before;")),
          options=INSIDE, stubs=("any_parts",), quick=True),
    Proof("arming", "Only a confirm with the right nonce, at rest in Safe, with the switch cycled and closed and a self-test of "
          "the last minute arms; a nonce is good for one attempt", "arming.cpp", 3,
          (Bug("any nonce will do", ARMING, "nonce == issued_->nonce ? ArmRefusal::none", "true ? ArmRefusal::none"),
           Bug("a nonce can be tried again", ARMING, "issued_.reset();  // one attempt, or all of them could be tried", ""),
           Bug("a nonce lives on", ARMING, "now - issued_->time > nonce_lifetime", "false"),
           Bug("the switch need not be closed", ARMING, "if (!now.arm_switch_closed) {", "if (false) {"),
           Bug("the switch need not have been open", ARMING, "return switch_was_open_ ? ArmRefusal::none", "return true ? ArmRefusal::none"),
           Bug("a self-test is good for ever", "avionics/self_test.hpp", "&& now - ended_ <= validity", ""),
           Bug("start with another nonce", ARMING, "if (nonce != *armed_with_) {", "if (false) {")),
          options=INSIDE, quick=True),
    Proof("bench_mode", "A bench asks for an angle only while it has a session: in Safe, at rest, 100 ms from its last heartbeat",
          "bench_mode.cpp", 3,
          (Bug("a session outlives Safe", BENCH, "if (now.phase != core::Phase::safe) {\n    close", "if (false) {\n    close"),
           Bug("a session without a heartbeat", BENCH, "now.time - last_heard_ > patience", "false"),
           Bug("a second bench takes the session", BENCH, "if (session_) {\n    return SessionReason::other_session;", "if (false) {\n    return SessionReason::other_session;"),
           Bug("a request outlives its session", BENCH, "  request_.reset();\n", "")),
          options=INSIDE, quick=True),
    Proof("plan_transfer", "A plan is transferred, written and brought into force only in Safe, and only a whole and valid one",
          "plan_transfer.cpp", 4,
          (Bug("a transfer begins in any phase", TRANSFER, "if (!safe || wrong_size) {", "if (wrong_size) {"),
           Bug("a plan comes into force in any phase", TRANSFER, "if (safe) {\n        become(TransferState::stored);", "if (true) {\n        become(TransferState::stored);"),
           Bug("a block with another checksum is written", TRANSFER, "protocol::plan_block_crc(block()) == begin_.block_crc", "true"),
           Bug("a plan is handed out before it is stored", TRANSFER, "state_ != TransferState::stored || ", ""),
           Bug("any size is accepted", TRANSFER, "begin.size == 0 || begin.size > protocol::largest_plan_block", "begin.size == 0")),
          options=(*INSIDE, "--force-malloc-success"), stubs=("any_store",), quick=True),
    Proof("bus_frames", "Unpacking any bytes from the bus reads none beyond them; the angles of a request are within 20.48 degrees",
          "bus_frames.c", 2,
          (Bug("a byte beyond the frame is read", FRAMES, "dst_p->nonce |= unpack_left_shift_u32(src_p[5], 24u, 0xffu);",
               "dst_p->nonce |= unpack_left_shift_u32(src_p[8], 24u, 0xffu);"),
           Bug("the first angle has ten times its scale", FRAMES, "float canard_bus_bench_request_canard_1_decode(int16_t value)\n{\n"
               "    return ((float)value * 0.01f);", "float canard_bus_bench_request_canard_1_decode(int16_t value)\n{\n"
               "    return ((float)value * 0.1f);"),
           Bug("any angle is in range", FRAMES, "bool canard_bus_bench_request_canard_1_is_in_range(int16_t value)\n{\n"
               "    return ((value >= -2047)", "bool canard_bus_bench_request_canard_1_is_in_range(int16_t value)\n{\n"
               "    return ((value >= -3000)")),
          options=("--unwind", "9", "--force-malloc-success"), checks=True,
          refuted_by=("claim: ", "dereference failure: "), quick=True),
]
