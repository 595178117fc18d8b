// SPDX-License-Identifier: MIT
#include <algorithm>

#include "log_export/formats.hpp"
#include "telemetry/publisher.hpp"
#include "telemetry/sender.hpp"
#include "telemetry/tick_reporter.hpp"

namespace fantail::log_export {
namespace {

// The same every time that this flight is exported.
std::int64_t run_of(const flight_log::Flight& flight) {
  return static_cast<std::int64_t>((std::uint64_t{flight.power_up & 0x7FFFFFFFU} << 32U) | flight.flight);
}

telemetry::Health health_of(const protocol::LogHealth& record, bool timing_fault) {
  const auto bus_state = static_cast<hal::CanState>(std::min<std::uint8_t>(record.bus_state, 4));
  constexpr std::int64_t not_in_a_log = -1;
  return {.gyro = record.gyro,
          .accelerometer = record.accelerometer,
          .verdicts = record.verdicts,
          .timing_fault = timing_fault,
          .longest_tick_s = 1e-6 * record.longest_tick_us,
          .late_ticks = {},
          .bus =
              telemetry::Health::Bus{
                  .state = bus_state, .unsent = record.unsent, .overrun = not_in_a_log, .errors = record.bus_errors},
          .gateway = {}};
}

}  // namespace

std::string lcm(const ReplayedFlight& source) {
  const flight_log::Flight& flight = source.flight();
  telemetry::MemoryLog log;
  telemetry::Sender sender{log, run_of(flight)};
  telemetry::Changes changes;
  changes.begin_with_first_look();  // a log begins when the rocket has long been armed
  const telemetry::Limits limits = flight.plan ? telemetry::limits_of(*flight.plan) : telemetry::Limits{};
  std::size_t next_health = 0;
  const auto send_health = [&](core::Microseconds until, bool timing_fault) {
    for (; next_health < flight.health.size() && flight.health[next_health].time <= until; ++next_health) {
      const protocol::LogHealth& record = flight.health[next_health];
      if (source.inside(record.time)) {
        sender.send(record.time, health_of(record, timing_fault));
      }
    }
  };
  for (std::size_t i = 0; i < flight.ticks.size(); ++i) {
    const core::Microseconds time = flight.ticks[i].tick.time;
    send_health(time, flight.ticks[i].tick.timing_fault);
    const core::TickRecord* record = source.record(i);
    if (record == nullptr || !source.inside(time)) {
      continue;
    }
    changes.look(time, record->phase, record->reason, sender);
    changes.look(time, record->verdicts, sender);
    sender.send(time, telemetry::state_of(*record));
    sender.send(time, telemetry::canards_of(*record, limits));
  }
  send_health(core::Microseconds::max(), !flight.ticks.empty() && flight.ticks.back().tick.timing_fault);
  return log.take();
}

}  // namespace fantail::log_export
