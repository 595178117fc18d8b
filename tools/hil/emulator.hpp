// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <sched.h>
#include <sys/types.h>

#include "hil/wire.hpp"

namespace fantail::hil {

/// While it exists, the thread that made it, and every process that this thread starts, share one processor. Two
/// processes that take turns, as world and emulator do, are much quicker that way: on two, each turn wakes a processor
/// that has gone to sleep.
class OneProcessor {
 public:
  OneProcessor();
  ~OneProcessor();
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  pid_t thread_;
  cpu_set_t before_{};
  bool bound_ = false;
};

struct EmulatorOptions {
  std::filesystem::path image{};
  /// Nanoseconds of one instruction as a power of two: 2^3 is 125 million a second, about those of an STM32F405. The
  /// emulated time does not wait for ours.
  std::string icount = "shift=3,sleep=off";
  std::string program = "qemu-system-arm";
  /// Not QEMU but a virtual board: where it writes what was measured at its pins, when the flight is over. `program` is
  /// fantail-board then, and has a time of its own.
  std::optional<std::filesystem::path> diary{};
};

/// An image on a processor that is emulated, in a process of its own that ends with this object, and with this process
/// whatever happens to it.
class Emulator final : public Wire {
 public:
  /// Throws text::Error without an image, and TargetError without an emulator.
  explicit Emulator(const EmulatorOptions& options);
  ~Emulator() override;
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  void write(std::span<const std::byte> bytes) override;
  [[nodiscard]] std::size_t read(std::span<std::byte> out, std::chrono::milliseconds at_most) override;

  [[nodiscard]] pid_t process() const { return process_; }

  /// Nobody will ask any more: waits until a virtual board has written its diary. Throws TargetError when it does not.
  void end();

 private:
  [[noreturn]] void ended();
  [[noreturn]] void fail(int status) const;

  EmulatorOptions options_;
  OneProcessor one_processor_;  ///< for this thread and the emulator
  Descriptor to_target_;
  Descriptor from_target_;
  Descriptor complaints_;
  pid_t process_ = -1;
};

/// Where the build leaves it: beside the folder of the build that made this program, which lies in its libexec.
[[nodiscard]] std::filesystem::path built_image(const std::string& name = "fantail-emulator.elf");

}  // namespace fantail::hil
