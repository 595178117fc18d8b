// SPDX-License-Identifier: MIT
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include <fmt/core.h>

#include "flight_log/flight_log.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"

namespace fantail::flight_log {
namespace {

using text::Error;
using text::ErrorKind;

std::filesystem::path file_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    return path;
  }
  if (std::filesystem::path file = path / "flight.ftl"; std::filesystem::exists(file, ignored)) {
    return file;
  }
  std::vector<std::filesystem::path> logs;  // as a download leaves them: flight_001.ftl
  for (const auto& entry : std::filesystem::directory_iterator{path, ignored}) {
    if (entry.path().extension() == ".ftl") {
      logs.push_back(entry.path());
    }
  }
  if (logs.size() != 1) {
    throw Error{ErrorKind::no_such_input,
                path.string() + (logs.empty() ? ": this folder contains no flight log (.ftl)"
                                              : ": this folder contains several flight logs (.ftl); name one of them")};
  }
  return logs.front();
}

}  // namespace

LogFile read_log_file(const std::filesystem::path& path) {
  const std::filesystem::path file = file_of(path);
  const text::InputBytes content = text::read_input_bytes(file);
  const std::span<const std::byte> bytes{content.bytes.get(), content.size};
  LogFile log = parse_log(bytes, file.string());
  if (log.flights.empty()) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{}: contains no record of a flight; it is {}", file.string(), looks_like(bytes))};
  }
  return log;
}

}  // namespace fantail::flight_log
