# SPDX-License-Identifier: MIT
"""Proofs of firmware/avionics and firmware/protocol: who may arm, move a canard and bring a plan."""

from proof import INSIDE, Bug, Proof

ARMING = "avionics/arming.cpp"
BENCH = "avionics/bench_mode.cpp"
TRANSFER = "avionics/plan_transfer.cpp"
FRAMES = "protocol/generated/canard_bus.c"

PROOFS = [
    Proof(
        "arming",
        "Only a confirm with the right nonce, at rest in Safe, with the switch cycled and closed and a self-test of "
        "the last minute arms; a nonce is good for one attempt",
        "arming.cpp",
        3,
        (
            Bug("any nonce will do", ARMING, "nonce == issued_->nonce ? ArmRefusal::none", "true ? ArmRefusal::none"),
            Bug("a nonce can be tried again", ARMING, "issued_.reset();  // one attempt, or all of them could be tried", ""),
            Bug("a nonce lives on", ARMING, "now - issued_->time > nonce_lifetime", "false"),
            Bug("the switch need not be closed", ARMING, "if (!now.arm_switch_closed) {", "if (false) {"),
            Bug(
                "the switch need not have been open",
                ARMING,
                "return switch_was_open_ ? ArmRefusal::none",
                "return true ? ArmRefusal::none",
            ),
            Bug("a self-test is good for ever", "avionics/self_test.hpp", "&& now - ended_ <= validity", ""),
            Bug(
                "the abort input may chatter",
                ARMING,
                "now.abort == AbortState::asks_to_abort || now.abort == AbortState::unsettled",
                "now.abort == AbortState::asks_to_abort",
            ),
            Bug("start with another nonce", ARMING, "if (nonce != *armed_with_) {", "if (false) {"),
        ),
        options=INSIDE,
        quick=True,
    ),
    Proof(
        "bench_mode",
        "A bench asks for an angle only while it has a session: in Safe, at rest, 100 ms from its last heartbeat",
        "bench_mode.cpp",
        3,
        (
            Bug(
                "a session outlives Safe",
                BENCH,
                "if (now.phase != core::Phase::safe) {\n    close",
                "if (false) {\n    close",
            ),
            Bug("a session without a heartbeat", BENCH, "now.time - last_heard_ > patience", "false"),
            Bug(
                "a second bench takes the session",
                BENCH,
                "if (session_) {\n    return SessionReason::other_session;",
                "if (false) {\n    return SessionReason::other_session;",
            ),
            Bug("a request outlives its session", BENCH, "  request_.reset();\n", ""),
        ),
        options=INSIDE,
        quick=True,
    ),
    Proof(
        "plan_transfer",
        "A plan is transferred, written and made ready to come into force only in Safe, and only a whole and valid one",
        "plan_transfer.cpp",
        4,
        (
            Bug("a transfer begins in any phase", TRANSFER, "if (!safe || wrong_size) {", "if (wrong_size) {"),
            Bug(
                "a plan comes into force in any phase",
                TRANSFER,
                "if (safe) {\n        become(TransferState::stored);",
                "if (true) {\n        become(TransferState::stored);",
            ),
            Bug(
                "a block with another checksum is written",
                TRANSFER,
                "protocol::plan_block_crc(block()) == begin_.block_crc",
                "true",
            ),
            Bug("a plan is handed out before it is stored", TRANSFER, "state_ != TransferState::stored || ", ""),
            Bug(
                "any size is accepted",
                TRANSFER,
                "begin.size == 0 || begin.size > protocol::largest_plan_block",
                "begin.size == 0",
            ),
        ),
        options=(*INSIDE, "--force-malloc-success"),
        stubs=("any_store",),
        quick=True,
    ),
    Proof(
        "bus_frames",
        "Unpacking any bytes from the bus reads none beyond them; the angles of a request are within 20.48 degrees",
        "bus_frames.c",
        2,
        (
            Bug(
                "a byte beyond the frame is read",
                FRAMES,
                "dst_p->nonce |= unpack_left_shift_u32(src_p[5], 24u, 0xffu);",
                "dst_p->nonce |= unpack_left_shift_u32(src_p[8], 24u, 0xffu);",
            ),
            Bug(
                "the first angle has ten times its scale",
                FRAMES,
                "float canard_bus_bench_request_canard_1_decode(int16_t value)\n{\n" "    return ((float)value * 0.01f);",
                "float canard_bus_bench_request_canard_1_decode(int16_t value)\n{\n" "    return ((float)value * 0.1f);",
            ),
            Bug(
                "any angle is in range",
                FRAMES,
                "bool canard_bus_bench_request_canard_1_is_in_range(int16_t value)\n{\n" "    return ((value >= -2047)",
                "bool canard_bus_bench_request_canard_1_is_in_range(int16_t value)\n{\n" "    return ((value >= -3000)",
            ),
        ),
        options=("--unwind", "9", "--force-malloc-success"),
        checks=True,
        refuted_by=("claim: ", "dereference failure: "),
        quick=True,
    ),
]
