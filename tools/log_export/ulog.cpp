// SPDX-License-Identifier: MIT
#include <array>
#include <limits>

#include <fmt/core.h>

#include "core/flight_plan_fields.hpp"
#include "flight/columns.hpp"
#include "flight_log/event_text.hpp"
#include "log_export/formats.hpp"
#include "log_export/ulog_writer.hpp"

namespace fantail::log_export {
namespace {

enum Topic : std::uint8_t { recorded, replayed, health };
constexpr std::array<std::string_view, 2> names{"fantail_recorded", "fantail_replayed"};

constexpr std::string_view health_format =
    "fantail_health:uint64_t timestamp;uint32_t ticks_dropped;uint32_t unsent;uint32_t bus_errors;"
    "uint16_t longest_tick_us;uint16_t longest_queue;uint8_t bus_state;uint8_t gyro_state;"
    "uint8_t accelerometer_state;uint8_t verdict_1;uint8_t verdict_2;uint8_t verdict_3;uint8_t verdict_4;";

std::uint64_t us(core::Microseconds time) { return static_cast<std::uint64_t>(time.count()); }

// Counts fit 32 bits; sequence and digest are unsigned and need them all; times are as long as they are.
enum class Number : std::uint8_t { float32, float64, int32, int64, uint32, uint8 };

Number number_of(const Field& field) {
  switch (field.type) {
    case FieldType::flag:
    case FieldType::word: return Number::uint8;
    case FieldType::number: return field.name == "time_s" ? Number::float64 : Number::float32;
    case FieldType::integer: break;
  }
  return field.name.ends_with("_us") ? Number::int64 : field.name.ends_with("_count") ? Number::int32 : Number::uint32;
}

std::string_view type_name(Number number) {
  switch (number) {
    case Number::float32: return "float";
    case Number::float64: return "double";
    case Number::int32: return "int32_t";
    case Number::int64: return "int64_t";
    case Number::uint32: return "uint32_t";
    case Number::uint8: break;
  }
  return "uint8_t";
}

struct Put {
  UlogBytes& out;
  Number number;

  void operator()(std::monostate) const { (*this)(std::numeric_limits<double>::quiet_NaN()); }
  void operator()(double value) const {
    if (number == Number::float64) {
      out << value;
    } else {
      out << static_cast<float>(value);
    }
  }
  void operator()(std::int64_t value) const {
    switch (number) {
      case Number::int32: out << static_cast<std::int32_t>(value); break;
      case Number::uint32: out << static_cast<std::uint32_t>(value); break;
      default: out << value;
    }
  }
  void operator()(bool value) const { out << static_cast<std::uint8_t>(value ? 1 : 0); }
  void operator()(const Word& word) const { out << word.number; }
};

class File {
 public:
  File(const ReplayedFlight& source, const Selection& selection)
      : source_{source}, writer_{source.flight().ticks.empty() ? 0 : us(source.flight().ticks.front().tick.time)} {
    for (const std::size_t field : selection) {
      topics_[fields()[field].replayed ? replayed : recorded].push_back(field);
    }
  }

  std::string write() {
    for (const Topic topic : {recorded, replayed}) {
      if (!topics_[topic].empty()) {
        writer_.format(format(names[topic], topics_[topic]));
      }
    }
    writer_.format(health_format);
    information();
    units();
    parameters();
    for (const Topic topic : {recorded, replayed}) {
      if (!topics_[topic].empty()) {
        writer_.subscribe(topic, names[topic]);
      }
    }
    writer_.subscribe(health, "fantail_health");
    for_each_tick(source_, [this](std::size_t i, core::Microseconds time, std::span<const Value> values) {
      notes_until(time);
      tick(recorded, time, values);
      if (source_.record(i) != nullptr) {
        tick(replayed, time, values);
      }
    });
    notes_until(core::Microseconds::max());
    return writer_.take();
  }

 private:
  static std::string format(std::string_view name, const Selection& topic) {
    std::string text = fmt::format("{}:uint64_t timestamp;", name);
    for (const std::size_t field : topic) {
      text += fmt::format("{} {};", type_name(number_of(fields()[field])), fields()[field].name);
    }
    return text;
  }

  void information() {
    const flight_log::Flight& flight = source_.flight();
    writer_.information("sys_name", "Fantail");
    writer_.information("ver_sw", flight.firmware_version);
    writer_.information("git_hash", flight.git_hash);
    writer_.information("vehicle", flight.vehicle);
    writer_.information("sensors", flight.sensors);
    writer_.information("flight", flight.flight);
    writer_.information("power_up", flight.power_up);
  }

  // ULog knows no units. Readers that do not look for these skip them.
  void units() {
    for (const Topic topic : {recorded, replayed}) {
      for (const std::size_t i : topics_[topic]) {
        const Field& field = fields()[i];
        describe(names[topic], field.name, field.unit, field.description);
      }
    }
    std::string_view rest = health_format.substr(health_format.find(';') + 1);  // behind the timestamp
    for (std::size_t end = rest.find(';'); end != std::string_view::npos; end = rest.find(';')) {
      const std::string_view name = rest.substr(0, end).substr(rest.find(' ') + 1);
      const flight::ColumnText text = flight::column_text(name).value_or(flight::ColumnText{});
      describe("fantail_health", name, text.unit, text.description);
      rest.remove_prefix(end + 1);
    }
  }

  void describe(std::string_view topic, std::string_view name, std::string_view unit, std::string_view description) {
    writer_.multi_information(topic, fmt::format("{} [{}] {}", name, unit, description));
  }

  void parameters() {
    if (!source_.flight().plan) {
      return;
    }
    const core::FlightPlan& plan = *source_.flight().plan;
    for (const core::PlanField& field : core::flight_plan_fields()) {
      for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
        const bool single = field.slots == 1 && !field.is_list();
        const std::string key =
            fmt::format("{}.{}{}", field.section, field.key, single ? "" : fmt::format(".{}", slot + 1));
        if (field.kind == core::FieldKind::number) {
          writer_.parameter(key, field.get(plan, slot));
        } else {
          writer_.parameter(key, static_cast<std::int32_t>(field.get(plan, slot)));
        }
      }
    }
  }

  void tick(Topic topic, core::Microseconds time, std::span<const Value> values) {
    if (topics_[topic].empty()) {
      return;
    }
    bytes_.clear();
    bytes_ << us(time);
    for (const std::size_t field : topics_[topic]) {
      std::visit(Put{bytes_, number_of(fields()[field])}, values[field]);
    }
    writer_.data(topic, bytes_);
  }

  // Everything that is not a tick and comes before or with one.
  void notes_until(core::Microseconds until) {
    const flight_log::Flight& flight = source_.flight();
    for (; next_gap_ < flight.gaps.size() && flight.gaps[next_gap_].after <= until; ++next_gap_) {
      const flight_log::Gap& gap = flight.gaps[next_gap_];
      if (gap.after > gap.before && source_.inside(gap.after)) {
        writer_.dropout(us(gap.after - gap.before) / 1000);
      }
    }
    for (; next_event_ < flight.events.size() && flight.events[next_event_].time <= until; ++next_event_) {
      const protocol::LogEvent& event = flight.events[next_event_];
      if (source_.inside(event.time)) {
        writer_.text(is_warning(event) ? UlogLevel::warning : UlogLevel::info, us(event.time),
                     flight_log::event_text(event, flight.first_time));
      }
    }
    for (; next_health_ < flight.health.size() && flight.health[next_health_].time <= until; ++next_health_) {
      if (source_.inside(flight.health[next_health_].time)) {
        put(flight.health[next_health_]);
      }
    }
  }

  void put(const protocol::LogHealth& record) {
    bytes_.clear();
    bytes_ << us(record.time) << record.ticks_dropped << record.unsent << record.bus_errors << record.longest_tick_us
           << record.longest_queue << record.bus_state << static_cast<std::uint8_t>(record.gyro)
           << static_cast<std::uint8_t>(record.accelerometer);
    for (const core::CanardVerdict verdict : record.verdicts) {
      bytes_ << static_cast<std::uint8_t>(verdict);
    }
    writer_.data(health, bytes_);
  }

  const ReplayedFlight& source_;
  UlogWriter writer_;
  std::array<Selection, 2> topics_{};
  UlogBytes bytes_;
  std::size_t next_gap_ = 0;
  std::size_t next_event_ = 0;
  std::size_t next_health_ = 0;
};

}  // namespace

std::string ulog(const ReplayedFlight& source, const Selection& selection) { return File{source, selection}.write(); }

}  // namespace fantail::log_export
