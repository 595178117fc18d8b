// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::hal::emulator::semihosting {

// What an emulator or a debugger does for the program (ARM, "Semihosting for AArch32 and AArch64"). On a processor with
// neither of them each of these is a crash.

enum class Mode : std::uint8_t { read = 1, write = 5 };  ///< "rb" and "wb"

/// A handle, or -1. `path` ends with a zero.
[[nodiscard]] int open(const char* path, std::size_t length, Mode mode);
/// Waits for at least one byte. How many came; 0 when there will be no more.
[[nodiscard]] std::size_t read(int handle, std::span<std::byte> out);
/// False when not all could be written.
[[nodiscard]] bool write(int handle, std::span<const std::byte> bytes);
/// For a person; ends with a zero.
void say(const char* text);
[[noreturn]] void exit(bool success);

}  // namespace fantail::hal::emulator::semihosting
