// SPDX-License-Identifier: MIT
#include "flight_log/regenerate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "avionics/log_tick_of.hpp"
#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "core/tick_record.hpp"
#include "flight_log/schema.hpp"
#include "input/plan_file.hpp"
#include "protocol/log_schema.hpp"
#include "protocol/state_block.hpp"
#include "text/error.hpp"

namespace fantail::flight_log {
namespace {

// Only the bytes matter here; ages that say "as before" are the same on both sides.
std::array<std::byte, protocol::largest_log_tick> packed(const protocol::LogTick& tick) {
  protocol::SampleTimes not_needed;
  std::array<std::byte, protocol::largest_log_tick> bytes{};
  protocol::pack(tick, not_needed, bytes);
  return bytes;
}

std::string text(const SchemaField& field, double value) {
  if (field.name == "phase" && value < static_cast<double>(core::phases)) {
    return std::string{core::name(static_cast<core::Phase>(value))};
  }
  if (field.name == "command_status" && value < static_cast<double>(core::command_statuses)) {
    return std::string{core::name(static_cast<core::CommandStatus>(value))};
  }
  if (field.unit == "mdeg") {
    return value == -32768.0 ? "not driven" : fmt::format("{:.3f} deg", value / 1000.0);
  }
  if (field.name == "digest") {
    return fmt::format("{:08x}", static_cast<std::uint32_t>(value));
  }
  if (field.type == FieldType::real_number) {
    return fmt::format("{:.9g} {}", value, field.unit);  // nine digits tell any two floats apart
  }
  return fmt::format("{:g}{}{}", value, field.unit.empty() ? "" : " ", field.unit);
}

std::string obstacle_before(const Flight& flight, const core::FlightPlan& plan) {
  if (!flight.foreign_ticks.empty()) {
    return "Its ticks have the layout of another version of Fantail, whose flight law this program does not have.";
  }
  if (!flight.has_header) {
    return "It has no intact header, so the plan and the scales of the sensor counts are unknown.";
  }
  if (flight.ticks.empty()) {
    return "It contains no tick.";
  }
  if (flight.state_layout != state_layout(plan)) {
    if (flight.plan && flight.plan->sensors.gyros != plan.sensors.gyros) {
      return "The flight law has a different state for two gyros than for one: sensors.gyros cannot be changed in a "
             "replay.";
    }
    if (flight.plan && flight.plan->sensors.barometer != plan.sensors.barometer) {
      return "The flight law has a different state with a barometer than without: sensors.barometer cannot be changed "
             "in a replay.";
    }
    if (flight.plan && flight.state_layout == state_layout(*flight.plan)) {
      return "The flight law has a different state with a gate or capture than without: dormancy.until = \"guide\" and "
             "controller.entry cannot be changed in a replay.";
    }
    return "It was flown with another version of the flight law.";
  }
  return flight.checkpoints.empty() ? "It contains no checkpoint from which a replay could start." : "";
}

// The first value that differs, in the order of the schema.
Difference first_difference(std::size_t tick, const protocol::LogTick& recorded, const protocol::LogTick& replayed) {
  static const std::vector<SchemaRecord> schema = parse_schema(protocol::log_schema());
  const auto a = packed(recorded);
  const auto b = packed(replayed);
  for (const SchemaField& field : find_record(schema, "tick")->fields) {
    const double was = *value(field, a);
    const double is = *value(field, b);
    if (was != is) {
      return {.tick = tick, .field = field.name, .recorded = text(field, was), .replayed = text(field, is)};
    }
    if (field.name == "command" && recorded.command.radians() == 0.0F && a != b) {
      // -0 and 0 are equal numbers and other bytes.
      const bool was_negative = std::signbit(recorded.command.radians());
      if (was_negative != std::signbit(replayed.command.radians())) {
        return {.tick = tick,
                .field = field.name,
                .recorded = was_negative ? "-0 rad" : "0 rad",
                .replayed = was_negative ? "0 rad" : "-0 rad"};
      }
    }
  }
  return {.tick = tick};
}

/// Walks along a flight and knows where the flight law can be followed.
class Replay {
 public:
  Replay(const Flight& flight, const core::FlightPlan& plan) : flight_{flight}, plan_{plan} {}

  /// The law as it was before this tick; null where nothing leads to it.
  core::Autopilot* law_before(std::uint32_t sequence) {
    if (pass_gaps(sequence)) {
      law_.reset();
    }
    for (; checkpoint_ < flight_.checkpoints.size() && flight_.checkpoints[checkpoint_].sequence < sequence;
         ++checkpoint_) {
      const Checkpoint& here = flight_.checkpoints[checkpoint_];
      const bool leads_here = here.sequence > last_missing_ || !anything_missing_;
      const bool after_last_tick = !last_tick_ || here.sequence > *last_tick_;
      if (!law_ && leads_here && after_last_tick) {
        resume(here);
      }
    }
    last_tick_ = sequence;
    return law_ ? &*law_ : nullptr;
  }

  [[nodiscard]] core::Inputs inputs(const protocol::LogTick& tick) const {
    return inputs_of(flight_, tick, plan_.canards);
  }

 private:
  // True when something was lost between the tick before and this one.
  bool pass_gaps(std::uint32_t sequence) {
    bool passed = false;
    const auto& gaps = flight_.gaps;
    for (; gap_ < gaps.size() && gaps[gap_].first_missing < sequence; ++gap_) {
      note_missing(gaps[gap_].first_missing + (gaps[gap_].count - 1));
      passed = true;
    }
    const auto& unknown = flight_.unknown_ticks;
    for (; unknown_ < unknown.size() && unknown[unknown_] < sequence; ++unknown_) {
      note_missing(unknown[unknown_]);
      passed = true;
    }
    return passed;
  }

  void note_missing(std::uint32_t sequence) {
    last_missing_ = std::max(last_missing_, sequence);
    anything_missing_ = true;
  }

  void resume(const Checkpoint& checkpoint) {
    law_.emplace(plan_);
    if (!protocol::restore_state(*law_, checkpoint.state)) {
      law_.reset();
    }
  }

  const Flight& flight_;
  const core::FlightPlan& plan_;
  std::optional<core::Autopilot> law_;
  std::size_t checkpoint_ = 0;
  std::size_t gap_ = 0;
  std::size_t unknown_ = 0;
  std::uint32_t last_missing_ = 0;
  bool anything_missing_ = false;
  std::optional<std::uint32_t> last_tick_;
};

[[noreturn]] void refuse(const std::string& log, const std::string& why) {
  throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: cannot be replayed. {}", log, why)};
}

}  // namespace

core::Inputs inputs_of(const Flight& flight, const protocol::LogTick& tick, const core::CanardsPlan& canards) {
  return avionics::inputs_of(
      tick,
      {.imu = {.rate_rad_s = flight.rate_scale_rad_s, .specific_force_m_s2 = flight.specific_force_scale_m_s2},
       .second_rate_rad_s = flight.second_rate_scale_rad_s.value_or(0.0F),
       .accelerometer_m_s2 = flight.accelerometer_scale_m_s2},
      canards);
}

core::EncoderAngles encoders_of(const Flight& flight, const protocol::LogTick& tick) {
  return flight.plan ? avionics::inputs_of(tick, {}, flight.plan->canards).encoders : core::EncoderAngles{};
}

std::uint32_t state_layout(const core::FlightPlan& plan) {
  core::Autopilot law{plan};
  protocol::StateLayout layout;
  law.visit_state(layout);
  return layout.hash();
}

Regeneration regenerate(const Flight& flight, const core::FlightPlan& plan) {
  Regeneration result;
  result.records.resize(flight.ticks.size());
  result.obstacle = obstacle_before(flight, plan);
  result.unreachable = flight.ticks.size();
  if (!result.obstacle.empty()) {
    return result;
  }
  Replay replay{flight, plan};
  for (std::size_t i = 0; i < flight.ticks.size(); ++i) {
    const protocol::LogTick& tick = flight.ticks[i].tick;
    core::Autopilot* law = replay.law_before(flight.ticks[i].sequence);
    if (law == nullptr) {
      continue;
    }
    const core::Inputs inputs = replay.inputs(tick);
    const core::TickRecord& record = law->step(inputs);
    const protocol::LogTick replayed =
        avionics::log_tick_of(record, avionics::raw_samples_of(tick), inputs, tick.duration_before);
    result.records[i] = record;
    result.compared += 1;
    if (packed(tick) == packed(replayed)) {
      continue;
    }
    result.differing += 1;
    if (!result.first_difference) {
      result.first_difference = first_difference(i, tick, replayed);
    }
  }
  result.unreachable = flight.ticks.size() - result.compared;
  if (result.compared == 0) {
    result.obstacle = "None of its checkpoints fits this program's flight law.";
  }
  return result;
}

core::FlightPlan plan_for_replay(const Flight& flight, const std::string& log,
                                 std::span<const input::Override> changes) {
  if (!flight.plan) {
    refuse(log, flight.has_header ? "Its flight plan cannot be used: " + flight.plan_fault + "."
                                  : "It has no intact header, so there is no flight plan.");
  }
  for (const input::Override& change : changes) {
    const bool turns = change.key.ends_with("_to_nose") || change.key.ends_with("_along_y");
    if (change.section == "sensors" && turns) {
      refuse(log, fmt::format("{} changes nothing in a replay: the values in a log are already in the rocket's axes",
                              change.text()));
    }
  }
  return changes.empty() ? *flight.plan : input::changed_plan(*flight.plan, changes);
}

Regeneration replay(const Flight& flight, const std::string& log, const core::FlightPlan& plan) {
  Regeneration result = regenerate(flight, plan);
  if (!result.obstacle.empty()) {
    refuse(log, result.obstacle);
  }
  return result;
}

}  // namespace fantail::flight_log
