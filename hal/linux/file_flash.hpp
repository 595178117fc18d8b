// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "hal/flash.hpp"

namespace fantail::hal::on_linux {

/// NOR flash in a file, for an avionics that runs on a PC. Everything is done at once; a read never waits for a disk.
///
/// The file holds the complement of what is read from the flash, so that erased flash is a hole: a new flash of 16 MiB
/// takes no room on the disk. Every change is written through with pwrite, which outlives this process however it ends,
/// but it is not forced onto the disk, which would make a tick wait: a PC that loses its power may lose the last
/// seconds. The file is not mapped, because a full disk, or somebody who shortens the file, would then kill the
/// process.
class FileFlash final : public Flash {
 public:
  /// Makes the file when it is not there (its folder must be). Throws std::runtime_error, one line that names the file
  /// and says why, when it cannot be made or read, has another size, or is another process's flash.
  explicit FileFlash(std::filesystem::path path,
                     const FlashGeometry& geometry = {.size = 16U << 20U, .sector_size = 4096, .page_size = 256});
  ~FileFlash() override;
  FileFlash(const FileFlash&) = delete;
  FileFlash& operator=(const FileFlash&) = delete;

  [[nodiscard]] FlashGeometry geometry() const override { return geometry_; }
  FlashResult read(std::uint32_t address, std::span<std::byte> out) override;
  FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override;
  FlashResult erase_sector(std::uint32_t address) override;
  [[nodiscard]] bool busy() override { return false; }

 private:
  void open();
  void load();
  [[noreturn]] void refuse(const char* why) const;
  FlashResult write_through(std::uint32_t address, std::size_t size);

  std::filesystem::path path_;
  FlashGeometry geometry_;
  int file_ = -1;
  bool failed_ = false;           ///< for good: the file and the cells no longer agree
  std::vector<std::byte> cells_;  ///< what is read from the flash
};

}  // namespace fantail::hal::on_linux
