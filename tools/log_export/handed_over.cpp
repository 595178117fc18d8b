// SPDX-License-Identifier: MIT
// A flight as python/fantail/files/_export.py takes it: a line of JSON, then the board's clock and every chosen field
// as float64, one column behind the other. Not a number: unknown. Flags are 0 and 1, words places in a list.
#include <array>
#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "files/convert.hpp"
#include "flight/columns.hpp"
#include "flight_log/event_text.hpp"
#include "log_export/about.hpp"
#include "log_export/fields.hpp"
#include "log_export/formats.hpp"
#include "log_export/ulog_writer.hpp"
#include "text/number.hpp"

namespace fantail::log_export {
namespace {

using Json = json::Value;

static_assert(std::endian::native == std::endian::little, "numbers are handed over as they lie in memory");

std::string_view type_name(files::Kind kind) {
  switch (kind) {
    case files::Kind::number: return "number";
    case files::Kind::integer: return "integer";
    case files::Kind::flag: return "flag";
    case files::Kind::word: break;
  }
  return "word";
}

Json described(const files::Columns& columns, const Selection& selection) {
  Json all = Json::array();
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const Field& field = fields()[selection[i]];
    all.push_back({{"name", field.name},
                   {"type", type_name(columns[i].kind)},
                   {"unit", field.unit},
                   {"description", field.description},
                   {"replayed", field.replayed},
                   {"words", columns[i].words}});
  }
  return all;
}

Json health_fields() {
  Json all = Json::array();
  for (const std::string_view name : {"gyro_state", "accelerometer_state", "bus_state", "longest_tick_us",
                                      "longest_queue", "ticks_dropped", "unsent", "bus_errors"}) {
    const flight::ColumnText text = flight::column_text(name).value_or(flight::ColumnText{});
    const bool is_word = name == "gyro_state" || name == "accelerometer_state";
    all.push_back({{"name", name},
                   {"type", is_word ? "string" : "integer"},
                   {"unit", text.unit},
                   {"description", text.description}});
  }
  return all;
}

// Of what `about` says of a time in seconds, the board's own time. Events and gaps as sentences, with whether somebody
// should look at them.
void add_times(Json& head, const ReplayedFlight& source) {
  const flight_log::Flight& flight = source.flight();
  Json health = Json::array();
  Json log = Json::array();
  const auto say = [&](core::Microseconds time, bool is_warning, const std::string& text) {
    if (source.inside(time)) {
      log.push_back(Json::array({time.count(), is_warning, text}));
    }
  };
  for (const protocol::LogHealth& record : flight.health) {
    if (source.inside(record.time)) {
      health.push_back(record.time.count());
    }
  }
  for (const flight_log::Gap& gap : flight.gaps) {
    say(gap.after, true, text::counted(gap.count, "record is", "records are") + " missing before this");
  }
  for (const protocol::LogEvent& event : flight.events) {
    say(event.time, is_warning(event), flight_log::event_text(event, flight.first_time));
  }
  head["health_us"] = std::move(health);
  head["log"] = std::move(log);
}

std::string handed_over(const ReplayedFlight& source, const Selection& selection) {
  const files::Columns columns = tick_columns(source, selection);
  std::vector<double> times_us;
  for_each_tick(source, [&](std::size_t, core::Microseconds time, std::span<const Value>) {
    times_us.push_back(static_cast<double>(time.count()));
  });
  Json head{{"about", about(source, selection)},
            {"rows", times_us.size()},
            {"fields", described(columns, selection)},
            {"health_fields", health_fields()}};
  add_times(head, source);
  std::string all = head.dump() + '\n';
  const auto put = [&all](const std::vector<double>& values) {
    all.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  };
  put(times_us);
  for (const files::Column& column : columns) {
    put(column.values);
  }
  return all;
}

}  // namespace

std::string json(const ReplayedFlight& source, const Selection& selection) {
  return files::exported(handed_over(source, selection), "json");
}

std::string parquet(const ReplayedFlight& source, const Selection& selection) {
  return files::exported(handed_over(source, selection), "parquet");
}

std::string mcap(const ReplayedFlight& source, const Selection& selection) {
  return files::exported(handed_over(source, selection), "mcap");
}

}  // namespace fantail::log_export
