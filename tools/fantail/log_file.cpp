// SPDX-License-Identifier: MIT
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "fantail/command_line.hpp"
#include "fantail/log_info.hpp"

namespace fantail::tool {

flight_log::Flight take_flight(flight_log::LogFile& file, const std::optional<std::size_t>& choice) {
  const std::size_t count = file.flights.size();
  if (choice && (*choice < 1 || *choice > count)) {
    throw UsageError{fmt::format("--flight {}: {} holds {}; allowed: 1 to {}", *choice, file.name,
                                 count == 1 ? "one flight" : fmt::format("{} flights", count), count)};
  }
  if (!choice && count > 1) {
    throw UsageError{fmt::format("{} holds {} flights; which one? --flight 1 to {}", file.name, count, count)};
  }
  return std::move(file.flights[choice.value_or(1) - 1]);
}

void add_flight_choice(const Verb& verb, std::optional<std::size_t>& choice, const std::string& without) {
  verb.option("--flight", choice, "Which flight in a file with several, counted from 1" + without)
      .range(1, static_cast<double>(flight_log::most_flights))
      .value_name("N");
}

std::string name_of_log(const std::filesystem::path& path) {
  std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
  if (!whole.has_filename()) {  // it ended in a slash
    whole = whole.parent_path();
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(whole, ignored)) {
    return whole.filename().string();
  }
  const bool stands_for_its_folder = whole.stem() == "flight" && whole.parent_path().has_filename();
  return (stands_for_its_folder ? whole.parent_path().filename() : whole.stem()).string();
}

}  // namespace fantail::tool
