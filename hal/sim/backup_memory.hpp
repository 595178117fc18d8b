// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hal/backup_memory.hpp"

namespace fantail::hal::sim {

/// As the STM32F405 has it. Delivered zero; it outlives the avionics whose reset it is to survive.
class BackupMemory final : public hal::BackupMemory {
 public:
  [[nodiscard]] std::span<std::byte> bytes() override { return bytes_; }

 private:
  std::array<std::byte, 4096> bytes_{};
};

/// Of a board that has none.
class NoBackupMemory final : public hal::BackupMemory {
 public:
  [[nodiscard]] std::span<std::byte> bytes() override { return {}; }
};

}  // namespace fantail::hal::sim
