// SPDX-License-Identifier: MIT
#include "sim/world.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "avionics/flash_map.hpp"
#include "hal/sim/console.hpp"
#include "hal/sim/entropy.hpp"
#include "hal/sim/flash.hpp"
#include "protocol/log_frame.hpp"
#include "sim/nearest_tick.hpp"
#include "sim/random_streams.hpp"

namespace fantail::sim {
namespace {

using core::Microseconds;

constexpr double tick_time_s = 1e-3;

// Many bytes at a time: nearly all of a large flash is blank, and byte by byte that would take as long as the flight.
std::span<const std::byte> without_blank_end(std::span<const std::byte> cells) {
  constexpr std::size_t together = 4096;
  const auto is_blank = [](std::byte cell) { return cell == std::byte{0xFF}; };
  const auto all_as_the_first = [](std::span<const std::byte> part) {
    return std::memcmp(part.data(), part.data() + 1, part.size() - 1) == 0;
  };
  while (cells.size() >= together && is_blank(cells.back()) && all_as_the_first(cells.last(together))) {
    cells = cells.first(cells.size() - together);
  }
  const auto last = std::find_if_not(cells.rbegin(), cells.rend(), is_blank);
  return cells.first(static_cast<std::size_t>(cells.rend() - last));
}

BoardPorts with_memory_for(const Scenario& scenario, BoardPorts ports) {
  // What has been damaged is mended from there, too.
  ports.has_backup_memory = std::ranges::any_of(scenario.faults, [](const Fault& fault) {
    return std::holds_alternative<Reset>(fault.how) || fault.device == Device::memory;
  });
  return ports;
}

Random random_of_faults(const Scenario& scenario) {
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;  // so that neighbours of a seed are none of its variants
  return {scenario.seed + golden * scenario.fault_variant, RandomStream::faults};
}

std::string sensors_in_record(std::size_t changed_values) {
  return changed_values == 0   ? "simulated"
         : changed_values == 1 ? "simulated, 1 value changed"
                               : "simulated, " + std::to_string(changed_values) + " values changed";
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
      environment_{scenario, Random{scenario.seed, RandomStream::turbulence}},
      roll_plant_{scenario.vehicle.roll_plant},
      disturbance_{scenario.disturbance},
      disturbance_rad_{disturbance_now_rad()},
      canards_{scenario.vehicle, Random{scenario.seed, RandomStream::encoder_noise},
               Random{scenario.seed, RandomStream::servo_spread}},
      fin_wash_{scenario.vehicle.canard_air.wash, scenario.vehicle.canard_air.wash_distance_m},
      vibration_{scenario.vehicle.vibration, Random{scenario.seed, RandomStream::shaking}},
      imu_feels_{scenario.vehicle.imu_feels},
      second_imu_feels_{scenario.vehicle.second_imu_feels},
      accelerometer_feels_{scenario.vehicle.accelerometer_feels},
      imu_model_{scenario.vehicle.imu, Random{scenario.seed, RandomStream::imu_noise}},
      second_imu_model_{scenario.vehicle.second_imu, Random{scenario.seed, RandomStream::second_imu_noise}},
      accelerometer_model_{scenario.vehicle.accelerometer, Random{scenario.seed, RandomStream::accelerometer_noise}},
      barometer_model_{scenario.vehicle.barometer, Random{scenario.seed, RandomStream::barometer_noise}},
      pad_{std::move(pad)},
      sensors_{sensors_in_record(scenario.changed_values)},
      board_{make(scenario.plan, with_memory_for(scenario, ports),
                  {.firmware_version = avionics::firmware_version(),
                   .git_hash = avionics::git_hash(),
                   .vehicle = scenario.vehicle.name,
                   .sensors = sensors_})},
      hardware_{board_->hardware()} {
  hardware_.imu_scale = imu_model_.scale();
  hardware_.second_imu_is_fitted = scenario.vehicle.second_imu_is_fitted;
  hardware_.second_imu_scale = second_imu_model_.scale();
  hardware_.accelerometer_scale_m_s2 = accelerometer_model_.scale();
  hardware_.barometer_is_fitted = scenario.vehicle.barometer.is_fitted;
  if (!scenario.faults.empty()) {
    faults_.emplace(scenario.faults, random_of_faults(scenario));
  }
  if (scenario.imposed_roll) {
    imposed_roll_after_liftoff_ = nearest_tick(scenario.imposed_roll->time_s);
  }
}

World::~World() = default;

const core::TickRecord& World::tick() {
  if (faults_) {
    begin_faults();
  }
  impose_roll();
  fill_hardware();
  if (pad_) {
    let_crew_act();
  }
  hardware_.abort_contact_closed = abort_contact_is_closed();
  if (faults_) {
    spoil_hardware();
  }
  if (down_until_) {
    follow_reset();
  }
  if (!is_held_down()) {
    const bool had_tick_before = hardware_.had_tick;
    last_record_ = &board_->tick();
    if (!had_tick_before || !hardware_.had_tick) {
      note_own_gap();
    }
  }
  if (!is_down()) {
    phase_ = last_record_->phase;
    if (!gaps_.empty()) {
      note_resume();
    }
  }
  follow_events();
  return *last_record_;
}

void World::advance() {
  if (waits_for_ignition_) {
    ignition_ += tick_time;
  }
  const double from_ignition_s = in_seconds(now_ - ignition_);
  const double density_before = environment_.density_kg_m3();
  const double speed_before = environment_.speed_m_s();
  canards_.step(in_seconds(now_), tick_time_s, faults_ ? faults_->heard(hardware_.pulses) : hardware_.pulses,
                {.density_kg_m3 = density_before, .speed_m_s = speed_before, .roll_rate_rad_s = roll_.rate_rad_s});
  const double disturbance_before = disturbance_rad_;
  if (const auto side_area_m2 = scenario_.vehicle.canard_air.side_area_m2) {
    environment_.push_aside(*side_area_m2 * canards_.across_rad(roll_.rate_rad_s, speed_before),
                            scenario_.vehicle.canard_air.position_m.value_or(0.0), roll_.angle_rad);
  }
  environment_.advance_to(from_ignition_s + tick_time_s, roll_.rate_rad_s);
  now_ += tick_time;
  disturbance_rad_ = disturbance_now_rad();

  const double speed_m_s = 0.5 * (speed_before + environment_.speed_m_s());
  const double canard_rad = canards_.mean_torque_angle_rad(roll_.rate_rad_s, speed_m_s);
  const double wash_rad = fin_wash_.step(canard_rad, speed_m_s * tick_time_s);

  // A rocket on the pad cannot roll, and one in the tunnel is held by hand until control starts.
  roll_acceleration_rad_s2_ = 0.0;
  if (events_.liftoff && environment_.can_roll()) {
    const double rate_before_rad_s = roll_.rate_rad_s;
    roll_plant_.inertia_kg_m2 = environment_.roll_inertia_kg_m2().value_or(roll_plant_.inertia_kg_m2);
    const double deflection_rad = canard_rad - wash_rad + 0.5 * (disturbance_before + disturbance_rad_);
    // Compressibility makes alpha and beta larger alike, as a larger density would.
    const double density_kg_m3 =
        environment_.compressibility() * (0.5 * (density_before + environment_.density_kg_m3()));
    roll_ = roll_plant_.step(roll_, density_kg_m3, speed_m_s, deflection_rad, tick_time_s);
    roll_acceleration_rad_s2_ = (roll_.rate_rad_s - rate_before_rad_s) / tick_time_s;
  } else if (const auto by_hand = environment_.turn_by_hand(in_seconds(now_), tick_time_s)) {
    roll_ = *by_hand;
  }
}

void World::ignite() {
  if (waits_for_ignition_) {
    waits_for_ignition_ = false;
    ignition_ = now_;
  }
}

Truth World::truth() const {
  const std::optional<double> twist_rad = environment_.twist_rad();
  return {.roll_angle_rad = roll_.angle_rad,
          .roll_rate_rad_s = roll_.rate_rad_s,
          .canard_rad = canards_.torque_angle_rad(roll_.rate_rad_s, environment_.speed_m_s()) - fin_wash_.angle_rad(),
          .height_m = environment_.height_m(),
          .speed_m_s = environment_.speed_m_s(),
          .disturbance_rad = disturbance_rad_,
          .geometric_roll_rad = twist_rad ? std::optional{roll_.angle_rad + *twist_rad} : std::nullopt};
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

bool World::abort_contact_is_closed() const {
  switch (scenario_.plan.run.abort_input) {
    case core::AbortInput::none: break;
    case core::AbortInput::open_aborts: return !abort_is_pressed_;
    case core::AbortInput::closed_aborts: return abort_is_pressed_;
  }
  return false;
}

void World::impose_roll() {
  if (roll_is_imposed_ || !scenario_.imposed_roll || !events_.liftoff ||
      now_ < *events_.liftoff + imposed_roll_after_liftoff_) {
    return;
  }
  roll_ = {.angle_rad = scenario_.imposed_roll->angle_rad, .rate_rad_s = scenario_.imposed_roll->rate_rad_s};
  roll_is_imposed_ = true;
}

void World::let_crew_act() {
  pad_->crew.act(now_);
  hardware_.arm_switch_closed = pad_->crew.switch_closed();
  if (now_ == ignition_ && scenario_.surroundings != Surroundings::flight) {
    pad_->crew.start_tunnel();
  }
}

void World::begin_faults() {
  if (const Reset* reset = faults_->begin_tick(now_ - ignition_, canards_, sensor_faults_)) {
    begin_reset(*reset);
  }
}

void World::spoil_hardware() {
  faults_->spoil({.hardware = hardware_,
                  .board = *board_,
                  .abort_input = scenario_.plan.run.abort_input,
                  .wire = pad_ ? &pad_->wire : nullptr,
                  .flash = pad_ ? &pad_->flash : nullptr});
}

std::optional<protocol::ArmReply> World::refusal_to_arm() const { return pad_ ? pad_->crew.refusal() : std::nullopt; }

std::uint32_t World::faults_told_to_crew() const { return pad_ ? pad_->crew.board_faults() : 0; }

std::span<const std::byte> World::recorded() const {
  const auto map = pad_ ? avionics::flash_map(pad_->flash.geometry()) : std::nullopt;
  if (!map) {
    return {};
  }
  const auto region = std::span<const std::byte>{pad_->flash.cells()}.subspan(map->flight_begin);
  // Before the blank part may be a record of which only the beginning was written when the world ended, and the last
  // bytes of a whole one may look erased.
  const std::size_t used = without_blank_end(region).size();
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

}  // namespace fantail::sim
