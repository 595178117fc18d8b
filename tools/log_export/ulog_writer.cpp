// SPDX-License-Identifier: MIT
#include "log_export/ulog_writer.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace fantail::log_export {
namespace {

UlogBytes keyed(std::string_view key) {
  UlogBytes bytes;
  key = key.substr(0, 255);
  bytes << static_cast<std::uint8_t>(key.size()) << key;
  return bytes;
}

}  // namespace

UlogWriter::UlogWriter(std::uint64_t start_us) {
  UlogBytes head;
  constexpr std::uint8_t version = 1;
  head << std::string_view{"ULog\x01\x12\x35"} << version << start_us;
  out_ = head.str();
  // Which optional parts of the format are used: none.
  message('B', std::string(40, '\0'));
}

void UlogWriter::message(char type, std::string_view content) {
  UlogBytes head;
  head << static_cast<std::uint16_t>(content.size()) << type;
  out_ += head.str();
  out_ += content;
}

void UlogWriter::format(std::string_view text) { message('F', text); }

void UlogWriter::information(std::string_view key, std::string_view text) {
  message('I', (keyed(fmt::format("char[{}] {}", text.size(), key)) << text).str());
}

void UlogWriter::information(std::string_view key, std::uint32_t number) {
  message('I', (keyed(fmt::format("uint32_t {}", key)) << number).str());
}

void UlogWriter::multi_information(std::string_view key, std::string_view text) {
  constexpr char begins_anew = 0;
  message('M', begins_anew + (keyed(fmt::format("char[{}] {}", text.size(), key)) << text).str());
}

void UlogWriter::parameter(std::string_view key, float value) {
  message('P', (keyed(fmt::format("float {}", key)) << value).str());
}

void UlogWriter::parameter(std::string_view key, std::int32_t value) {
  message('P', (keyed(fmt::format("int32_t {}", key)) << value).str());
}

void UlogWriter::subscribe(std::uint16_t topic, std::string_view format_name) {
  UlogBytes bytes;
  constexpr std::uint8_t instance = 0;
  bytes << instance << topic << format_name;
  message('A', bytes.str());
}

void UlogWriter::data(std::uint16_t topic, const UlogBytes& fields) {
  UlogBytes head;
  head << static_cast<std::uint16_t>(fields.str().size() + sizeof topic) << 'D' << topic;
  out_ += head.str();
  out_ += fields.str();
}

void UlogWriter::text(UlogLevel level, std::uint64_t time_us, std::string_view message_text) {
  UlogBytes bytes;
  bytes << static_cast<char>(level) << time_us << message_text;
  message('L', bytes.str());
}

void UlogWriter::dropout(std::uint64_t milliseconds) {
  UlogBytes bytes;
  bytes << static_cast<std::uint16_t>(std::min<std::uint64_t>(milliseconds, UINT16_MAX));
  message('O', bytes.str());
}

}  // namespace fantail::log_export
