// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "flight/column_texts.hpp"
#include "flight_log/event_text.hpp"
#include "log_export/about.hpp"
#include "log_export/event_level.hpp"
#include "log_export/formats.hpp"
#include "log_export/json_element.hpp"
#include "log_export/mcap_writer.hpp"

namespace fantail::log_export {
namespace {

using Json = json::Value;

std::string_view type_name(FieldType type) {
  switch (type) {
    case FieldType::number: return "number";
    case FieldType::integer: return "integer";
    case FieldType::flag: return "boolean";
    case FieldType::word: break;
  }
  return "string";
}

// Units go with the description: JSON Schema has no place for them.
Json property(std::string_view type, std::string_view unit, std::string_view description) {
  return {{"type", type}, {"description", fmt::format("[{}] {}", unit, description)}};
}

std::string schema(std::string_view title, Json properties) {
  return Json{{"title", title}, {"type", "object"}, {"properties", std::move(properties)}}.dump();
}

std::string health_schema() {
  Json properties{{"verdicts", {{"type", "array"}, {"items", {{"type", "string"}}}}}};
  for (const std::string_view name : {"gyro_state", "accelerometer_state", "bus_state", "longest_tick_us",
                                      "longest_queue", "ticks_dropped", "unsent", "bus_errors"}) {
    const flight::ColumnText text = flight::column_text(name).value_or(flight::ColumnText{});
    const bool is_word = name == "gyro_state" || name == "accelerometer_state";
    properties[name] = property(is_word            ? "string"
                                : name == "time_s" ? "number"
                                                   : "integer",
                                text.unit, text.description);
  }
  return schema("fantail.Health", std::move(properties));
}

// As Foxglove defines it, so that its log panel shows the events.
std::string log_schema() {
  const Json whole{{"type", "integer"}};
  const Json text{{"type", "string"}};
  return schema(
      "foxglove.Log",
      {{"timestamp", {{"type", "object"}, {"title", "time"}, {"properties", {{"sec", whole}, {"nsec", whole}}}}},
       {"level", whole},
       {"message", text},
       {"name", text},
       {"file", text},
       {"line", whole}});
}

class McapFile {
 public:
  McapFile(const ReplayedFlight& source, const Selection& selection)
      : source_{source}, about_{about(source, selection)} {
    std::array<Json, 2> properties;
    for (const std::size_t i : selection) {
      const Field& field = fields()[i];
      chosen_[field.replayed ? 1 : 0].push_back(i);
      properties[field.replayed ? 1 : 0][field.name] = property(type_name(field.type), field.unit, field.description);
    }
    constexpr std::array<std::string_view, 2> topics{"/fantail/recorded", "/fantail/replayed"};
    constexpr std::array<std::string_view, 2> schemas{"fantail.Recorded", "fantail.Replayed"};
    for (std::size_t i = 0; i < topics.size(); ++i) {
      if (!chosen_[i].empty()) {
        ticks_[i] = writer_.topic(topics[i], schemas[i], schema(schemas[i], properties[i]));
      }
    }
    health_ = writer_.topic("/fantail/health", "fantail.Health", health_schema());
    events_ = writer_.topic("/fantail/events", "foxglove.Log", log_schema());
  }

  std::string write() {
    metadata();
    for_each_tick(source_, [this](std::size_t, core::Microseconds time, std::span<const Value> values) {
      notes_until(time);
      tick(0, time, values);
      tick(1, time, values);
    });
    notes_until(core::Microseconds::max());
    return writer_.take();
  }

 private:
  void metadata() {
    std::map<std::string, std::string> texts;
    for (const json::Member& member : about_.members()) {
      if (member.key != "columns" && member.key != "events" && member.key != "health") {
        texts[member.key] = member.value.is_text() ? member.value.text() : member.value.dump();
      }
    }
    writer_.metadata("fantail", texts);
  }

  // What is unknown is not in the message; where nothing is known, there is none. Of a tick to which no replay leads
  // the commands of the canards are known, for those stand in the log.
  void tick(std::size_t topic, core::Microseconds time, std::span<const Value> values) {
    buffer_.clear();
    for (const std::size_t i : chosen_[topic]) {
      if (!std::holds_alternative<std::monostate>(values[i])) {
        fmt::format_to(std::back_inserter(buffer_), "{}\"{}\":", buffer_.size() == 0 ? '{' : ',', fields()[i].name);
        std::visit(JsonElement{buffer_}, values[i]);
      }
    }
    if (buffer_.size() > 0) {
      buffer_.push_back('}');
      writer_.message(ticks_[topic], time, {buffer_.data(), buffer_.size()});
    }
  }

  // Everything that is not a tick and comes before or with one.
  void notes_until(core::Microseconds until) {
    const flight_log::Flight& flight = source_.flight();
    while (true) {
      const auto gap = next_gap_ < flight.gaps.size() ? flight.gaps[next_gap_].after : never;
      const auto event = next_event_ < flight.events.size() ? flight.events[next_event_].time : never;
      const auto health = next_health_ < flight.health.size() ? flight.health[next_health_].time : never;
      const core::Microseconds next = std::min({gap, event, health});
      if (next > until || next == never) {
        return;
      }
      if (next == gap) {
        text(next, true, fmt::format("{} records are missing before this", flight.gaps[next_gap_++].count));
      } else if (next == event) {
        const protocol::LogEvent& there = flight.events[next_event_++];
        text(next, is_warning(there), flight_log::event_text(there, flight.first_time));
      } else {
        ++next_health_;
        if (source_.inside(next)) {
          writer_.message(health_, next, about_["health"][health_written_++].dump());
        }
      }
    }
  }

  void text(core::Microseconds time, bool is_warning, const std::string& message) {
    if (!source_.inside(time)) {
      return;
    }
    constexpr std::int64_t second_us = 1'000'000;
    constexpr int info = 2;  // of foxglove.Log
    constexpr int warning = 3;
    writer_.message(events_, time,
                    Json{{"timestamp", {{"sec", time.count() / second_us}, {"nsec", time.count() % second_us * 1000}}},
                         {"level", is_warning ? warning : info},
                         {"message", message},
                         {"name", "fantail"},
                         {"file", ""},
                         {"line", 0}}
                        .dump());
  }

  static constexpr core::Microseconds never = core::Microseconds::max();

  const ReplayedFlight& source_;
  const Json about_;
  McapWriter writer_;
  std::array<Selection, 2> chosen_{};  ///< recorded and replayed
  std::array<std::uint16_t, 2> ticks_{};
  std::uint16_t health_ = 0;
  std::uint16_t events_ = 0;
  fmt::memory_buffer buffer_;
  std::size_t next_gap_ = 0;
  std::size_t next_event_ = 0;
  std::size_t next_health_ = 0;
  std::size_t health_written_ = 0;
};

}  // namespace

std::string mcap(const ReplayedFlight& source, const Selection& selection) {
  return McapFile{source, selection}.write();
}

}  // namespace fantail::log_export
