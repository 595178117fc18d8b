// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "avionics/flash_service.hpp"
#include "core/autopilot.hpp"
#include "flash_rig.hpp"
#include "hal/sim/can_bus.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_notes.hpp"
#include "random_stream.hpp"

namespace fantail::avionics {

/// Remembers what was programmed into the region of the flights.
class NotingFlash final : public hal::Flash {
 public:
  struct Program {
    std::uint32_t address;
    Bytes bytes;
  };

  explicit NotingFlash(hal::Flash& flash) : flash_{flash} {}
  [[nodiscard]] hal::FlashGeometry geometry() const override { return flash_.geometry(); }
  hal::FlashResult read(std::uint32_t address, std::span<std::byte> out) override { return flash_.read(address, out); }
  hal::FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override {
    const hal::FlashResult result = flash_.program(address, bytes);
    if (result == hal::FlashResult::ok && address >= flash_map(geometry())->flight_begin) {
      programs.push_back({address, {bytes.begin(), bytes.end()}});
    }
    return result;
  }
  hal::FlashResult erase_sector(std::uint32_t address) override { return flash_.erase_sector(address); }
  [[nodiscard]] bool busy() override { return flash_.busy(); }

  std::vector<Program> programs;

 private:
  hal::Flash& flash_;
};

inline constexpr hal::FlashGeometry one_mib{.size = 1U << 20U, .sector_size = 4096, .page_size = 256};

/// Of a processor that counts its cycles, where a test says how many.
struct CountingBoard final : hal::Board {
  hal::BoardStatus status() override { return {}; }
  void show(hal::Signal /*signal*/) override {}
  std::optional<std::uint32_t> take_longest_tick_cycles() override { return std::exchange(cycles, std::nullopt); }
  std::optional<std::uint32_t> cycles{};
};

/// A recorder with a flash, and a rocket of which nothing is real but the bytes: whoever uses it says what phase it is.
class RecorderRig {
 public:
  /// `world`: of a flash that takes its time.
  explicit RecorderRig(hal::Flash& flash, std::uint32_t seed = 1, hal::sim::WorldSide* world = nullptr)
      : noting{flash}, world_{world}, random_{seed} {
    service.recorder().take_plan(plan_);
    for (int i = 0; i < 600 && !service.flights().finished(); ++i) {
      tick(core::Phase::safe);
    }
  }

  /// What is read and commanded is random, and so are the states from which a replay would begin.
  void tick(core::Phase phase) {
    time += avionics::tick;
    if (world_ != nullptr) {
      world_->time = time;
    }
    for (std::int16_t& count : raw_.imu.rate) {
      count = static_cast<std::int16_t>(random_.whole(-32'768, 32'767));
    }
    raw_.imu.time = raw_.accelerometer.time = time;
    raw_.imu.status = raw_.accelerometer.status = hal::Status::ok;
    core::TickRecord record = law_.step(
        {.time = time,
         .gyro = {
             .time = time, .rate_rad_s = {.x = random_.between(-9.0F, 9.0F)}, .quality = core::SampleQuality::valid}});
    record.phase = phase;
    record.motion.at_rest_for = rests ? core::Microseconds{10'000'000} : core::Microseconds{0};
    const core::AccelerometerSample felt{
        .time = time, .specific_force_m_s2 = specific_force_m_s2, .quality = core::SampleQuality::valid};
    service.recorder().note({.raw = raw_,
                             .scales = {},
                             .inputs = {.time = time, .accelerometers = {felt, {}}, .canard_request = request},
                             .record = record,
                             .bus = bus_,
                             .power_up = 1,
                             .board = &board,
                             .faults = faults},
                            law_);
    service.update(time, false);
  }
  void run(core::Phase phase, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick(phase);
    }
  }
  /// Until nothing more is to be written.
  void settle(core::Phase phase) {
    for (int i = 0; i < 5000 && service.recorder().busy(); ++i) {
      tick(phase);
    }
  }

  bool rests = true;
  core::Vector3 specific_force_m_s2{.x = core::standard_gravity_m_s2};
  std::optional<std::array<core::Angle, core::canard_count>> request{};
  CountingBoard board;
  hal::BoardFaults faults{};
  NotingFlash noting;
  FlashService service{noting};
  core::Microseconds time{};

 private:
  hal::sim::WorldSide* world_;
  core::FlightPlan plan_ = core::default_plan();
  core::Autopilot law_{plan_};
  core::RandomStream random_;
  RawSamples raw_{};
  hal::sim::CanWire wire_;
  hal::sim::CanBus bus_{wire_};
};

/// The region of the flights.
inline std::span<std::byte> region_of(hal::sim::Flash& flash) {
  return flash.cells().subspan(flash_map(flash.geometry())->flight_begin);
}

struct Record {
  std::size_t begin = 0;  ///< in the bytes it was read from
  std::size_t end = 0;
  std::uint8_t type = 0;
  std::uint32_t sequence = 0;
};

inline std::vector<Record> records_in(std::span<const std::byte> bytes) {
  std::vector<Record> records;
  protocol::LogFrameReader reader{bytes};
  while (const auto frame = reader.next()) {
    records.push_back({.begin = frame->position,
                       .end = frame->position + protocol::log_frame_overhead + frame->payload.size(),
                       .type = frame->head.type,
                       .sequence = frame->head.sequence});
  }
  return records;
}

inline std::vector<protocol::LogEvent> events_in(std::span<const std::byte> bytes) {
  std::vector<protocol::LogEvent> events;
  protocol::LogFrameReader reader{bytes};
  while (const auto frame = reader.next()) {
    if (frame->head.type == static_cast<std::uint8_t>(protocol::LogRecord::event)) {
      events.push_back(protocol::unpack_event(frame->head.time, frame->payload).value());
    }
  }
  return events;
}

inline std::size_t count(const std::vector<Record>& records, protocol::LogRecord type) {
  return static_cast<std::size_t>(
      std::ranges::count(records, static_cast<std::uint8_t>(type), [](const Record& record) { return record.type; }));
}

}  // namespace fantail::avionics
