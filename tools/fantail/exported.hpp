// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "flight_log/flight_log.hpp"
#include "log_export/replayed_flight.hpp"

namespace fantail::tool {

struct ExportFormat {
  std::string_view name;
  std::string_view ending;
  bool has_fields;
};
inline constexpr std::array<ExportFormat, 5> export_formats{{{"csv", ".csv", true},
                                                             {"ulog", ".ulg", true},
                                                             {"lcm", ".lcmlog", false},
                                                             {"candump", ".log", false},
                                                             {"json", ".json", true}}};

/// What a person wants of a log.
struct ExportQuestion {
  std::string log;  ///< its file, for messages
  const ExportFormat* format = nullptr;
  std::vector<std::string> fields{};  ///< empty: those that the format has by itself
  log_export::Window window{};
};

struct Exported {
  std::string bytes;
  std::vector<std::string> notes;  ///< what the log has lost, a sentence each
};

/// Throws UsageError for fields that there are not, text::Error for a log that does not have what is
/// wanted.
[[nodiscard]] Exported export_flight(const ExportQuestion& question, const flight_log::Flight& flight);

}  // namespace fantail::tool
