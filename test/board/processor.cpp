// SPDX-License-Identifier: MIT
#include "processor.hpp"

#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unicorn/unicorn.h>

namespace fantail::board {
namespace {

constexpr std::uint32_t ram_begin = 0x2000'0000;
constexpr std::size_t ram_size = 0x2'0000;
constexpr std::uint32_t backup_begin = 0x4002'4000;
constexpr std::size_t backup_size = 0x1000;

// Those of Armv7-M B3.2.15.
constexpr std::uint32_t undefined_instruction = 1U << 16U;
constexpr std::uint32_t precise_bus_fault = 1U << 9U | 1U << 15U;

void expect(uc_err error) {
  if (error != UC_ERR_OK) {
    throw std::runtime_error{fmt::format("the emulator refused: {}", uc_strerror(error))};
  }
}

// Where it does not get this for its translations, it ends the whole program with words of its own.
void demand_address_space() {
  constexpr std::size_t wanted = 1U << 30U;
  void* const place =
      ::mmap(nullptr, wanted, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED) {
    throw std::system_error{errno, std::generic_category(),
                            "the emulator wants 1 GiB of address space, of which it uses little"};
  }
  ::munmap(place, wanted);
}

std::uint64_t counts(double cycles) {
  return static_cast<std::uint64_t>(std::lround(cycles * Timeline::counts_per_cycle));
}

}  // namespace

struct Hooks {
  static std::uint64_t read(uc_engine* /*engine*/, std::uint64_t offset, unsigned /*size*/, void* range) {
    const auto& bus = *static_cast<const Processor::Bus*>(range);
    return bus.processor->load(bus.begin + static_cast<std::uint32_t>(offset));
  }
  static void write(uc_engine* /*engine*/, std::uint64_t offset, unsigned /*size*/, std::uint64_t value, void* range) {
    const auto& bus = *static_cast<const Processor::Bus*>(range);
    bus.processor->store(bus.begin + static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(value));
  }
  static void block(uc_engine* /*engine*/, std::uint64_t address, std::uint32_t size, void* self) {
    static_cast<Processor*>(self)->block(static_cast<std::uint32_t>(address), size);
  }
  static void interrupt(uc_engine* engine, std::uint32_t number, void* self) {
    static_cast<Processor*>(self)->interrupt_ = static_cast<int>(number);
    uc_emu_stop(engine);
  }
  static bool invalid(uc_engine* /*engine*/, uc_mem_type /*type*/, std::uint64_t address, int /*size*/,
                      std::int64_t /*value*/, void* self) {
    static_cast<Processor*>(self)->nobody_at_ = static_cast<std::uint32_t>(address);
    return false;
  }
};

Processor::Processor(const Image& image, AddressSpace& space, SystemBlock& system, Timeline& timeline, const Pace& pace)
    : image_{image},
      space_{space},
      system_{system},
      timeline_{timeline},
      counts_per_instruction_{counts(pace.cycles_per_instruction)},
      counts_per_access_{counts(pace.cycles_per_access)},
      instructions_at_(Image::flash_size / 2) {
  demand_address_space();
  expect(uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &engine_));
  expect(uc_ctl_set_cpu_model(engine_, UC_CPU_ARM_CORTEX_M4));
  expect(uc_mem_map(engine_, Image::flash_begin, Image::flash_size, UC_PROT_READ | UC_PROT_EXEC));
  expect(uc_mem_map(engine_, ram_begin, ram_size, UC_PROT_READ | UC_PROT_WRITE));
  expect(uc_mem_map(engine_, backup_begin, backup_size, UC_PROT_READ | UC_PROT_WRITE));
  for (Bus& bus : buses_) {
    expect(uc_mmio_map(engine_, bus.begin, bus.size, Hooks::read, &bus, Hooks::write, &bus));
  }
  expect(uc_mem_write(engine_, Image::flash_begin, image.flash().data(), image.flash().size()));
  uc_hook hook{};
  expect(uc_hook_add(engine_, &hook, UC_HOOK_BLOCK, reinterpret_cast<void*>(Hooks::block), this, 1, 0));
  expect(uc_hook_add(engine_, &hook, UC_HOOK_INTR, reinterpret_cast<void*>(Hooks::interrupt), this, 1, 0));
  expect(uc_hook_add(engine_, &hook, UC_HOOK_MEM_INVALID, reinterpret_cast<void*>(Hooks::invalid), this, 1, 0));
  system.on_reset_request = [this] { stop(); };
}

Processor::~Processor() { uc_close(engine_); }

std::uint32_t Processor::get(int which) const {
  std::uint32_t value = 0;
  uc_reg_read(engine_, which, &value);
  return value;
}
void Processor::set(int which, std::uint32_t value) { uc_reg_write(engine_, which, &value); }

std::uint32_t Processor::program_counter() const { return pc_; }

void Processor::read_memory(std::uint32_t address, std::span<std::byte> bytes) const {
  if (uc_mem_read(engine_, address, bytes.data(), bytes.size()) != UC_ERR_OK) {
    throw std::out_of_range{fmt::format("no memory at 0x{:08x}", address)};
  }
}
void Processor::write_memory(std::uint32_t address, std::span<const std::byte> bytes) {
  if (uc_mem_write(engine_, address, bytes.data(), bytes.size()) != UC_ERR_OK) {
    throw std::out_of_range{fmt::format("no memory at 0x{:08x}", address)};
  }
}

void Processor::on_return_of(std::uint32_t function, std::function<void(std::uint32_t)> what) {
  returning_.push_back({.entry = function, .comes_back_to = {}, .what = std::move(what)});
}

void Processor::reset() {
  system_.reset();
  locked_ = asleep_ = false;
  upset_ = nullptr;
  std::uint32_t vectors[2]{};
  read_memory(Image::flash_begin, std::as_writable_bytes(std::span{vectors}));
  set(UC_ARM_REG_IPSR, 0);
  set(UC_ARM_REG_PRIMASK, 0);
  set(UC_ARM_REG_CONTROL, 0);
  set(UC_ARM_REG_LR, 0xFFFF'FFFF);
  set(UC_ARM_REG_SP, vectors[0]);
  pc_ = vectors[1] & ~1U;
  for (Returning& each : returning_) {
    each.comes_back_to.reset();
  }
}

void Processor::stop() {
  stopped_ = true;
  leave();
}

// Not in the middle of an access to a device: the emulator would come back to the beginning of the block that it is in,
// and what was written to the device would be written again.
void Processor::leave() {
  if (in_access_) {
    leave_later_ = true;
    return;
  }
  leave_later_ = false;
  left_by_us_ = true;
  uc_emu_stop(engine_);
}

void Processor::run() {
  stopped_ = false;
  while (!stopped_) {
    if (locked_) {
      timeline_.sleep();
      continue;
    }
    if (!asleep_) {
      interrupt_ = 0;
      left_by_us_ = leave_later_ = false;
      nobody_at_.reset();
      look_ = true;
      const uc_err error = uc_emu_start(engine_, pc_ | 1U, 0xFFFF'FFFE, 0, 0);
      pc_ = get(UC_ARM_REG_PC);
      after_emulation(error);
    }
    if (asleep_) {
      sleep();
    }
    if (upset_) {
      std::exchange(upset_, nullptr)();
      asleep_ = false;
      continue;
    }
    const bool masked = (get(UC_ARM_REG_PRIMASK) & 1U) != 0;
    const auto exception = stopped_ || locked_ || asleep_ ? std::nullopt : system_.waiting();
    if (exception && (!masked || *exception == SystemBlock::nmi)) {
      take(*exception);
    }
  }
}

// Why the emulator came to an end.
void Processor::after_emulation(int error) {
  constexpr int exception_exit = 8;
  if (interrupt_ == exception_exit) {
    come_back(pc_ | 1U);
  } else if (nobody_at_) {
    fault(precise_bus_fault, *nobody_at_, fmt::format("an access to 0x{:08x}, where nothing is,", *nobody_at_));
  } else if (interrupt_ != 0 || error != UC_ERR_OK) {
    fault(undefined_instruction, 0, "an instruction that is none");
  } else if (!left_by_us_) {
    asleep_ = true;  // WFI
  }
}

// What waits wakes it, masked or not.
void Processor::sleep() {
  while (!stopped_ && !upset_ && !system_.wakes()) {
    timeline_.sleep();
  }
  asleep_ = !system_.wakes();
}

// Before the block runs. What is left here is come back to: it counts when it runs.
void Processor::block(std::uint32_t address, std::uint32_t size) {
  run_events();
  if (leave_later_) {
    leave();
  }
  if (look_ && !left_by_us_) {
    const auto exception = system_.waiting();
    look_ = exception.has_value();
    if (exception && ((get(UC_ARM_REG_PRIMASK) & 1U) == 0 || *exception == SystemBlock::nmi)) {
      leave();
    }
  }
  if (left_by_us_) {
    return;
  }
  for (Returning& each : returning_) {
    if (address == each.entry) {
      each.comes_back_to = get(UC_ARM_REG_LR) & ~1U;
    } else if (each.comes_back_to == address) {
      each.comes_back_to.reset();
      each.what(get(UC_ARM_REG_R0));
    }
  }
  if (left_by_us_) {
    return;
  }
  const std::uint32_t number = instructions_in(address, size);
  instructions_ += number;
  timeline_.spend(number * counts_per_instruction_);
}

void Processor::run_events() {
  if (timeline_.is_due()) {
    timeline_.run();
    look_ = true;
  }
}

// Each Thumb instruction is one half word, or two when its first five bits are 11101, 11110 or 11111. Armv7-M A5.1.
std::uint32_t Processor::instructions_in(std::uint32_t address, std::uint32_t size) {
  const std::uint32_t place = address - Image::flash_begin;
  if (place >= Image::flash_size || size > Image::flash_size - place) {
    return size / 2;
  }
  std::uint16_t& known = instructions_at_[place / 2];
  if (known == 0) {
    for (std::uint32_t at = place; at < place + size; ++known) {
      const auto first_five = std::to_integer<unsigned>(image_.flash()[at + 1]) >> 3U;
      at += first_five >= 0x1D ? 4 : 2;
    }
  }
  return known;
}

bool Processor::is_there(std::uint32_t address) {
  timeline_.spend(counts_per_access_);
  run_events();
  look_ = true;
  if (space_.has(address)) {
    return true;
  }
  nobody_at_ = nobody_at_.value_or(address);
  in_access_ = false;  // nothing has been written
  leave();
  return false;
}

std::uint32_t Processor::load(std::uint32_t address) {
  in_access_ = true;
  const std::uint32_t value = is_there(address) ? space_.load(address) : 0;
  in_access_ = false;
  return value;
}

void Processor::store(std::uint32_t address, std::uint32_t value) {
  in_access_ = true;
  if (is_there(address)) {
    space_.store(address, value);
  }
  in_access_ = false;
}

}  // namespace fantail::board
