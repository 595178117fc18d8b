// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/angle.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "protocol/bus_requests.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::protocol {

// Every message of the bus, in the words of the program. How each one lies in its eight bytes stands in canard_bus.dbc;
// bus_codec turns one into the other.

inline constexpr std::uint8_t bus_protocol_version = 2;

// From the avionics: reports, which move nothing.

/// The commands to the servos; empty: not driven.
struct CommandReport {
  PerCanard angle{};
};

/// What the encoders read; empty: no valid reading.
struct EncoderReport {
  PerCanard angle{};
};

struct StatusReport {
  core::Phase phase = core::Phase::safe;
  core::PhaseReason reason = core::PhaseReason::power_on;
  core::CommandStatus command_status = core::CommandStatus::outside_control;
  core::Angle roll_command{};
  bool saturated = false;
  std::array<bool, core::canard_count> limited{};  ///< asked for more than it was given
  bool arm_switch_closed = false;
  bool at_rest = false;
  bool session_open = false;
  bool self_test_running = false;
  bool timing_fault = false;
  bool every_tick = false;       ///< commands and encoders are reported every millisecond now
  bool abort = false;            ///< the abort contact stands as, by the plan, ends control
  float gyro_bias_rad_s = 0.0F;  ///< about the long axis: what rest on the pad has shown, and is taken off
};

struct MotionReport {
  core::Angle roll_angle{};  ///< saturates at 3276.7 deg
  float roll_rate_rad_s = 0.0F;
  float height_m = 0.0F;
  float speed_m_s = 0.0F;
};

enum class SessionState : std::uint8_t { closed, open };

/// Why the session is what it is.
enum class SessionReason : std::uint8_t {
  none_yet,
  opened,
  closed_by_bench,
  heartbeat_lost,      ///< 100 ms without one
  not_safe,            ///< refused or ended: the phase is not Safe
  not_at_rest,         ///< refused or ended: the rocket moves
  self_test_runs,      ///< refused
  other_session,       ///< refused: another bench holds one
  number_too_similar,  ///< refused: not told_apart() from the session before
};

struct SessionReply {
  SessionState state = SessionState::closed;
  SessionReason reason = SessionReason::none_yet;
  std::uint16_t session = 0;  ///< the one that is open, or was refused or closed last
};

enum class SelfTestState : std::uint8_t { not_run, running, passed, failed };

enum class SelfTestFailure : std::uint8_t {
  none,
  not_safe,                  ///< the phase has changed
  moved,                     ///< not still for the whole test
  gyro_failed,               ///< no usable gyro
  accelerometer_failed,      ///< one that the plan needs is not usable
  specific_force_not_one_g,  ///< mean of three still seconds, 1 g +- 0.1 g
  accelerometers_disagree,
  encoder_silent,
  canard_did_not_follow,
  another_canard_moved,  ///< it was not its turn: encoders or servos are swapped
  no_valid_plan,         ///< the stored plan is broken
  flash_failed,
  flash_too_full,
  timed_out,
  board_fault,         ///< BoardReport names it
  newer_plan,          ///< the stored plan was made for a newer version of the firmware
  second_gyro_failed,  ///< of two that the plan asks for
  gyros_disagree,
  gyro_turns,  ///< reads a steady turn beyond largest_gyro_bias_rad_s(), as the following
  second_gyro_turns,
  barometer_failed,  ///< the one that the plan asks for gives no usable pressure
};

/// Of the last ArmRequest, whatever it asked for. What is refused changes nothing; only a wrong nonce voids the right
/// one.
enum class ArmRefusal : std::uint8_t {
  none,
  not_safe,
  session_open,
  self_test_not_passed,  ///< or longer ago than a minute, or the rocket has moved since
  switch_not_cycled,     ///< closed since power-up: open it, and close it again
  switch_open,
  not_at_rest,
  no_nonce,  ///< confirm without begin; or begin, and none can be made
  nonce_expired,
  wrong_nonce,
  not_a_tunnel_plan,  ///< start
  not_armed,          ///< start
  board_fault,        ///< BoardReport names it
  abort_not_ready,    ///< the abort input asks to abort, or has not settled
};

/// How the abort contact stands, by the plan's sense of it.
enum class AbortState : std::uint8_t {
  none_fitted,    ///< by the plan
  ready,          ///< fitted, and does not ask
  asks_to_abort,  ///< ends control, and keeps from arming
  unsettled,      ///< chatters, or power-up was less than 50 ms ago: keeps from arming alone
};

struct ArmReply {
  SelfTestState self_test = SelfTestState::not_run;
  SelfTestFailure failure = SelfTestFailure::none;
  std::optional<std::size_t> canard{};  ///< 0 to 3: where the self-test failed, or which one it moves
  ArmRefusal refusal = ArmRefusal::none;
  std::optional<std::uint32_t> nonce{};  ///< to be confirmed within 5 s
  AbortState abort_input = AbortState::none_fitted;
  friend bool operator==(const ArmReply&, const ArmReply&) = default;
};

enum class TransferState : std::uint8_t {
  idle,
  receiving,
  writing,
  stored,   ///< read back, validated, in force
  refused,  ///< the old plan stays in force
};

enum class TransferFault : std::uint8_t {
  none,
  not_safe,
  wrong_size,
  out_of_order,  ///< data without a beginning, or past the end
  timed_out,     ///< 1 s without data
  bad_block,     ///< `block_fault` says why
  flash_failed,
  read_back_differs,
};

struct PlanReply {
  TransferState state = TransferState::idle;
  TransferFault fault = TransferFault::none;
  std::uint8_t next_index = 0;  ///< the frame that is waited for
  std::optional<PlanBlockFault> block_fault{};
  std::optional<std::uint8_t> field{};  ///< place in core::flight_plan_fields() of the refused one
};

enum class LogState : std::uint8_t {
  ready,    ///< the answer to info
  read,     ///< the bytes asked for have been sent
  erasing,  ///< said again as it goes on
  erased,
  refused,  ///< or given up
};

enum class LogFault : std::uint8_t {
  none,
  not_safe,
  no_session,       ///< erase: it is not open, or another bench's, or was closed before the end
  busy,             ///< it is being erased, or the flash has something more urgent to do
  not_counted_yet,  ///< what is used is still being looked for, some seconds after power-up
  out_of_range,     ///< nothing, too much, or beyond the end
  flash_failed,
};

struct LogReply {
  LogState state = LogState::ready;
  LogFault fault = LogFault::none;
  std::uint8_t tag = 0;
  std::uint32_t number = 0;  ///< ready, erased: bytes in use; read: CRC-32C of the bytes; erasing: bytes still to erase
  std::uint16_t extra = 0;   ///< ready, erased: KiB still free, saturates; read: how many bytes
};

/// Seven bytes of what was asked for; zeros after the last.
struct LogData {
  std::uint8_t index = 0;  ///< bytes from 7 * index on
  std::array<std::byte, 7> bytes{};
};

/// As many bytes as the index can count.
inline constexpr std::uint16_t largest_log_chunk = 256 * 7;

/// Why a received frame was not acted upon.
enum class Rejection : std::uint8_t {
  unknown_id,
  wrong_length,   ///< also remote frames
  wrong_crc,      ///< also a request for another session than the open one
  wrong_counter,  ///< repeated, or frames before it were lost
  out_of_range,
  stale,  ///< heartbeat or request of a session that is not open
};
inline constexpr std::size_t rejection_count = 6;

struct HealthReport {
  std::array<core::CanardVerdict, core::canard_count> verdicts{};
  core::SensorState gyro = core::SensorState::failed;
  core::SensorState accelerometer = core::SensorState::failed;
  std::uint8_t bus_state = 0;  ///< 0 error active, 1 warning, 2 passive, 3 bus off, 4 down
  std::uint8_t unsent = 0;     ///< frames, modulo 256
  std::uint8_t overrun = 0;
  std::uint8_t bus_errors = 0;
  std::uint16_t longest_tick_us = 0;  ///< in the last 0.1 s; saturates
};

struct RejectionReport {
  std::array<std::uint8_t, rejection_count> count{};  ///< modulo 256
};

struct LimitReport {
  std::array<core::Angle, core::canard_count> limit{};  ///< largest shaft angle that can be commanded
};

/// Which plan is in force, and what is wrong with the one in the flash. With anything wrong it is the built-in one.
enum class PlanSource : std::uint8_t {
  built_in,  ///< none is stored
  stored,
  stored_is_broken,
  stored_is_newer,  ///< made for a newer version of the firmware
  flash_unreadable,
};

struct BoardReport {
  std::uint32_t faults = 0;      ///< hal::BoardFaults::bits()
  std::uint8_t reset_cause = 0;  ///< hal::ResetCause
  PlanSource plan = PlanSource::built_in;
  bool flash_failed = false;  ///< it does not answer, or does not keep what is written
  std::optional<std::uint16_t> battery_mv{};
  std::uint8_t overruns = 0;  ///< control ticks that were due and did not come, since power-up; saturates. Also those
                              ///< that a simulated board left out, which are no fault
};

/// The rates about the axes of the body as the gyro gives them, its bias included. In Safe only, as the next one.
struct GyroReport {
  core::Vector3 rate_rad_s{};  ///< each saturates at 3276.7 deg/s
  core::SampleQuality quality = core::SampleQuality::absent;
  std::uint16_t time_ms = 0;  ///< of the tick, since power-up: 14 bits, wraps after 16.4 s
};

enum class Accelerometer : std::uint8_t { of_imu, second };

struct AccelerometerReport {
  core::Vector3 specific_force_m_s2{};  ///< along the axes of the body; each saturates at 327.67 m/s^2
  Accelerometer sensor = Accelerometer::of_imu;
  core::SampleQuality quality = core::SampleQuality::absent;
};

struct HeartbeatReport {
  std::uint8_t version = bus_protocol_version;
  std::uint32_t uptime_ms = 0;  ///< 24 bits, wraps after 4.6 h
  std::uint32_t plan_crc = 0;   ///< plan_block_crc() of the one in force
};

}  // namespace fantail::protocol
