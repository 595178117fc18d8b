// SPDX-License-Identifier: MIT
#include "hal/stm32f4/flash.hpp"

#include <algorithm>

#include "hal/stm32f4/w25q.hpp"

namespace fantail::hal::stm32f4 {
namespace {

constexpr std::uint32_t page_size = 256;
constexpr std::uint32_t sector_size = 4096;
// It takes 3 us to come out of power-down (section 9.6), and each try is two bytes, 0.7 us at least.
constexpr int tries_at_boot = 32;
constexpr std::uint8_t nobody = 0xFF;  // a line that nobody drives is pulled up

FlashGeometry geometry_of(std::uint8_t capacity) {
  return {.size = 1U << capacity, .sector_size = sector_size, .page_size = page_size};
}

std::array<std::byte, 4> with_address(std::byte instruction, std::uint32_t address) {
  return {instruction, static_cast<std::byte>(address >> 16U & 0xFFU), static_cast<std::byte>(address >> 8U & 0xFFU),
          static_cast<std::byte>(address & 0xFFU)};
}

}  // namespace

void Flash::start() {
  state_ = State::absent;
  geometry_ = {};
  silent_ = true;
  for (int i = 0; i < tries_at_boot && silent_; ++i) {
    // Also a device that does not sleep takes this: it says its id, to which nobody listens.
    static_cast<void>(command(w25q::release_power_down));
    const auto now_busy = status(w25q::read_status_1);
    if (!now_busy || *now_busy == nobody) {
      continue;
    }
    if ((*now_busy & w25q::busy) != 0) {
      silent_ = false;
      state_ = State::unnamed;
      geometry_ = geometry_of(w25q::w25q128_capacity);
      begin(w25q::longest_erase);
    } else {
      static_cast<void>(identify());
    }
  }
}

std::optional<std::uint8_t> Flash::status(std::byte instruction) {
  std::array<std::byte, 1> value{};
  const bool done = device_.transfer({{.out = std::array{instruction}}, {.in = value}});
  return done ? std::optional{std::to_integer<std::uint8_t>(value[0])} : std::nullopt;
}

bool Flash::identify() {
  std::array<std::byte, 3> id{};
  const bool done = device_.transfer({{.out = std::array{w25q::jedec_id}}, {.in = id}});
  const auto is = [&id](std::uint8_t value) {
    return std::ranges::all_of(id, [value](std::byte byte) { return byte == std::byte{value}; });
  };
  silent_ = !done || is(0x00) || is(nobody);
  const auto capacity = std::to_integer<std::uint8_t>(id[2]);
  const bool known_type = id[1] == std::byte{w25q::memory_type} || id[1] == std::byte{w25q::memory_type_m};
  wrong_id_ = !silent_ && (id[0] != std::byte{w25q::manufacturer} || !known_type || capacity < w25q::least_capacity ||
                           capacity > w25q::w25q128_capacity);
  if (silent_ || wrong_id_) {
    state_ = State::absent;
    geometry_ = {};
    return false;
  }
  geometry_ = geometry_of(capacity);
  state_ = clear_protection() ? State::ready : State::write_protected;
  return true;
}

// As volatile bits (section 8.2.2): nothing to wait for, and no wear. What was there comes back at power-up, and is
// cleared again.
bool Flash::clear_protection() {
  struct Protection {
    std::byte read;
    std::byte write;
    std::uint8_t bits;
  };
  constexpr std::array protections{Protection{w25q::read_status_1, w25q::write_status_1, w25q::block_protection},
                                   Protection{w25q::read_status_2, w25q::write_status_2, w25q::complement_protection},
                                   Protection{w25q::read_status_3, w25q::write_status_3, w25q::individual_block_locks}};
  return std::ranges::all_of(protections, [this](const Protection& protection) {
    const auto value = status(protection.read);
    if (!value || (*value & protection.bits) == 0) {
      return value.has_value();
    }
    const std::array cleared{protection.write, static_cast<std::byte>(*value & ~protection.bits)};
    if (!command(w25q::write_enable_for_volatile_status) || !device_.transfer(cleared, {})) {
      return false;
    }
    const auto after = status(protection.read);
    return after && (*after & protection.bits) == 0;
  });
}

void Flash::begin(Microseconds longest) {
  busy_since_ = clock_.now();
  may_be_busy_for_ = longest;
}

std::optional<bool> Flash::poll() {
  const auto value = status(w25q::read_status_1);
  silent_ = !value || *value == nobody;
  if (silent_) {
    return std::nullopt;
  }
  const bool is_busy = (*value & w25q::busy) != 0;
  stuck_ = is_busy && clock_.now() - busy_since_ > may_be_busy_for_;
  return is_busy;
}

bool Flash::busy() { return state_ != State::absent && poll().value_or(false); }

std::optional<FlashResult> Flash::refusal(bool in_range) {
  if (state_ == State::absent) {
    return FlashResult::failed;
  }
  const auto is_busy = poll();
  if (!is_busy) {
    return FlashResult::failed;
  }
  if (*is_busy) {
    return FlashResult::busy;
  }
  if (state_ == State::unnamed) {
    return identify() ? FlashResult::busy : FlashResult::failed;  // its size may be another than was thought
  }
  return in_range ? std::nullopt : std::optional{FlashResult::out_of_range};
}

std::optional<FlashResult> Flash::write_refusal(bool in_range) {
  if (const auto no = refusal(in_range)) {
    return no;
  }
  if (state_ == State::write_protected || !command(w25q::write_enable)) {
    return FlashResult::failed;
  }
  // A device that did not take it would ignore what comes next, and nobody would know.
  const auto value = status(w25q::read_status_1);
  const bool enabled = value && *value != nobody && (*value & w25q::write_enabled) != 0;
  return enabled ? std::nullopt : std::optional{FlashResult::failed};
}

FlashResult Flash::read(std::uint32_t address, std::span<std::byte> out) {
  if (const auto no = refusal(inside(address, out.size()))) {
    return *no;
  }
  const auto command = with_address(w25q::read_data, address);
  return device_.transfer({{.out = command}, {.in = out}}) ? FlashResult::ok : FlashResult::failed;
}

FlashResult Flash::program(std::uint32_t address, std::span<const std::byte> bytes) {
  // Behind the end of its page the device would go on at the beginning.
  const bool in_range = inside(address, bytes.size()) && address % page_size + bytes.size() <= page_size;
  if (const auto no = bytes.empty() ? refusal(in_range) : write_refusal(in_range)) {
    return *no;
  }
  if (bytes.empty()) {
    return FlashResult::ok;
  }
  const auto command = with_address(w25q::page_program, address);
  begin(w25q::longest_program);
  return device_.transfer({{.out = command}, {.out = bytes}}) ? FlashResult::ok : FlashResult::failed;
}

FlashResult Flash::erase_sector(std::uint32_t address) {
  if (const auto no = write_refusal(address < geometry_.size && address % sector_size == 0)) {
    return *no;
  }
  begin(w25q::longest_erase);
  return device_.transfer(with_address(w25q::sector_erase, address), {}) ? FlashResult::ok : FlashResult::failed;
}

BoardFaults Flash::faults() const {
  BoardFaults faults;
  if (silent_) {
    faults.add(BoardFault::flash_silent);
  }
  if (wrong_id_) {
    faults.add(BoardFault::flash_wrong_id);
  }
  if (stuck_) {
    faults.add(BoardFault::flash_stuck);
  }
  return faults;
}

}  // namespace fantail::hal::stm32f4
