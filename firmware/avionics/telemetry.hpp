// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "avionics/situation.hpp"
#include "core/tick_record.hpp"
#include "hal/can_bus.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::avionics {

/// Reports of every second; that of the board also after a change.
struct SlowReport {
  protocol::RejectionReport rejections{};
  protocol::LimitReport limits{};
  protocol::BoardReport board{};
  bool board_is_news = false;
};

/// The content of a tick's reports beyond its record.
struct Report {
  Situation situation{};
  bool self_test_running = false;
  bool session_open = false;
  protocol::SessionReply session{};  ///< of that one, or of the last
  bool session_is_news = false;
  std::optional<protocol::SessionReply> session_refusal{};
  protocol::ArmReply arming{};
  std::optional<protocol::PlanReply> plan{};
  std::uint32_t plan_crc = 0;
  core::Microseconds tick_duration{};  ///< of the last whole tick
  std::optional<SlowReport> slow{};    ///< when slow_report_is_due(), and when the board is news
};

/// Puts the reports on the bus: commands and encoders every millisecond while a canard may move (Launched, Controlling,
/// self-test, bench session), every ten otherwise; what gyro and accelerometers read in Safe only; the rest in turn, so
/// that no millisecond has much more than another.
class Telemetry {
 public:
  void send(const core::TickRecord& record, const core::Inputs& inputs, const Report& report, hal::CanBus& bus);

  /// The next send() sends one of the reports of every second.
  [[nodiscard]] bool slow_report_is_due() const;

 private:
  [[gnu::cold]] void send_sensors(const core::Inputs& inputs, hal::CanBus& bus) const;
  void send_health(const core::TickRecord& record, const Report& report, hal::CanBus& bus);

  std::uint32_t ticks_ = 0;
  protocol::FrameCounter command_counter_;
  protocol::FrameCounter encoder_counter_;
  protocol::ArmReply last_arming_{};
  core::Microseconds longest_tick_{};
};

}  // namespace fantail::avionics
