// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fantail::board {

/// What is flashed, as the linker and cmake/seal_image.py left it: the bytes at their addresses in the flash of the
/// processor, and the names of its functions and objects.
class Image {
 public:
  static constexpr std::uint32_t flash_begin = 0x08000000;
  static constexpr std::size_t flash_size = 0x100000;

  /// Throws text::Error, with the file and what is wrong with it: not an ELF file, for another processor, without a
  /// vector table, or with bytes outside the flash.
  explicit Image(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// The whole flash of the processor; erased where nothing was flashed.
  [[nodiscard]] const std::vector<std::byte>& flash() const { return flash_; }
  /// Empty when no symbol of that name is there. Of a function without the bit that says Thumb.
  [[nodiscard]] std::optional<std::uint32_t> address_of(const std::string& symbol) const;
  /// The name of the last symbol at or before this address, with the distance to it: "main + 0x12". "?" before the
  /// first.
  [[nodiscard]] std::string where(std::uint32_t address) const;

 private:
  std::filesystem::path file_;
  std::vector<std::byte> flash_;
  std::map<std::string, std::uint32_t> addresses_;
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace fantail::board
