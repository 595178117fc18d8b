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

/// The figures of a format, "uint64_t timestamp;float[3] gyro_rad;", up to the first field that is another message:
/// what lies behind that is at no known place. Without padding and arrays of more than 16.
[[nodiscard]] std::vector<UlogField> ulog_fields(std::string_view format);

}  // namespace fantail::listen
