// SPDX-License-Identifier: MIT
#include "protocol/bus_catalogue.hpp"

#include <algorithm>
#include <array>

#include "protocol/bus_frames.hpp"

namespace fantail::protocol {
namespace {

template <typename Frame>
consteval BusFrameKind kind(std::string_view name, BusNode sender, unsigned length, unsigned period_ms,
                            bool can_move = false) {
  return {.id = Frame::id,
          .name = name,
          .sender = sender,
          .length = static_cast<std::uint8_t>(length),
          .fastest_period = period_ms > 0 ? std::optional{std::chrono::milliseconds{period_ms}} : std::nullopt,
          .has_counter = Frame::is_protected,
          .can_move = can_move};
}

constexpr bool can_move = true;
constexpr unsigned no_period = 0;

// A session that ends centres the canards, the self-test moves them, and a plan that comes into force may have other
// trims. PlanData alone does nothing: the block counts only as a whole, with the CRC-32C that a PlanBegin announced.
constexpr std::array<BusFrameKind, bus_frame_count> catalogue{{
    kind<BenchRequestFrame>("BenchRequest", BusNode::bench, CANARD_BUS_BENCH_REQUEST_LENGTH,
                            CANARD_BUS_BENCH_REQUEST_CYCLE_TIME_MS, can_move),
    kind<BenchSessionFrame>("BenchSession", BusNode::bench, CANARD_BUS_BENCH_SESSION_LENGTH,
                            CANARD_BUS_BENCH_SESSION_CYCLE_TIME_MS, can_move),
    kind<ArmRequestFrame>("ArmRequest", BusNode::bench, CANARD_BUS_ARM_REQUEST_LENGTH,
                          CANARD_BUS_ARM_REQUEST_CYCLE_TIME_MS, can_move),
    kind<PlanBeginFrame>("PlanBegin", BusNode::bench, CANARD_BUS_PLAN_BEGIN_LENGTH, CANARD_BUS_PLAN_BEGIN_CYCLE_TIME_MS,
                         can_move),
    kind<PlanDataFrame>("PlanData", BusNode::bench, CANARD_BUS_PLAN_DATA_LENGTH, CANARD_BUS_PLAN_DATA_CYCLE_TIME_MS),
    kind<LogRequestFrame>("LogRequest", BusNode::bench, CANARD_BUS_LOG_REQUEST_LENGTH,
                          CANARD_BUS_LOG_REQUEST_CYCLE_TIME_MS),
    kind<CommandReportFrame>("CommandReport", BusNode::avionics, CANARD_BUS_COMMAND_REPORT_LENGTH,
                             CANARD_BUS_COMMAND_REPORT_CYCLE_TIME_MS),
    kind<EncoderReportFrame>("EncoderReport", BusNode::avionics, CANARD_BUS_ENCODER_REPORT_LENGTH,
                             CANARD_BUS_ENCODER_REPORT_CYCLE_TIME_MS),
    kind<StatusReportFrame>("StatusReport", BusNode::avionics, CANARD_BUS_STATUS_REPORT_LENGTH,
                            CANARD_BUS_STATUS_REPORT_CYCLE_TIME_MS),
    kind<MotionReportFrame>("MotionReport", BusNode::avionics, CANARD_BUS_MOTION_REPORT_LENGTH,
                            CANARD_BUS_MOTION_REPORT_CYCLE_TIME_MS),
    kind<SessionReplyFrame>("SessionReply", BusNode::avionics, CANARD_BUS_SESSION_REPLY_LENGTH,
                            CANARD_BUS_SESSION_REPLY_CYCLE_TIME_MS),
    kind<ArmReplyFrame>("ArmReply", BusNode::avionics, CANARD_BUS_ARM_REPLY_LENGTH, CANARD_BUS_ARM_REPLY_CYCLE_TIME_MS),
    kind<PlanReplyFrame>("PlanReply", BusNode::avionics, CANARD_BUS_PLAN_REPLY_LENGTH,
                         CANARD_BUS_PLAN_REPLY_CYCLE_TIME_MS),
    kind<LogReplyFrame>("LogReply", BusNode::avionics, CANARD_BUS_LOG_REPLY_LENGTH, CANARD_BUS_LOG_REPLY_CYCLE_TIME_MS),
    kind<HealthReportFrame>("HealthReport", BusNode::avionics, CANARD_BUS_HEALTH_REPORT_LENGTH,
                            CANARD_BUS_HEALTH_REPORT_CYCLE_TIME_MS),
    kind<RejectionReportFrame>("RejectionReport", BusNode::avionics, CANARD_BUS_REJECTION_REPORT_LENGTH,
                               CANARD_BUS_REJECTION_REPORT_CYCLE_TIME_MS),
    kind<LimitReportFrame>("LimitReport", BusNode::avionics, CANARD_BUS_LIMIT_REPORT_LENGTH,
                           CANARD_BUS_LIMIT_REPORT_CYCLE_TIME_MS),
    kind<BoardReportFrame>("BoardReport", BusNode::avionics, CANARD_BUS_BOARD_REPORT_LENGTH,
                           CANARD_BUS_BOARD_REPORT_CYCLE_TIME_MS),
    kind<GyroReportFrame>("GyroReport", BusNode::avionics, CANARD_BUS_GYRO_REPORT_LENGTH,
                          CANARD_BUS_GYRO_REPORT_CYCLE_TIME_MS),
    kind<AccelerometerReportFrame>("AccelerometerReport", BusNode::avionics, CANARD_BUS_ACCELEROMETER_REPORT_LENGTH,
                                   CANARD_BUS_ACCELEROMETER_REPORT_CYCLE_TIME_MS),
    kind<HeartbeatReportFrame>("HeartbeatReport", BusNode::avionics, CANARD_BUS_HEARTBEAT_REPORT_LENGTH,
                               CANARD_BUS_HEARTBEAT_REPORT_CYCLE_TIME_MS),
    kind<LogDataFrame>("LogData", BusNode::avionics, CANARD_BUS_LOG_DATA_LENGTH, no_period),
}};

static_assert(std::ranges::is_sorted(catalogue, {}, &BusFrameKind::id));
static_assert(std::ranges::all_of(catalogue, [](const BusFrameKind& kind) {
  return kind.length == BenchRequestFrame::length && (kind.has_counter || !kind.can_move);
}));

// By the compiler: a board has no use for the rest of the catalogue.
constexpr auto bench_ids = [] {
  std::array<std::uint16_t, bench_frame_count> ids{};
  std::size_t count = 0;
  for (const BusFrameKind& kind : catalogue) {
    if (kind.sender == BusNode::bench) {
      ids.at(count++) = kind.id;
    }
  }
  return ids;
}();
static_assert(bench_ids.back() != 0);

}  // namespace

std::span<const std::uint16_t, bench_frame_count> bench_frame_ids() { return bench_ids; }

std::span<const BusFrameKind, bus_frame_count> bus_catalogue() { return catalogue; }

const BusFrameKind* find_bus_frame(std::uint16_t id) {
  const auto found = std::ranges::find(catalogue, id, &BusFrameKind::id);
  return found == catalogue.end() ? nullptr : &*found;
}

}  // namespace fantail::protocol
