// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "protocol/log_notes.hpp"

namespace fantail::log_export {

/// Something that a person should look at; other events are news.
[[nodiscard]] inline bool is_warning(const protocol::LogEvent& event) {
  switch (event.kind) {
    case protocol::LogEventKind::records_dropped: return true;
    case protocol::LogEventKind::canard_verdict:
    case protocol::LogEventKind::gyro_state:
    case protocol::LogEventKind::accelerometer_state: return event.value != 0;
    default: return false;
  }
}

/// Numbers as ULog has them: little-endian.
class UlogBytes {
 public:
  template <typename T>
    requires std::is_arithmetic_v<T>
  UlogBytes& operator<<(T value) {
    static_assert(std::endian::native == std::endian::little, "bytes are copied as they lie in memory");
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  UlogBytes& operator<<(std::string_view text) {
    bytes_.append(text);
    return *this;
  }
  [[nodiscard]] const std::string& str() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  std::string bytes_;
};

enum class UlogLevel : char { warning = '4', info = '6' };

/// A ULog file, version 1 (PX4's format), in the order of its sections: formats, information and parameters first, then
/// subscriptions, then data in order of time.
class UlogWriter {
 public:
  explicit UlogWriter(std::uint64_t start_us);

  /// "name:uint64_t timestamp;float x;".
  void format(std::string_view text);
  void information(std::string_view key, std::string_view text);
  void information(std::string_view key, std::uint32_t number);
  /// One of many under the same key.
  void multi_information(std::string_view key, std::string_view text);
  void parameter(std::string_view key, float value);
  void parameter(std::string_view key, std::int32_t value);

  void subscribe(std::uint16_t topic, std::string_view format_name);
  /// `fields` begin with the timestamp.
  void data(std::uint16_t topic, const UlogBytes& fields);
  void text(UlogLevel level, std::uint64_t time_us, std::string_view message);
  /// Something is missing here; longer than 65.535 s counts as that.
  void dropout(std::uint64_t milliseconds);

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  void message(char type, std::string_view content);

  std::string out_;
};

}  // namespace fantail::log_export
