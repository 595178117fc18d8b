// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "protocol/bus_layout.hpp"
#include "protocol/bus_signal.hpp"
#include "protocol/generated/canard_bus.h"

namespace fantail::protocol {

// Inside the codec only: every frame of the database, and the signals that come in fours.

using BenchRequestFrame = Layout<canard_bus_bench_request_t, CANARD_BUS_BENCH_REQUEST_FRAME_ID,
                                 canard_bus_bench_request_pack, canard_bus_bench_request_unpack>;
using BenchSessionFrame = Layout<canard_bus_bench_session_t, CANARD_BUS_BENCH_SESSION_FRAME_ID,
                                 canard_bus_bench_session_pack, canard_bus_bench_session_unpack>;
using ArmRequestFrame = Layout<canard_bus_arm_request_t, CANARD_BUS_ARM_REQUEST_FRAME_ID, canard_bus_arm_request_pack,
                               canard_bus_arm_request_unpack>;
using PlanBeginFrame = Layout<canard_bus_plan_begin_t, CANARD_BUS_PLAN_BEGIN_FRAME_ID, canard_bus_plan_begin_pack,
                              canard_bus_plan_begin_unpack>;
using PlanDataFrame = Layout<canard_bus_plan_data_t, CANARD_BUS_PLAN_DATA_FRAME_ID, canard_bus_plan_data_pack,
                             canard_bus_plan_data_unpack>;
using LogRequestFrame = Layout<canard_bus_log_request_t, CANARD_BUS_LOG_REQUEST_FRAME_ID, canard_bus_log_request_pack,
                               canard_bus_log_request_unpack>;
using CommandReportFrame = Layout<canard_bus_command_report_t, CANARD_BUS_COMMAND_REPORT_FRAME_ID,
                                  canard_bus_command_report_pack, canard_bus_command_report_unpack>;
using EncoderReportFrame = Layout<canard_bus_encoder_report_t, CANARD_BUS_ENCODER_REPORT_FRAME_ID,
                                  canard_bus_encoder_report_pack, canard_bus_encoder_report_unpack>;
using StatusReportFrame = Layout<canard_bus_status_report_t, CANARD_BUS_STATUS_REPORT_FRAME_ID,
                                 canard_bus_status_report_pack, canard_bus_status_report_unpack>;
using MotionReportFrame = Layout<canard_bus_motion_report_t, CANARD_BUS_MOTION_REPORT_FRAME_ID,
                                 canard_bus_motion_report_pack, canard_bus_motion_report_unpack>;
using SessionReplyFrame = Layout<canard_bus_session_reply_t, CANARD_BUS_SESSION_REPLY_FRAME_ID,
                                 canard_bus_session_reply_pack, canard_bus_session_reply_unpack>;
using ArmReplyFrame = Layout<canard_bus_arm_reply_t, CANARD_BUS_ARM_REPLY_FRAME_ID, canard_bus_arm_reply_pack,
                             canard_bus_arm_reply_unpack>;
using PlanReplyFrame = Layout<canard_bus_plan_reply_t, CANARD_BUS_PLAN_REPLY_FRAME_ID, canard_bus_plan_reply_pack,
                              canard_bus_plan_reply_unpack>;
using LogReplyFrame = Layout<canard_bus_log_reply_t, CANARD_BUS_LOG_REPLY_FRAME_ID, canard_bus_log_reply_pack,
                             canard_bus_log_reply_unpack>;
using HealthReportFrame = Layout<canard_bus_health_report_t, CANARD_BUS_HEALTH_REPORT_FRAME_ID,
                                 canard_bus_health_report_pack, canard_bus_health_report_unpack>;
using RejectionReportFrame = Layout<canard_bus_rejection_report_t, CANARD_BUS_REJECTION_REPORT_FRAME_ID,
                                    canard_bus_rejection_report_pack, canard_bus_rejection_report_unpack>;
using LimitReportFrame = Layout<canard_bus_limit_report_t, CANARD_BUS_LIMIT_REPORT_FRAME_ID,
                                canard_bus_limit_report_pack, canard_bus_limit_report_unpack>;
using BoardReportFrame = Layout<canard_bus_board_report_t, CANARD_BUS_BOARD_REPORT_FRAME_ID,
                                canard_bus_board_report_pack, canard_bus_board_report_unpack>;
using GyroReportFrame = Layout<canard_bus_gyro_report_t, CANARD_BUS_GYRO_REPORT_FRAME_ID, canard_bus_gyro_report_pack,
                               canard_bus_gyro_report_unpack>;
using AccelerometerReportFrame = Layout<canard_bus_accelerometer_report_t, CANARD_BUS_ACCELEROMETER_REPORT_FRAME_ID,
                                        canard_bus_accelerometer_report_pack, canard_bus_accelerometer_report_unpack>;
using HeartbeatReportFrame = Layout<canard_bus_heartbeat_report_t, CANARD_BUS_HEARTBEAT_REPORT_FRAME_ID,
                                    canard_bus_heartbeat_report_pack, canard_bus_heartbeat_report_unpack>;

using LogDataFrame =
    Layout<canard_bus_log_data_t, CANARD_BUS_LOG_DATA_FRAME_ID, canard_bus_log_data_pack, canard_bus_log_data_unpack>;

// Whatever can move or erase something is protected.
static_assert(BenchRequestFrame::is_protected && BenchSessionFrame::is_protected && ArmRequestFrame::is_protected &&
              PlanBeginFrame::is_protected && LogRequestFrame::is_protected);

namespace signals {

using RawRequest = BenchRequestFrame::Raw;
using RawCommand = CommandReportFrame::Raw;
using RawEncoder = EncoderReportFrame::Raw;
using RawStatus = StatusReportFrame::Raw;
using RawHealth = HealthReportFrame::Raw;
using RawLimit = LimitReportFrame::Raw;

inline constexpr FourAngles<RawRequest> asked{
    .given = {&RawRequest::asked_1, &RawRequest::asked_2, &RawRequest::asked_3, &RawRequest::asked_4}};
inline constexpr FourAngles<RawCommand> driven{
    .given = {&RawCommand::driven_1, &RawCommand::driven_2, &RawCommand::driven_3, &RawCommand::driven_4}};
inline constexpr FourAngles<RawEncoder> valid{
    .given = {&RawEncoder::valid_1, &RawEncoder::valid_2, &RawEncoder::valid_3, &RawEncoder::valid_4}};
// Not std::array{...}: GCC 12 for the processor puts a constant whose type it deduces among the variables.
inline constexpr auto limited =
    std::to_array({&RawStatus::limited_1, &RawStatus::limited_2, &RawStatus::limited_3, &RawStatus::limited_4});
inline constexpr auto verdicts =
    std::to_array({&RawHealth::verdict_1, &RawHealth::verdict_2, &RawHealth::verdict_3, &RawHealth::verdict_4});
inline constexpr auto limits =
    std::to_array({&RawLimit::canard_1, &RawLimit::canard_2, &RawLimit::canard_3, &RawLimit::canard_4});
template <typename Raw>
inline constexpr auto bytes =
    std::to_array({&Raw::byte_0, &Raw::byte_1, &Raw::byte_2, &Raw::byte_3, &Raw::byte_4, &Raw::byte_5, &Raw::byte_6});

}  // namespace signals

}  // namespace fantail::protocol
