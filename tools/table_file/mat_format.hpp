// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fantail::table_file::mat {

/// How an element of a file is stored.
enum class Stored : std::uint32_t {
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  float32 = 7,
  float64 = 9,
  int64 = 12,
  uint64 = 13,
  matrix = 14,
  compressed = 15,
  utf8 = 16,
  utf16 = 17,
};

/// What an array is for MATLAB. From float64 to uint64 they are numbers.
enum class Class : std::uint8_t { cell = 1, structure = 2, text = 4, sparse = 5, float64 = 6, uint64 = 15 };

inline constexpr std::uint32_t complex_flag = 0x0800;
inline constexpr std::string_view beginning = "MATLAB 5.0 MAT-file";
inline constexpr std::size_t header_size = 128;
inline constexpr std::uint16_t version = 0x0100;
inline constexpr std::uint16_t byte_order = 0x4D49;  // "IM" where the file is little-endian

[[nodiscard]] constexpr std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }

}  // namespace fantail::table_file::mat
