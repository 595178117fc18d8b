// SPDX-License-Identifier: MIT
#include "hal/emulator/semihosting.hpp"

namespace fantail::hal::emulator::semihosting {
namespace {

enum Operation : std::uint32_t {
  sys_open = 0x01,
  sys_write0 = 0x04,
  sys_write = 0x05,
  sys_read = 0x06,
  sys_exit = 0x18,
};
constexpr std::uint32_t application_exit = 0x20026;
constexpr std::uint32_t run_time_error = 0x20023;

// The operation in r0, its argument in r1, the result in r0.
std::uint32_t call(Operation operation, const void* argument) {
  register std::uint32_t r0 __asm("r0") = operation;
  register const void* r1 __asm("r1") = argument;
  __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

std::uint32_t word(const void* address) { return reinterpret_cast<std::uint32_t>(address); }

}  // namespace

int open(const char* path, std::size_t length, Mode mode) {
  const std::uint32_t block[] = {word(path), static_cast<std::uint32_t>(mode), length};
  return static_cast<int>(call(sys_open, block));
}

std::size_t read(int handle, std::span<std::byte> out) {
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle), word(out.data()), out.size()};
  const std::uint32_t not_read = call(sys_read, block);
  return not_read <= out.size() ? out.size() - not_read : 0;
}

bool write(int handle, std::span<const std::byte> bytes) {
  const std::uint32_t block[] = {static_cast<std::uint32_t>(handle), word(bytes.data()), bytes.size()};
  return call(sys_write, block) == 0;
}

void say(const char* text) { (void)call(sys_write0, text); }

void exit(bool success) {
  const std::uint32_t reason = success ? application_exit : run_time_error;
  for (;;) {
    (void)call(sys_exit, reinterpret_cast<const void*>(reason));
  }
}

}  // namespace fantail::hal::emulator::semihosting
