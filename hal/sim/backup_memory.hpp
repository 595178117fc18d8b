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

/// The same with its clock, which is `ahead` of the board's: a reset puts that one back, and not this.
class BackupDomain final : public hal::BackupMemory {
 public:
  explicit BackupDomain(const hal::Clock& clock) : clock_{clock} {}
  [[nodiscard]] std::span<std::byte> bytes() override { return memory_.bytes(); }
  [[nodiscard]] std::optional<Microseconds> running_time() override { return clock_.now() + ahead; }

  Microseconds ahead{};

 private:
  const hal::Clock& clock_;
  sim::BackupMemory memory_;
};

/// Of a board that has none.
class NoBackupMemory final : public hal::BackupMemory {
 public:
  [[nodiscard]] std::span<std::byte> bytes() override { return {}; }
};

}  // namespace fantail::hal::sim
