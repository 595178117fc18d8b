// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "files/convert.hpp"
#include "log_export/replayed_flight.hpp"

namespace fantail::log_export {

/// An enumeration's value.
struct Word {
  std::uint8_t number = 0;
  std::string_view text;
};

/// Empty: nobody knew it at that tick.
using Value = std::variant<std::monostate, double, std::int64_t, bool, Word>;

enum class FieldType : std::uint8_t { number, integer, flag, word };

/// One column that an export can have.
struct Field {
  std::string name;  ///< as in flight.csv where that has it; with its unit
  FieldType type = FieldType::number;
  std::string_view unit{};  ///< flight::ColumnText
  std::string description{};
  bool replayed = false;  ///< empty where the replay could not come; the others stand in the log itself
};

/// All of them, in a fixed order: the clock, what the log holds of each tick (raw counts by the names of its schema),
/// then every signal of the replayed tick.
[[nodiscard]] std::span<const Field> fields();

[[nodiscard]] std::optional<std::size_t> find_field(std::string_view name);

/// "no field "rol_rate" (did you mean roll_rate_deg_s?); there are: ...".
[[nodiscard]] std::string unknown_field(std::string_view name);

/// Which fields an export shows; indices of fields().
using Selection = std::vector<std::size_t>;

/// Without those of two gyros, where one flew.
[[nodiscard]] Selection every_field(const ReplayedFlight& source);

/// Reads the ticks of a source one at a time.
class TickReader {
 public:
  /// `source` outlives this object.
  explicit TickReader(const ReplayedFlight& source) : source_{source} {}

  /// As many as fields(), until the next call.
  [[nodiscard]] std::span<const Value> read(std::size_t tick);

 private:
  const ReplayedFlight& source_;
  std::vector<Value> values_;
};

/// Calls `take` for each tick within the window of a source, in their order, with its number among the log's ticks, its
/// time, and as many values as fields(), which are there until the next call.
template <typename Take>
void for_each_tick(const ReplayedFlight& source, Take take) {
  TickReader reader{source};
  const auto& ticks = source.flight().ticks;
  for (std::size_t tick = 0; tick < ticks.size(); ++tick) {
    const core::Microseconds time = ticks[tick].tick.time;
    if (source.inside(time)) {
      take(tick, time, reader.read(tick));
    }
  }
}

/// The chosen fields, a value for each tick of the log. The words of a column stand in the order of their enumeration.
[[nodiscard]] files::Columns tick_columns(const ReplayedFlight& source, const Selection& selection);

}  // namespace fantail::log_export
