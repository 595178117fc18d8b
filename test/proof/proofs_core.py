# SPDX-License-Identifier: MIT
"""Proofs of firmware/core: the flight law."""

from proof import EACH_ALONE, INSIDE, Bug, Proof

MIXER = "core/canard_mixer.cpp"
PHASE = "core/flight_phase.cpp"
DETECTOR = "core/launch_detector.cpp"
AUTOPILOT = "core/autopilot.cpp"
BAROMETER = "core/barometric_height.cpp"
GATE = "core/dormancy_gate.cpp"

NO_CLAMP = Bug(
    "the clamp of the first motion is gone",
    MIXER,
    "limited_to(canard.limit, canard.trim, *canard.position + clamp(remaining, largest_step))",
    "*canard.position + clamp(remaining, largest_step)",
)
NO_LIMIT = Bug("what is asked for is not clamped", MIXER, "angle = clamp(wanted, canard.limit);", "angle = wanted;")
NO_HARD_LIMIT = Bug(
    "the smallest limit leaves out the mechanical stop",
    MIXER,
    "std::min({plan_limit, hard_canard_limit, plan.mechanical_stop})",
    "std::min(plan_limit, hard_canard_limit) + plan.trim",
)

PROOFS = [
    Proof(
        "canard_limits",
        "No command to a canard exceeds the plan limit, the hard limit or its mechanical stop: all four canards",
        "canard_mixer.cpp",
        1,
        (NO_LIMIT,),
        options=(*INSIDE, "-D", "CANARDS=4"),
        seconds=300,
    ),
    Proof(
        "first_canard_limit",
        "The same of the first canard alone, in the first motion and after it",
        "canard_mixer.cpp",
        3,
        (NO_CLAMP, NO_HARD_LIMIT),
        options=(*INSIDE, "-D", "CANARDS=1"),
    ),
    Proof(
        "canard_pulse",
        "The pulse to a canard is within 800.2 us of the plan's centre, and none where it is not driven",
        "canard_pulse.cpp",
        2,
        (
            Bug(
                "the pulse is that of what was wanted",
                MIXER,
                "canard.pulse_per_radian_us * angle.radians()",
                "canard.pulse_per_radian_us * wanted.radians()",
            ),
        ),
        options=INSIDE,
    ),
    Proof(
        "canard_trim",
        "Without roll command and request a canard is commanded to its trim",
        "canard_trim.cpp",
        3,
        (
            Bug("the trim is left out", MIXER, "canard.sense * roll_command + canard.trim", "canard.sense * roll_command"),
            Bug(
                "what is no number means zero",
                MIXER,
                "wanted = is_finite(wanted.radians()) ? wanted : canard.trim;",
                "wanted = is_finite(wanted.radians()) ? wanted : Angle{};",
            ),
        ),
        options=INSIDE,
    ),
    Proof(
        "flight_phase",
        "Safe becomes Controlling only by way of switch and command; the switch disarms; no command starts a "
        "launch plan; behind a closed gate nothing is Controlling, and an abort ends a flight; what has moved must rest "
        "before a launch; Finished is final",
        "flight_phase.cpp",
        9,
        (
            Bug(
                "the switch alone arms", PHASE, "inputs.arm_switch_closed && inputs.arm_command", "inputs.arm_switch_closed"
            ),
            Bug("the switch does not disarm", PHASE, "if (!inputs.arm_switch_closed) {", "if (false) {"),
            Bug(
                "a command starts a launch plan",
                PHASE,
                "run_.start == Start::tunnel && inputs.start_command",
                "inputs.start_command",
            ),
            Bug("control begins inside the guide", PHASE, "beyond_guide && motion.speed_m_s", "motion.speed_m_s"),
            Bug("control begins by one of two", PHASE, " && inputs.accelerometers_agree", ""),
            Bug("control begins with a silent gyro", PHASE, "clear && motion.gyro != SensorState::lost", "clear"),
            Bug(
                "control begins behind a closed gate",
                PHASE,
                "inputs.gate_is_open ? Phase::controlling : Phase::dormant",
                "Phase::controlling",
            ),
            Bug("Dormant is left by a closed gate", PHASE, "inputs.gate_is_open && motion.gyro", "motion.gyro"),
            Bug("a gate that closes again closes nothing", PHASE, "if (!inputs.gate_is_open) {", "if (false) {"),
            Bug("a rocket is armed against an abort", PHASE, "inputs.arm_command && !inputs.abort", "inputs.arm_command"),
            Bug(
                "an abort ends no control",
                PHASE,
                "if (inputs.abort) {\n    return PhaseReason::aborted;",
                "if (false) {\n    return PhaseReason::aborted;",
            ),
            Bug("movement asks for no rest", PHASE, "|| (waits && motion.has_moved)", ""),
            Bug("rest while it moves is enough", PHASE, " && !motion.has_moved && motion.tilt", " && motion.tilt"),
            Bug("a flight without detection goes on", PHASE, "Start::launch && motion.has_fallen", "Start::tunnel && motion.has_fallen"),
            Bug(
                "Finished is not final",
                PHASE,
                "case Phase::finished: break;",
                "case Phase::finished: next = from_armed(inputs, motion); break;",
            ),
        ),
        quick=True,
    ),
    Proof(
        "dormancy_gate",
        "A gate opens by burn-out not before its clock, by height not before its margin, by two of them only with both, "
        "and never for a rocket that was not fast; one by the guide is always open",
        "dormancy_gate.cpp",
        6,
        (
            Bug(
                "there is no clock",
                GATE,
                "moves_ && now - motion.thrust_since - pauses_ >= burn_clock_",
                "moves_",
            ),
            Bug("a pause is added to the clock", GATE, "now - motion.thrust_since - pauses_", "now - motion.thrust_since"),
            Bug("thrust again does not close it", GATE, "    is_burnt_out_ = false;\n", ""),
            Bug("the margin is left out", GATE, "motion.height_m - motion_error(plan_, now, motion).height_m", "motion.height_m"),
            Bug("a height that nobody measured", GATE, "const bool sure = moves_ && !is_unsure_ &&", "const bool sure = moves_ &&"),
            Bug("one of two is enough", GATE, "is_burnt_out_ && is_past_height_", "is_burnt_out_ || is_past_height_"),
            Bug("a rocket that is carried", GATE, "motion.speed_m_s > least_speed_m_s", "true"),
            Bug("the guide alone is not enough", GATE, "case DormantUntil::guide: return true;", "case DormantUntil::guide: return is_burnt_out_;"),
        ),
        options=INSIDE,
        stubs=("any_filter",),
        seconds=300,
    ),
    Proof(
        "barometric_height",
        "A barometer adds to height and vertical speed no more than the accelerometer may be wrong by, only below 100 m/s "
        "and where both agree; alone it adds nothing and opens nothing",
        "barometric_height.cpp",
        4,
        (
            Bug("height is not bounded", BAROMETER, "height_m_ = within(height_m_, most.height_m);", ""),
            Bug("used while fast", BAROMETER, "if (!(motion.speed_squared_m2_s2 <= fastest_m_s * fastest_m_s)) {", "if (false) {"),
            Bug("used without an accelerometer", BAROMETER, "motion.accelerometer == SensorState::failed || ", ""),
            Bug("alone it opens a gate", BAROMETER, "std::min(height_m - own_error_m, believed_m)", "height_m - own_error_m"),
            Bug("a lie that was added stays", BAROMETER, "return reject(BarometerState::disagrees);", "return;"),
        ),
        options=("--unwind", "14", "-f", "no-access-control", *EACH_ALONE),
        stubs=("any_filter", "any_error", "any_height"),
        seconds=300,
    ),
    Proof(
        "launch_detector",
        "A launch is detected never before its hold, and at the first sample that completes it",
        "launch_detector.cpp",
        3,
        (
            Bug(
                "half the hold is enough",
                DETECTOR,
                "*channel.above_since >= plan_.hold",
                "*channel.above_since >= plan_.hold / 2",
            ),
            Bug("one sample late", DETECTOR, "*channel.above_since >= plan_.hold", "*channel.above_since > plan_.hold"),
            Bug("a hold reaches across a gap", DETECTOR, "sample.time - *last_time > stale_time_", "false"),
            Bug(
                "of two accelerometers one is enough",
                DETECTOR,
                "return both == channels_[1].state() ? both : DetectionState::holding;",
                "return std::max(both, channels_[1].state());",
            ),
        ),
        options=INSIDE,
        stubs=("any_filter",),
    ),
    Proof(
        "control_law",
        "The command of the control law is a number within the plan limit, whatever its inputs are",
        "pd_controller.cpp",
        3,
        (
            Bug("no clamp", "core/pd_controller.hpp", "clamp(unclamped, plan.canard_limit)", "unclamped"),
            Bug(
                "what is no number is let through",
                "core/pd_controller.hpp",
                "if (!is_finite(unclamped.radians())) {",
                "if (false) {",
            ),
        ),
        quick=True,
    ),
    Proof(
        "chirp",
        "The excitation is zero outside of its window, and never more than its amplitude",
        "chirp.cpp",
        1,
        (
            Bug(
                "it goes on after its window",
                "core/chirp.cpp",
                "since_control_start >= plan_.end",
                "since_control_start > plan_.end",
            ),
            Bug(
                "twice the amplitude",
                "core/chirp.cpp",
                "amplitude * sin_turns(turns)",
                "2.0F * amplitude * sin_turns(turns)",
            ),
        ),
        options=INSIDE,
        quick=True,
    ),
    Proof(
        "autopilot",
        "A step asks the mixer for a request in Safe only and for a roll command in Controlling only, never behind a "
        "closed gate",
        "autopilot.cpp",
        5,
        (
            Bug(
                "a request is obeyed in Armed",
                AUTOPILOT,
                "record.phase == Phase::safe ? inputs.canard_request",
                "record.phase <= Phase::armed ? inputs.canard_request",
            ),
            Bug(
                "the law acts in Launched, too",
                AUTOPILOT,
                "if (record.phase == Phase::controlling) {",
                "if (record.phase >= Phase::launched) {",
            ),
            Bug(
                "the law acts in Dormant, too",
                AUTOPILOT,
                "if (record.phase == Phase::controlling) {",
                "if (record.phase == Phase::controlling || record.phase == Phase::dormant) {",
            ),
            Bug("nobody asks the gate", AUTOPILOT, ".gate_is_open = !is_gated_ || dormancy_gate_.is_open()", ".gate_is_open = true"),
            Bug("nobody asks for an abort", AUTOPILOT, ".abort = inputs.abort", ".abort = false"),
            Bug(
                "the record has the command before the limit",
                AUTOPILOT,
                "clamp(roll.command, controller_.canard_limit)",
                "roll.command",
            ),
            Bug("control without a rate", AUTOPILOT, "if (record.motion.gyro == SensorState::lost) {", "if (false) {"),
            Bug(
                "the phase is taken back after the step",
                AUTOPILOT,
                "record.phase = flight_phase_.phase();",
                "record.phase = before;",
            ),
        ),
        options=INSIDE,
        stubs=("any_parts",),
        quick=True,
    ),
]
