// SPDX-License-Identifier: MIT
#include "flight_log/foreign.hpp"

#include <algorithm>
#include <array>
#include <string_view>

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
    Beginning{"\xA3\x95"sv, "a log of ArduPilot"},
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
    return "what candump wrote";
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
    return "nothing but zeros";
  }
  constexpr std::size_t enough = 4096;
  const std::string_view text = view(bytes.first(std::min(bytes.size(), enough)));
  return is_text(text) ? kind_of_text(text) : "data of another kind, or damaged throughout";
}

}  // namespace fantail::flight_log
