// SPDX-License-Identifier: MIT
#include "sim/world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "avionics/flash_map.hpp"
#include "hal/sim/console.hpp"
#include "hal/sim/entropy.hpp"
#include "hal/sim/flash.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::sim {
namespace {

using core::Microseconds;

constexpr Microseconds tick_time{1'000};
constexpr double tick_time_s = 1e-3;
// A start command that the avionics has not followed by then was refused.
constexpr Microseconds start_patience{1'000'000};

enum Stream : std::uint8_t { imu_noise = 1, accelerometer_noise, encoder_noise, turbulence, servo_spread };

Microseconds nearest_tick(double time_s) { return std::llround(time_s / tick_time_s) * tick_time; }

double in_seconds(Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

ServoFault servo_fault(FaultKind kind) {
  switch (kind) {
    case FaultKind::canard_stuck: return ServoFault::stuck;
    case FaultKind::canard_hardover: return ServoFault::hardover;
    case FaultKind::canard_dead: return ServoFault::dead;
    case FaultKind::canard_slipping: return ServoFault::slipping;
    case FaultKind::canard_reversed: return ServoFault::reversed;
    case FaultKind::canard_slow: return ServoFault::slow;
    case FaultKind::canard_wrong_trim: return ServoFault::wrong_trim;
    default: return ServoFault::none;
  }
}

}  // namespace

/// Everything that a flight needs beside the rocket when nobody else is there.
struct World::LonePad {
  LonePad(Microseconds arm_time, const hal::FlashGeometry& geometry) : flash{geometry}, crew{wire, arm_time} {}
  [[nodiscard]] BoardPorts ports() {
    return {.can_bus = can_bus, .flash = flash, .console = console, .entropy = entropy};
  }

  hal::sim::CanWire wire;
  hal::sim::CanBus can_bus{wire};
  hal::sim::Flash flash;
  hal::sim::Console console;
  hal::sim::Entropy entropy;
  PadCrew crew;
};

World::World(const Scenario& scenario, const hal::FlashGeometry& flash, const MakeFlightComputer& make)
    : World{scenario, std::make_unique<LonePad>(nearest_tick(scenario.arm_time_s), flash), make} {}

World::World(const Scenario& scenario, const BoardPorts& ports, const MakeFlightComputer& make)
    : World{scenario, ports, nullptr, make} {}

World::World(const Scenario& scenario, std::unique_ptr<LonePad> pad, const MakeFlightComputer& make)
    : World{scenario, pad->ports(), std::move(pad), make} {}

World::World(const Scenario& scenario, const BoardPorts& ports, std::unique_ptr<LonePad> pad,
             const MakeFlightComputer& make)
    : scenario_{scenario},
      ignition_{nearest_tick(scenario.pad_time_s)},
      waits_for_ignition_{pad == nullptr},
      time_after_end_{nearest_tick(scenario.time_after_end_s)},
      wind_sensor_period_{nearest_tick(scenario.wind_sensor.period_s)},
      environment_{scenario, Random{scenario.seed, turbulence}},
      disturbance_{scenario.disturbance},
      disturbance_rad_{disturbance_now_rad()},
      canards_{scenario.vehicle, Random{scenario.seed, encoder_noise}, Random{scenario.seed, servo_spread}},
      imu_model_{scenario.vehicle.imu, Random{scenario.seed, imu_noise}},
      accelerometer_model_{scenario.vehicle.accelerometer, Random{scenario.seed, accelerometer_noise}},
      fault_is_applied_(scenario.faults.size(), false),
      pad_{std::move(pad)},
      board_{make(scenario.plan, ports,
                  {.firmware_version = avionics::firmware_version(),
                   .git_hash = avionics::git_hash(),
                   .vehicle = scenario.vehicle.name,
                   .sensors = "simulated"})},
      hardware_{board_->hardware()} {
  hardware_.imu_scale = imu_model_.scale();
  hardware_.accelerometer_scale_m_s2 = accelerometer_model_.scale();
  if (scenario.imposed_roll) {
    imposed_roll_after_liftoff_ = nearest_tick(scenario.imposed_roll->time_s);
  }
}

World::~World() = default;

const core::TickRecord& World::tick() {
  if (!scenario_.faults.empty()) {
    apply_faults();
  }
  impose_roll();
  fill_hardware();
  if (pad_) {
    let_crew_act();
  }
  const core::TickRecord& record = board_->tick();
  phase_ = record.phase;
  follow_events();
  return record;
}

void World::advance() {
  if (waits_for_ignition_) {
    ignition_ += tick_time;
  }
  const double from_ignition_s = in_seconds(now_ - ignition_);
  canards_.step(in_seconds(now_), tick_time_s, hardware_.pulses);
  const double density_before = environment_.density_kg_m3();
  const double speed_before = environment_.speed_m_s();
  const double disturbance_before = disturbance_rad_;
  environment_.advance_to(from_ignition_s + tick_time_s);
  now_ += tick_time;
  disturbance_rad_ = disturbance_now_rad();

  // A rocket on the pad cannot roll, and one in the tunnel is held by hand until control starts.
  if (events_.liftoff) {
    const double deflection_rad = canards_.mean_deflection_rad() + 0.5 * (disturbance_before + disturbance_rad_);
    roll_ =
        scenario_.vehicle.roll_plant.step(roll_, 0.5 * (density_before + environment_.density_kg_m3()),
                                          0.5 * (speed_before + environment_.speed_m_s()), deflection_rad, tick_time_s);
  }
}

void World::ignite() {
  if (waits_for_ignition_) {
    waits_for_ignition_ = false;
    ignition_ = now_;
  }
}

Truth World::truth() const {
  return {.roll_angle_rad = roll_.angle_rad,
          .roll_rate_rad_s = roll_.rate_rad_s,
          .canard_rad = canards_.deflection_rad(),
          .height_m = environment_.height_m(),
          .speed_m_s = environment_.speed_m_s(),
          .disturbance_rad = disturbance_rad_};
}

std::optional<WindReading> World::wind_reading() const {
  if (scenario_.surroundings != Surroundings::tunnel || now_ % wind_sensor_period_ != Microseconds{0}) {
    return std::nullopt;
  }
  return WindReading{.fan_rpm = environment_.fan_rpm(),
                     .wind_speed_m_s = scenario_.wind_sensor.shown_m_s(environment_.speed_m_s())};
}

double World::disturbance_now_rad() const {
  const double time_s = events_.liftoff ? in_seconds(now_ - *events_.liftoff) : 0.0;
  return disturbance_.at(time_s) + environment_.swirl_rad();
}

void World::apply_faults() {
  imu_hangs_ = false;
  accelerometer_hangs_ = false;
  for (std::size_t i = 0; i < scenario_.faults.size(); ++i) {
    const Fault& fault = scenario_.faults[i];
    if (now_ < ignition_ + nearest_tick(fault.from_s)) {
      continue;
    }
    if (is_dropout(fault.kind)) {
      const bool present = now_ < ignition_ + nearest_tick(fault.until_s);
      imu_hangs_ = imu_hangs_ || (present && fault.kind == FaultKind::imu_dropout);
      accelerometer_hangs_ = accelerometer_hangs_ || (present && fault.kind == FaultKind::accelerometer_dropout);
    } else if (!fault_is_applied_[i]) {
      fault_is_applied_[i] = true;
      break_canard(fault);
    }
  }
}

void World::break_canard(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::encoder_unplugged: canards_.unplug_encoder(fault.canard); break;
    case FaultKind::encoder_noisy: canards_.make_encoder_noisy(fault.canard, fault.noise_counts); break;
    default: canards_.fail(fault.canard, servo_fault(fault.kind), fault.angle_rad);
  }
}

void World::impose_roll() {
  if (roll_is_imposed_ || !scenario_.imposed_roll || !events_.liftoff ||
      now_ < *events_.liftoff + imposed_roll_after_liftoff_) {
    return;
  }
  roll_ = {.angle_rad = scenario_.imposed_roll->angle_rad, .rate_rad_s = scenario_.imposed_roll->rate_rad_s};
  roll_is_imposed_ = true;
}

void World::fill_hardware() {
  const Vector3 specific_force_m_s2 = environment_.specific_force_m_s2(roll_.angle_rad);
  const hal::EncoderReading encoders = canards_.read_encoders(now_);
  const hal::ImuSample& imu = imu_model_.sample(now_, {.x = roll_.rate_rad_s}, specific_force_m_s2, imu_hangs_);
  const hal::AccelerometerSample& accelerometer =
      accelerometer_model_.sample(now_, specific_force_m_s2, accelerometer_hangs_);
  // All are measured before any is copied: a copy of freshly written counts makes the processor wait, and so it waits
  // once instead of three times.
  hardware_.time = now_;
  hardware_.encoders = encoders;
  hardware_.imu = imu;
  hardware_.accelerometer = accelerometer;
}

void World::let_crew_act() {
  pad_->crew.act(now_);
  hardware_.arm_switch_closed = pad_->crew.switch_closed();
  if (now_ == ignition_ && scenario_.surroundings == Surroundings::tunnel) {
    pad_->crew.start_tunnel();
  }
}

std::optional<protocol::ArmReply> World::refusal_to_arm() const { return pad_ ? pad_->crew.refusal() : std::nullopt; }

std::span<const std::byte> World::recorded() const {
  const auto map = pad_ ? avionics::flash_map(pad_->flash.geometry()) : std::nullopt;
  if (!map) {
    return {};
  }
  const auto region = std::span<const std::byte>{pad_->flash.cells()}.subspan(map->flight_begin);
  const auto blank =
      std::ranges::find_if(region.rbegin(), region.rend(), [](std::byte b) { return b != std::byte{0xFF}; });
  // Before the blank part may be a record of which only the beginning was written when the world ended, and the last
  // bytes of a whole one may look erased.
  const auto used = static_cast<std::size_t>(region.rend() - blank);
  const auto written = region.first(std::min(used + map->page_size, region.size()));
  protocol::LogFrameReader reader{written};
  std::size_t end = 0;
  while (const auto frame = reader.next()) {
    end = frame->position + protocol::log_frame_overhead + frame->payload.size();
  }
  return written.first(end);
}

bool World::record_is_full() const {
  const auto map = pad_ ? avionics::flash_map(pad_->flash.geometry()) : std::nullopt;
  return map && recorded().size() + map->sector_size > map->flight_end - map->flight_begin;
}

void World::follow_events() {
  if (scenario_.surroundings == Surroundings::tunnel) {
    follow_tunnel();
  } else {
    follow_flight();
  }
}

void World::follow_tunnel() {
  if (!events_.liftoff && phase_ == core::Phase::controlling) {
    events_.liftoff = now_;
  }
  const bool refused = !events_.liftoff && now_ >= ignition_ + start_patience;
  if (!end_ && (phase_ == core::Phase::finished || refused)) {
    end_ = now_ + time_after_end_;
  }
}

void World::follow_flight() {
  const auto note = [this](std::optional<Microseconds>& event, bool happened) {
    if (!event && happened) {
      event = now_;
    }
  };
  const AscentEvents& ascent = environment_.ascent_events();
  note(events_.liftoff, ascent.liftoff_s.has_value());
  note(events_.guide_clear, environment_.distance_m() >= static_cast<double>(scenario_.plan.guide.length_m));
  note(events_.burnout, ascent.burnout_s.has_value());
  note(events_.apogee, ascent.apogee_s.has_value());
  if (!ascent.apogee_s) {
    events_.apogee.reset();  // it was only a hop, and the rocket stands on the pad again
  }
  // A motor too weak for its rocket burns out on the pad.
  const bool nothing_more_to_come = events_.apogee || (events_.burnout && environment_.distance_m() <= 0.0);
  if (!nothing_more_to_come) {
    end_.reset();
  } else if (!end_) {
    end_ = now_ + time_after_end_;
  }
}

}  // namespace fantail::sim
