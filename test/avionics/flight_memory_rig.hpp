// SPDX-License-Identifier: MIT
#pragma once

#include "avionics/backup_map.hpp"
#include "avionics/flight_memory.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::avionics {

using core::Microseconds;
using core::Phase;
using hal::ResetCause;

using Memory = std::array<std::byte, backup_size>;

inline constexpr std::uint32_t plan_crc = 0x12345678;
inline constexpr Microseconds millisecond{1'000};
inline constexpr Microseconds second{1'000'000};

/// The bytes of somebody else as a backup domain, and its clock.
struct Domain final : hal::BackupMemory {
  explicit Domain(std::span<std::byte> bytes_there) : bytes_{bytes_there} {}
  std::span<std::byte> bytes() override { return bytes_; }
  std::optional<Microseconds> running_time() override { return running; }

  std::optional<Microseconds> running{};

 private:
  std::span<std::byte> bytes_;
};

struct SetClock final : hal::Clock {
  [[nodiscard]] Microseconds now() const override { return shows; }
  Microseconds shows{};
};

inline std::optional<Microseconds> clock_after_reset(std::span<std::byte> memory, ResetCause cause,
                                                     Microseconds assumed_gap,
                                                     std::optional<Microseconds> running = std::nullopt) {
  Domain domain{memory};
  domain.running = running;
  return clock_after_reset(domain, cause, assumed_gap);
}

/// A law in control, which is kept; nothing but what it remembers matters.
struct Kept {
  core::FlightPlan plan = [] {
    core::FlightPlan tunnel = core::default_plan();
    tunnel.run.start = core::Start::tunnel;
    return tunnel;
  }();
  core::Autopilot law{plan};
  core::Inputs inputs{};
  Memory memory{};
  Domain domain{memory};
  SetClock clock;
  FlightMemory kept{domain, clock, ResetCause::power_on};
  std::optional<std::uint32_t> sectors{};
  Microseconds since_tick_began{};

  Kept() {
    inputs.arm_switch_closed = true;
    inputs.gyro.quality = core::SampleQuality::valid;
    for (auto& sample : inputs.accelerometers) {
      sample = {.specific_force_m_s2 = {.x = core::standard_gravity_m_s2}, .quality = core::SampleQuality::valid};
    }
    for (int i = 0; i < 5000; ++i) {
      tick();
    }
    inputs.arm_command = true;
    tick();
    inputs.arm_command = false;
    inputs.start_command = true;
    tick();
    inputs.start_command = false;
    EXPECT_EQ(law.phase(), Phase::controlling);
    run(100);
  }

  void tick() {
    inputs.time += millisecond;
    clock.shows = inputs.time + since_tick_began;
    if (domain.running) {
      domain.running = *domain.running + millisecond;
    }
    inputs.gyro.time = inputs.accelerometers[0].time = inputs.accelerometers[1].time = inputs.time;
    kept.keep(law.step(inputs), plan_crc, sectors, law);
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick();
    }
  }
  [[nodiscard]] core::Inputs after(Microseconds gap) const {
    core::Inputs first = inputs;
    first.time += gap;
    first.gyro.time = first.time;
    return first;
  }
};

inline std::optional<FlightMemory::Resumed> resume(std::span<std::byte> memory, const core::Inputs& first,
                                                   const core::FlightPlan& plan, std::uint32_t crc = plan_crc,
                                                   ResetCause cause = ResetCause::watchdog) {
  Domain domain{memory};
  const SetClock clock;
  FlightMemory found{domain, clock, cause};
  core::Autopilot law{plan};
  return found.waits() ? found.resume(first, crc, law) : std::nullopt;
}

}  // namespace fantail::avionics
