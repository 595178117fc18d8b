// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "avionics/flash_facts.hpp"
#include "avionics/gyro_zero.hpp"
#include "avionics/situation.hpp"
#include "core/flight_plan.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// Is this rocket fit to be armed? Three still seconds, in which every sensor that the plan needs must read what a
/// rocket on the pad reads, on a board without a fault; then each canard alone moves 3 degrees out and back, and its
/// encoder must see it and no other may. About six seconds. The first failure ends the test, and it has a name.
class SelfTest {
 public:
  /// The result lasts this long, and no longer than the rocket stands still.
  static constexpr core::Microseconds validity{60'000'000};

  /// The plan outlives this object; when it is another one, so is its test.
  explicit SelfTest(const core::FlightPlan& plan) : plan_{&plan} {}

  /// Begins, unless it is under way; or refuses, and then what an earlier test has shown stays as it is.
  [[nodiscard]] protocol::ArmRefusal start(const Situation& now, bool session_open);

  /// Once a tick, with what the autopilot was given and what it made of it.
  void update(const core::Inputs& inputs, const core::TickRecord& record, const FlashFacts& flash, bool board_faulty);

  /// Shaft angles for the autopilot; empty unless it moves the canards now.
  [[nodiscard]] std::optional<std::array<core::Angle, core::canard_count>> canard_request() const;

  [[nodiscard]] protocol::SelfTestState state() const { return state_; }
  [[nodiscard]] protocol::SelfTestFailure failure() const { return failure_; }
  /// The canard that moves now, or with which the test failed.
  [[nodiscard]] std::optional<std::size_t> canard() const { return canard_; }
  [[nodiscard]] bool running() const { return state_ == protocol::SelfTestState::running; }
  [[nodiscard]] bool passed(core::Microseconds now) const {
    return state_ == protocol::SelfTestState::passed && now - ended_ <= validity;
  }

  /// Room in the flash that a flight by this plan needs.
  [[nodiscard]] static std::uint32_t record_bytes(const core::FlightPlan& plan);

 private:
  /// One accelerometer's axial channel over the still seconds.
  struct Average {
    float sum_m_s2 = 0.0F;
    float samples = 0.0F;
    core::Microseconds last_sample{};
    core::Microseconds last_news{};
    [[nodiscard]] float mean_m_s2() const { return sum_m_s2 / samples; }
  };
  enum class Stage : std::uint8_t { still, centre, out, back };

  void stand_still(const core::Inputs& inputs, const core::TickRecord& record, const FlashFacts& flash);
  void restart_averages(core::Microseconds now);
  bool average(const core::Inputs& inputs);
  [[nodiscard]] std::optional<protocol::SelfTestFailure> judge_sensors() const;
  [[nodiscard]] std::optional<protocol::SelfTestFailure> judge_gyro_zeros() const;
  [[nodiscard]] std::optional<protocol::SelfTestFailure> judge_averages() const;
  [[nodiscard]] bool barometer_fails(const core::TickRecord& record) const;
  [[nodiscard]] std::optional<protocol::SelfTestFailure> judge_flash(const FlashFacts& flash) const;
  void move_canards(const core::TickRecord& record);
  void judge_canards();
  void begin_move(core::Microseconds now, Stage stage, std::size_t canard);
  void fail(protocol::SelfTestFailure failure, std::optional<std::size_t> canard = {});
  [[nodiscard]] std::optional<protocol::SelfTestFailure> judge_gyros(const core::TickRecord& record);
  [[nodiscard]] std::size_t needed_accelerometers() const;
  [[nodiscard]] core::Angle swing(std::size_t canard) const;
  [[nodiscard]] core::Angle asked_of(std::size_t canard) const;

  const core::FlightPlan* plan_;
  protocol::SelfTestState state_ = protocol::SelfTestState::not_run;
  protocol::SelfTestFailure failure_ = protocol::SelfTestFailure::none;
  std::optional<std::size_t> canard_;
  core::Microseconds started_{};
  core::Microseconds stage_started_{};
  core::Microseconds ended_{};         ///< when the last one passed
  core::Microseconds gyros_agreed_{};  ///< when they last did
  Stage stage_ = Stage::still;
  float pressure_pa_ = 0.0F;  ///< the barometer's last
  std::array<Average, 2> averages_{};
  std::array<GyroZero, 2> gyro_zeros_{};
  std::array<core::Angle, core::canard_count> encoder_sum_{};
  std::array<float, core::canard_count> encoder_samples_{};
};

}  // namespace fantail::avionics
