// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::listen {

/// One figure in a message of a ULog.
struct UlogField {
  std::string name;  ///< "x", or "gyro_rad[2]" of an array
  std::size_t size;  ///< bytes
  double (*read)(const char* bytes);
  std::size_t offset;  ///< from the begin of the message's data
};

/// What lies where in the data of a message.
struct UlogFormat {
  std::vector<UlogField> fields{};  ///< without padding and arrays of more than 16
  std::size_t size = 0;             ///< bytes of all
  std::size_t padding = 0;          ///< of these at the end, which a logger leaves out
  bool whole = true;                ///< false: the rest is other messages, at no known place and of no known size

  [[nodiscard]] bool fits(std::size_t bytes) const { return !whole || bytes == size || bytes == size - padding; }
};

/// Of "uint64_t timestamp;float[3] gyro_rad;".
[[nodiscard]] UlogFormat ulog_format(std::string_view format);

}  // namespace fantail::listen
