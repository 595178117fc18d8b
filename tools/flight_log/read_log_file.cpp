// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "flight_log/flight_log.hpp"
#include "text/error.hpp"

namespace fantail::flight_log {
namespace {

using text::Error;
using text::ErrorKind;

// What a vector would first fill with zeros, at a third of the time that the whole reading takes.
struct Content {
  std::unique_ptr<std::byte[]> bytes;  // NOLINT(modernize-avoid-c-arrays)
  std::size_t size = 0;
};

Content grown(Content content, std::size_t room) {
  Content larger{.bytes = std::make_unique_for_overwrite<std::byte[]>(room), .size = content.size};  // NOLINT
  std::copy_n(content.bytes.get(), content.size, larger.bytes.get());
  return larger;
}

Content read_all(std::ifstream& stream, std::size_t expected) {
  std::size_t room = std::max(std::min(expected, most_log_bytes) + 1, std::size_t{1} << 16);
  Content content = grown({}, room);
  while (stream && content.size <= most_log_bytes) {
    if (content.size == room) {  // a pipe, or a file that grows
      room = std::min(2 * room, most_log_bytes + 1);
      content = grown(std::move(content), room);
    }
    stream.read(reinterpret_cast<char*>(content.bytes.get() + content.size),  // NOLINT: bytes are what it reads
                static_cast<std::streamsize>(room - content.size));
    content.size += static_cast<std::size_t>(stream.gcount());
  }
  return content;
}

std::filesystem::path file_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    return path;
  }
  std::filesystem::path file = path / "flight.ftl";
  if (!std::filesystem::exists(file, ignored)) {
    throw Error{ErrorKind::no_such_input, path.string() + ": a folder without a flight.ftl"};
  }
  return file;
}

}  // namespace

LogFile read_log_file(const std::filesystem::path& path) {
  const std::filesystem::path file = file_of(path);
  std::ifstream stream{file, std::ios::binary};
  if (!stream) {
    if (errno == ENOENT || errno == ENOTDIR) {
      throw Error{ErrorKind::no_such_input, file.string() + ": no such file"};
    }
    throw std::system_error{errno, std::generic_category(), file.string()};
  }
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(file, no_size);
  const Content content = read_all(stream, no_size ? 0 : static_cast<std::size_t>(size));
  if (stream.bad()) {
    throw std::system_error{errno, std::generic_category(), file.string()};
  }
  if (content.size > most_log_bytes) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{}: larger than {} MiB, which no flight log is", file.string(), most_log_bytes >> 20U)};
  }
  const std::span<const std::byte> bytes{content.bytes.get(), content.size};
  LogFile log = parse_log(bytes, file.string());
  if (log.flights.empty()) {
    throw Error{ErrorKind::bad_data,
                fmt::format("{}: holds no record of a flight; it is {}", file.string(), looks_like(bytes))};
  }
  return log;
}

}  // namespace fantail::flight_log
