// SPDX-License-Identifier: MIT
#include <cstddef>
#include <filesystem>
#include <span>

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
  std::filesystem::path file = path / "flight.ftl";
  if (!std::filesystem::exists(file, ignored)) {
    throw Error{ErrorKind::no_such_input, path.string() + ": this folder contains no flight.ftl"};
  }
  return file;
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
