// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "address_space.hpp"
#include "elf.hpp"
#include "system_block.hpp"
#include "timeline.hpp"

struct uc_struct;

namespace fantail::board {

/// What an instruction and an access cost. The emulator counts instructions and not cycles: a real Cortex-M4 takes
/// between one and two cycles an instruction, by what the flash and its cache do (docs/performance.md).
struct Pace {
  double cycles_per_instruction = 1.7;
  double cycles_per_access = 3.0;  ///< of a register on a peripheral bus
};

/// What a program did that its processor does not allow.
struct Complaint {
  double time_s;  ///< since power-up
  std::string what;
};

/// A Cortex-M4F, by Unicorn: it runs the bytes of an image, takes exceptions, sleeps, and reaches its registers through
/// an address space. What it does not do: enforce the memory protection unit, need the FPU to be switched on, stack an
/// FPU context lazily.
class Processor {
 public:
  /// All outlive it. It begins at reset().
  Processor(const Image& image, AddressSpace& space, SystemBlock& system, Timeline& timeline, const Pace& pace);
  ~Processor();
  Processor(const Processor&) = delete;  // the emulator points to it
  Processor& operator=(const Processor&) = delete;

  /// Begins at the reset vector; the memory stays as it is.
  void reset();
  /// Runs until stop() is called, by an event of the timeline or by a device.
  void run();
  void stop();

  [[nodiscard]] std::uint32_t program_counter() const;
  /// Past the processor. Throws std::out_of_range where there is no memory.
  void read_memory(std::uint32_t address, std::span<std::byte> bytes) const;
  void write_memory(std::uint32_t address, std::span<const std::byte> bytes);

  /// Called when a function that begins there has returned, with what it returns in the first register.
  void on_return_of(std::uint32_t function, std::function<void(std::uint32_t result)> what);

  // ---- faults ----
  /// It goes on there, as after an upset of its program counter; masked: and lets no interrupt in. This and the next
  /// take place behind the instructions that run just now.
  void jump(std::uint32_t address, bool masked);
  void flip_register(unsigned number, unsigned bit);  ///< 0 to 15; of the program counter bit 0 is none
  static constexpr unsigned float_status = 32;
  static constexpr unsigned float_registers = 33;
  void flip_float_register(unsigned number, unsigned bit);  ///< s0 to s31, and the unit's status
  [[nodiscard]] std::uint32_t float_register(unsigned number) const;
  void move_stack(std::uint32_t address);

  // ---- what was seen ----
  /// Accesses to nobody, instructions that are none: what, where, at what time. The firmware met a hard fault then.
  std::vector<Complaint> complaints{};
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }
  /// A fault in the hard fault handler: only a reset ends it.
  [[nodiscard]] bool is_locked() const { return locked_; }

 private:
  friend struct Hooks;
  struct Returning {
    std::uint32_t entry;
    std::optional<std::uint32_t> comes_back_to;
    std::function<void(std::uint32_t)> what;
  };

  void block(std::uint32_t address, std::uint32_t size);
  [[nodiscard]] std::uint32_t instructions_in(std::uint32_t address, std::uint32_t size);
  [[nodiscard]] std::uint32_t load(std::uint32_t address);
  void store(std::uint32_t address, std::uint32_t value);
  [[nodiscard]] bool is_there(std::uint32_t address);
  void leave();
  void run_events();
  void after_emulation(int error);
  void take(std::uint32_t exception);
  void come_back(std::uint32_t exception_return);
  void fault(std::uint32_t configurable, std::uint32_t address, const std::string& what);
  void sleep();
  void upset(std::function<void()> what);
  [[nodiscard]] std::uint32_t get(int which) const;
  void set(int which, std::uint32_t value);

  const Image& image_;
  AddressSpace& space_;
  SystemBlock& system_;
  Timeline& timeline_;
  std::uint64_t counts_per_instruction_;
  std::uint64_t counts_per_access_;
  uc_struct* engine_ = nullptr;
  /// What is no memory: peripherals, the random number generator, the processor's own.
  struct Bus {
    Processor* processor;
    std::uint32_t begin;
    std::size_t size;
  };
  std::array<Bus, 3> buses_{
      {{this, 0x4000'0000, 0x2'4000}, {this, 0x5006'0000, 0x1000}, {this, 0xE000'0000, 0x10'0000}}};
  std::vector<std::uint16_t> instructions_at_;  ///< of the block that begins at each half word; 0: not counted yet
  std::vector<Returning> returning_;
  std::uint32_t pc_ = 0;
  std::uint64_t instructions_ = 0;
  int interrupt_ = 0;        ///< what the emulator said last: Unicorn's number of an exception
  bool left_by_us_ = false;  ///< and not because it sleeps
  bool in_access_ = false;
  bool leave_later_ = false;
  bool stopped_ = false;
  bool locked_ = false;
  bool asleep_ = false;
  std::function<void()> upset_{};
  bool look_ = true;  ///< an exception may wait that nobody has looked at
  std::optional<std::uint32_t> nobody_at_{};
};

}  // namespace fantail::board
