// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "flight_log/flight_log.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "protocol/log_header.hpp"
#include "text/quoting.hpp"

namespace fantail::flight_log {
namespace {

using namespace std::string_view_literals;

struct Beginning {
  std::string_view bytes;
  std::string_view name;
};
constexpr std::array beginnings{
    Beginning{"ULog\x01\x12\x35"sv, "a ULog file, which `fantail log export --to ulog` writes and other programs read"},
    Beginning{"MATLAB 5.0 MAT-file"sv, "a MAT-file, which compare, identify and tunnel read"},
    Beginning{"PAR1"sv, "a Parquet file, which compare, identify and tunnel read"},
    Beginning{"\x89MCAP0\r\n"sv, "an MCAP file, which `fantail log export --to mcap` writes and other programs read"},
    Beginning{"\xED\xA1\xDA\x01"sv, "an LCM log, which lcm-logplayer plays back"},
    Beginning{"FTPL"sv, "a flight plan in the format of the board"},
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

std::string or_unknown(std::string_view text) { return text.empty() ? "not known" : text::printable(text); }

// What the readable part of a header says; its checksum lies behind the cut.
std::string header_words(std::span<const std::byte> there, std::size_t whole) {
  if (there.size() < protocol::log_header_fixed_size) {
    return "it is too short to read its header";
  }
  std::vector<std::byte> filled{there.begin(), there.end()};
  filled.resize(
      std::max(whole, there.size()));  // decode_log_header() asks for the plan block that the header announces
  const auto header = protocol::decode_log_header(filled);
  if (!header) {
    return "its header cannot be read";
  }
  return fmt::format("its header (not checked) gives log format {}, firmware {}, vehicle {}, power-up {}",
                     header->format_version, or_unknown(header->firmware_version), or_unknown(header->vehicle),
                     header->power_up);
}

// Empty for what does not begin as a log does.
std::string beginning_of_a_log(std::span<const std::byte> bytes) {
  if (bytes.front() != protocol::log_sync) {
    return {};
  }
  if (bytes.size() < protocol::log_head_size) {
    return fmt::format("cut off in its first record: {} {}, possibly not a flight log", bytes.size(),
                       bytes.size() == 1 ? "byte" : "bytes");
  }
  const auto type = static_cast<std::uint8_t>(bytes[1]);
  const auto length = static_cast<std::size_t>(protocol::get<2>(bytes, 2));
  if (type != static_cast<std::uint8_t>(protocol::LogRecord::header) || length > protocol::largest_log_payload) {
    return {};
  }
  const std::size_t whole = protocol::log_frame_overhead + length;
  const auto payload = bytes.subspan(protocol::log_head_size);
  if (bytes.size() >= whole) {
    return fmt::format("a flight log of {} bytes in which no record is intact", bytes.size());
  }
  return fmt::format("a flight log that is cut off in its first record, after {} of {} bytes; {}", bytes.size(), whole,
                     header_words(payload.first(std::min(payload.size(), length)), length));
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
  if (std::string beginning = beginning_of_a_log(bytes); !beginning.empty()) {
    return beginning;
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

}  // namespace fantail::flight_log
