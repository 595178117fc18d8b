// SPDX-License-Identifier: MIT
#include "whole_board.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fantail::devices {
namespace {

constexpr Microseconds millisecond{1'000};
constexpr double rad_per_deg = std::numbers::pi / 180.0;

double deflection_deg(double high_us) { return (high_us - 1500.0) / 10.0; }

}  // namespace

WholeBoard::WholeBoard() {
  spi_1_.attach(port_a_, 4, imu_wire);
  spi_2_.attach(port_b_, 12, encoder_wires[0]);
  spi_2_.attach(port_b_, 0, encoder_wires[1]);
  spi_2_.attach(port_b_, 1, encoder_wires[2]);
  spi_2_.attach(port_c_, 5, encoder_wires[3]);
  spi_3_.attach(port_c_, 4, accelerometer_wire);
  spi_3_.attach(port_a_, 15, flash_wire);
}

void WholeBoard::power_up() {
  imu_.start(stm32::SensorStart::power_up);
  accelerometer_.start(stm32::SensorStart::power_up);
  flash_.start();
  avionics_.emplace(avionics::Devices{.clock = clock_,
                                      .imu = imu_,
                                      .accelerometer = accelerometer_,
                                      .servo = servo_,
                                      .encoder = encoder_,
                                      .arm_switch = arm_switch_,
                                      .abort_contact = abort_contact_,
                                      .can_bus = can_bus_,
                                      .flash = flash_,
                                      .console = console_,
                                      .watchdog = watchdog,
                                      .entropy = entropy_,
                                      .board = board_,
                                      .backup_memory = backup_memory_},
                    core::default_plan());
}

const core::TickRecord& WholeBoard::tick() {
  if (!avionics_) {
    power_up();
  }
  clock_.time += millisecond;
  ticks_ += 1;
  move_canards();
  move_rocket();
  fake::RegisterWorld::poke(port_c_.block().idr, switch_level() ? 1U << 3U : 0U);
  look_at_faults();
  record_ = &avionics_->tick();
  for (std::size_t i = 0; i < hal::canards; ++i) {
    verdicts_[i] = record_->verdicts[i] == core::CanardVerdict::healthy ? verdicts_[i] : record_->verdicts[i];
  }
  if (!zero_rad_ && record_->phase == core::Phase::launched) {
    zero_rad_ = angle_rad_;
  }
  pc_.listen();
  const auto& report = pc_.heard<protocol::BoardReport>();
  flash_failed_ = flash_failed_ || (report && report->flash_failed);
  return *record_;
}

bool WholeBoard::switch_level() {
  if (!switch_is_stuck) {
    last_level_ = switch_closed_;
  }
  const bool bounced = switch_chatters && ticks_ / 30 % 2 == 0;
  return !switch_wire_is_off && last_level_ != bounced;
}

std::optional<fake::LineEdge> WholeBoard::data_ready_edge() {
  if (imu_line_storms) {
    return fake::LineEdge{.time = clock_.time, .number = stormy_edges_ += 5};
  }
  return imu_line_is_on ? imu_device.interrupt_1() : std::optional<fake::LineEdge>{};
}

// As the board's wait_for_tick() does.
void WholeBoard::look_at_faults() {
  arm_switch_.update();
  abort_contact_.update();
  battery_.update();
  hal::BoardFaults now = imu_.faults();
  now.add(accelerometer_.faults());
  now.add(encoder_.faults());
  now.add(flash_.faults());
  board_.set_now(now);
  seen_.add(board_.status().faults);
}

const core::TickRecord& WholeBoard::run(int milliseconds) {
  for (int i = 0; i < milliseconds; ++i) {
    tick();
  }
  return *record_;
}

void WholeBoard::try_to_arm() {
  using protocol::SelfTestState;
  pc_.say(protocol::ArmAction::self_test);
  const auto is_over = [this] {
    const auto& reply = pc_.heard<protocol::ArmReply>();
    return reply && reply->self_test != SelfTestState::running;
  };
  for (int waited_ms = 0; waited_ms < 15'000 && (waited_ms < 100 || !is_over()); waited_ms += 50) {
    run(50);
  }
  switch_closed_ = true;
  run(100);
  pc_.say(protocol::ArmAction::begin);
  run(20);
  const auto reply = pc_.heard<protocol::ArmReply>();
  pc_.say(protocol::ArmAction::confirm, reply ? reply->nonce.value_or(0) : 0);
  run(20);
}

std::string WholeBoard::refusal() const {
  constexpr std::array<std::string_view, 16> failures{"none",
                                                      "not_safe",
                                                      "moved",
                                                      "gyro_failed",
                                                      "accelerometer_failed",
                                                      "specific_force_not_one_g",
                                                      "accelerometers_disagree",
                                                      "encoder_silent",
                                                      "canard_did_not_follow",
                                                      "another_canard_moved",
                                                      "no_valid_plan",
                                                      "flash_failed",
                                                      "flash_too_full",
                                                      "timed_out",
                                                      "board_fault",
                                                      "newer_plan"};
  constexpr std::array<std::string_view, 13> refusals{
      "none",        "not_safe", "session_open",  "self_test_not_passed", "switch_not_cycled", "switch_open",
      "not_at_rest", "no_nonce", "nonce_expired", "wrong_nonce",          "not_a_tunnel_plan", "not_armed",
      "board_fault"};
  const auto& reply = pc_.heard<protocol::ArmReply>();
  if (!reply) {
    return "no answer";
  }
  const bool passed = reply->failure == protocol::SelfTestFailure::none;
  return std::string{passed ? refusals[static_cast<std::size_t>(reply->refusal)]
                            : failures[static_cast<std::size_t>(reply->failure)]};
}

std::string WholeBoard::faults() const {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  for (std::size_t i = 0; i < hal::board_faults; ++i) {
    const auto fault = static_cast<hal::BoardFault>(i);
    if (seen_.has(fault)) {
      add(std::string{name(fault)});
    }
  }
  const bool alike = std::ranges::all_of(verdicts_, [this](core::CanardVerdict each) { return each == verdicts_[0]; });
  for (std::size_t i = 0; i < (alike ? 1 : hal::canards); ++i) {
    if (verdicts_[i] != core::CanardVerdict::healthy) {
      add((alike ? "all canards " : "canard " + std::to_string(i + 1) + " ") + std::string{name(verdicts_[i])});
    }
  }
  if (flash_failed_) {
    add("flash_failed");
  }
  return names;
}

void WholeBoard::forget_faults() {
  seen_ = {};
  verdicts_ = {};
  flash_failed_ = false;
}

double WholeBoard::roll_deg() const { return (angle_rad_ - zero_rad_.value_or(angle_rad_)) / rad_per_deg; }

double WholeBoard::roll_error_deg() const {
  return std::abs(static_cast<double>(record_->motion.roll_angle.degrees()) - roll_deg());
}

void WholeBoard::move_canards() {
  servo_timer_.pass(timers_hz / 1000 / servo_timer_.divider());
  if (servo_timer_.frames().empty()) {
    return;
  }
  const auto& frame = servo_timer_.frames().back();
  const double us_per_count = 1e6 * static_cast<double>(servo_timer_.divider()) / timers_hz;
  last_deg_ = 0.0;
  for (std::size_t i = 0; i < hal::canards; ++i) {
    const std::size_t output = driven_by[i];
    const bool driven = frame.driven[output] && frame.high[output] > 0;
    const double asked_deg = driven ? deflection_deg(frame.high[output] * us_per_count) : 0.0;
    last_deg_ = std::max(last_deg_, std::abs(asked_deg));
    if (servo_dead[i]) {
      shaft_deg_[i] -= shaft_deg_[i] / 20.0;
    } else if (driven && !servo_jammed[i]) {
      shaft_deg_[i] += (asked_deg - shaft_deg_[i]) / servo_lag_ms[i];
    }
  }
  largest_deg_ = std::max(largest_deg_, last_deg_);
  std::uniform_int_distribution<int> noise{-1, 1};
  for (std::size_t i = 0; i < hal::canards; ++i) {
    const double counts = (shaft_deg_[encoder_of[i]] + 360.0) * 16384.0 / 360.0;
    encoder_devices[i].angle = static_cast<std::uint16_t>((std::lround(counts) + noise(random_) + 16384) % 16384);
  }
}

void WholeBoard::move_rocket() {
  constexpr double braking = 2.0;    // 1/s
  constexpr double turning = 400.0;  // 1/s2
  constexpr double fins_askew_rad = 0.004;
  const bool flies = lit_ && clock_.time > *lit_;
  if (flies) {
    const double canards_rad = (shaft_deg_[0] + shaft_deg_[1] + shaft_deg_[2] + shaft_deg_[3]) / 4.0 * rad_per_deg;
    rate_rad_s_ += 0.001 * (turning * (canards_rad + fins_askew_rad) - braking * rate_rad_s_);
    angle_rad_ += 0.001 * rate_rad_s_;
  }
  const bool burns = flies && clock_.time <= *lit_ + 3'000 * millisecond;
  const double axial_g = burns ? 6.0 : flies ? -0.3 : 1.0;
  imu_device.rate_deg_s = {rate_rad_s_ / rad_per_deg, 0.0, 0.0};
  imu_device.force_g = {axial_g, 0.0, 0.0};
  accelerometer_device.force_g = imu_device.force_g;
}

}  // namespace fantail::devices
