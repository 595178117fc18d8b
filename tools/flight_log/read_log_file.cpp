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

using namespace std::string_view_literals;

struct Beginning {
  std::string_view bytes;
  std::string_view name;
};
constexpr std::array beginnings{
    Beginning{"ULog\x01\x12\x35"sv, "a ULog file, which is what `fantail log export --to ulog` writes and others read"},
    Beginning{"\xED\xA1\xDA\x01"sv, "an LCM log, which lcm-logplayer plays back"},
    Beginning{"FTPL"sv, "a flight plan as a board is loaded with it"},
    Beginning{"\x7F"
              "ELF"sv,
              "a program (ELF)"},
    Beginning{"\xA3\x95"sv, "an ArduPilot log"},
    Beginning{"\x1F\x8B"sv, "a file compressed with gzip"},
    Beginning{"PK\x03\x04"sv, "a ZIP archive"},
    Beginning{"\x28\xB5\x2F\xFD"sv, "a file compressed with zstd"},
    Beginning{"\x89PNG"sv, "a picture (PNG)"},
    Beginning{"%PDF"sv, "a PDF"},
};

std::string_view view(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // NOLINT: bytes seen as the text they may be
}

bool is_text(std::string_view text) {
  return std::ranges::none_of(text, [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20 && c != '\n' && c != '\r' && c != '\t') || code == 0x7F;
  });
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "(1436509052.249713) vcan0 044#2A366C2BBA" or, as candump shows it, "  vcan0  044   [5]  2A 36 6C 2B BA".
bool is_candump(std::string_view line) {
  if (line.starts_with('(') && line.size() > 1 && is_digit(line[1])) {
    return line.find('#') != std::string_view::npos;
  }
  const std::size_t bracket = line.find("  [");
  return line.starts_with("  ") && bracket != std::string_view::npos && line.find(']', bracket) == bracket + 4;
}

std::string kind_of_text(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of("\r\n"), text.size());
  const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  const char first =
      text.find_first_not_of(" \t\r\n") == std::string_view::npos ? '\0' : text[text.find_first_not_of(" \t\r\n")];
  if (is_candump(line)) {
    return "a candump log";
  }
  if (first == '{') {
    return "JSON";
  }
  if (first == '<') {
    return "HTML or XML";
  }
  if (std::ranges::count(line, ',') >= 2) {
    return "a CSV file, which compare, identify and tunnel read";
  }
  return "text";
}

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

std::string looks_like(std::span<const std::byte> bytes) {
  if (bytes.empty()) {
    return "an empty file";
  }
  for (const Beginning& beginning : beginnings) {
    if (view(bytes).starts_with(beginning.bytes)) {
      return std::string{beginning.name};
    }
  }
  const auto all = [bytes](unsigned value) {
    return std::ranges::all_of(bytes, [value](std::byte b) { return b == static_cast<std::byte>(value); });
  };
  if (all(0xFF)) {
    return "erased flash, in which nothing was ever recorded";
  }
  if (all(0)) {
    return "only zeros";
  }
  constexpr std::size_t enough = 4096;
  const std::string_view text = view(bytes.first(std::min(bytes.size(), enough)));
  return is_text(text) ? kind_of_text(text) : "data of another kind, or damaged throughout";
}

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
