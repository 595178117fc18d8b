// SPDX-License-Identifier: MIT
#include "avionics/flight_memory.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "avionics/backup_map.hpp"
#include "avionics/write_state.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/state_block.hpp"

namespace fantail::avionics {

using core::Microseconds;
using core::Phase;
using hal::ResetCause;
using protocol::get;
using protocol::put;
using protocol::ResumedAfter;
using protocol::StateExtent;

namespace {

// A half, little-endian:
//    0  4 bytes  mark
//    4  u32      CRC-32C of everything behind it, up to the end of the state
//    8  u32      sequence: the half with the larger one is the newer
//   12  i64      time of the tick, microseconds
//   20  u32      CRC of the plan
//   24  u32      layout of the state
//   28  u32      resumes of this flight so far
//   32  u32      sectors of the flash that are in use
//   36  u8       bit 0: the sectors are known; bit 1: byte 40 is
//   37  u8       starts of the firmware since this was sealed; bit 7: the last one has yet to try a resume
//   38  u16      size of the state
//   40  i64      how far the clock that runs on over a reset was ahead of the board's, microseconds
//   48  the state
//
// Everything but what lies in the state stands at a multiple of its size up to a word. In the state nothing does: the
// processor reads and writes it byte by byte or unaligned, which it may because the memory is mapped as normal memory
// (hal/stm32f4/memory_protection.cpp).
constexpr std::uint32_t mark = 0x4D4C4646;  // "FFLM"
constexpr std::size_t crc_at = 4;
constexpr std::size_t sealed_from = 8;
constexpr std::size_t time_at = 12;
constexpr std::size_t plan_at = 20;
constexpr std::size_t layout_at = 24;
constexpr std::size_t resumes_at = 28;
constexpr std::size_t sectors_at = 32;
constexpr std::size_t known_at = 36;
constexpr std::uint32_t sectors_known = 1;
constexpr std::uint32_t ahead_known = 2;
constexpr std::size_t starts_at = 37;
constexpr std::uint32_t not_yet_tried = 0x80;
constexpr std::size_t size_at = 38;
constexpr std::size_t ahead_at = 40;
constexpr std::size_t state_at = 48;
constexpr std::size_t most_state = flight_half_size - state_at;
static_assert(flight_half_size % 4 == 0 && state_at % 4 == 0 && time_at % 4 == 0 && ahead_at % 4 == 0);

constexpr std::array<std::size_t, 2> both{0, 1};

bool flies(Phase phase) { return phase != Phase::safe && phase != Phase::armed; }

bool may_be_resumed_after(ResetCause cause) { return cause == ResetCause::watchdog || cause == ResetCause::software; }

std::uint32_t word(std::span<const std::byte> half, std::size_t at) {
  return static_cast<std::uint32_t>(get<4>(half, at));
}

std::size_t state_size(std::span<const std::byte> half) { return static_cast<std::size_t>(get<2>(half, size_at)); }

std::span<std::byte> state_in(std::span<std::byte> half) {
  return half.subspan(state_at, std::min(state_size(half), most_state));
}

std::uint32_t checksum(std::span<std::byte> half) {
  return protocol::crc32c(half.subspan(sealed_from, state_at - sealed_from + state_in(half).size()));
}

void seal(std::span<std::byte> half) {
  put<4>(half, crc_at, checksum(half));
  put<4>(half, 0, mark);
}

void break_seal(std::span<std::byte> half) {
  put<4>(half, 0, 0);
  put<4>(half, crc_at, 0);
}

[[gnu::cold]] bool sealed(std::span<std::byte> half) {
  return !half.empty() && word(half, 0) == mark && state_size(half) <= most_state &&
         word(half, crc_at) == checksum(half);
}

/// Those that are sealed, the newer one first; the others are empty.
[[gnu::cold]] std::array<std::span<std::byte>, 2> newest_first(std::span<std::byte> memory) {
  std::array<std::span<std::byte>, 2> halves{};
  for (const std::size_t i : both) {
    const auto half = flight_half(memory, i);
    halves[i] = sealed(half) ? half : std::span<std::byte>{};
  }
  if (!halves[1].empty() && (halves[0].empty() || word(halves[1], sealed_from) > word(halves[0], sealed_from))) {
    std::swap(halves[0], halves[1]);
  }
  return halves;
}

std::uint32_t starts_since(std::span<const std::byte> half) {
  return static_cast<std::uint32_t>(get<1>(half, starts_at)) & ~not_yet_tried;
}

bool waits_to_be_tried(std::span<const std::byte> half) { return (get<1>(half, starts_at) & not_yet_tried) != 0; }

/// In both halves, because the older one is tried when the newer is refused.
[[gnu::cold]] void set_starts(std::span<std::byte> memory, std::uint32_t starts, bool tried) {
  const auto halves = newest_first(memory);
  for (const std::span<std::byte> half : halves) {
    if (!half.empty()) {
      put<4>(half, resumes_at, word(halves[0], resumes_at));
      put<1>(half, starts_at, std::min(starts, not_yet_tried - 1) | (tried ? 0 : not_yet_tried));
      seal(half);
    }
  }
}

bool knows(std::span<const std::byte> half, std::uint32_t what) {
  return (static_cast<std::uint32_t>(get<1>(half, known_at)) & what) != 0;
}

Microseconds time_of(std::span<const std::byte> half) {
  return Microseconds{static_cast<std::int64_t>(get<8>(half, time_at))};
}

[[gnu::cold]] bool restore(std::span<std::byte> half, const core::Inputs& first, std::uint32_t plan_crc,
                           core::Autopilot& law) {
  const Microseconds gap = first.time - time_of(half);
  if (word(half, plan_at) != plan_crc || word(half, layout_at) != state_layout(law) ||
      word(half, resumes_at) + starts_since(half) > FlightMemory::most_resumes || gap <= Microseconds{0} ||
      gap > FlightMemory::longest_gap) {
    return false;
  }
  protocol::StateReader reader{state_in(half), StateExtent::in_flight};
  law.visit_state(reader);
  return reader.ok() && flies(law.phase());
}

}  // namespace

FlightMemory::FlightMemory(hal::BackupMemory& memory, const hal::Clock& clock, ResetCause cause)
    : memory_{memory},
      clock_{clock},
      after_{cause == ResetCause::watchdog ? ResumedAfter::watchdog : ResumedAfter::software} {
  // Meets MEM-1.
  waits_ = may_be_resumed_after(cause) && !newest_first(memory_.bytes())[0].empty();
  if (!waits_) {
    forget();
  }
}

// Meets MEM-2, MEM-3.
std::optional<FlightMemory::Resumed> FlightMemory::resume(const core::Inputs& first, std::uint32_t plan_crc,
                                                          core::Autopilot& law) {
  waits_ = false;
  // Before the state is used: should the law crash on it, the next reset must know that it was tried.
  const std::span<std::byte> memory = memory_.bytes();
  if (const auto newest = newest_first(memory)[0]; !newest.empty()) {
    set_starts(memory, starts_since(newest) + (waits_to_be_tried(newest) ? 0 : 1), true);
  }
  for (const std::span<std::byte> half : newest_first(memory)) {
    if (half.empty() || !restore(half, first, plan_crc, law)) {
      continue;
    }
    sequence_ = word(half, sealed_from);
    resumes_ = word(half, resumes_at) + starts_since(half);
    law.resume(first);
    return Resumed{.sealed_at = time_of(half),
                   .after = after_,
                   .used_sectors = knows(half, sectors_known) ? std::optional{word(half, sectors_at)} : std::nullopt};
  }
  forget();
  return std::nullopt;
}

void FlightMemory::keep(const core::TickRecord& record, std::uint32_t plan_crc,
                        std::optional<std::uint32_t> used_sectors, core::Autopilot& law) {
  if (waits_) {
    return;
  }
  if (!layout_ || layout_plan_ != plan_crc) {
    layout_ = state_layout(law);
    layout_plan_ = plan_crc;
  }
  if (!flies(record.phase)) {
    if (sequence_ > 0) {
      forget();
    }
    return;
  }
  const std::span<std::byte> memory = memory_.bytes();
  if (memory.size() < backup_size || (sealed_at_ && record.time - *sealed_at_ < period)) {
    return;
  }
  sealed_at_ = record.time;
  sequence_ += 1;
  const std::span<std::byte> half = flight_half(memory, sequence_ % 2);
  break_seal(half);
  const std::size_t size = write_state(law, half.subspan(state_at), StateExtent::in_flight);
  // uncovered: every state fits (a test measures it)
  if (size > most_state) {
    return;  // part of a state would be none
  }
  put<4>(half, sealed_from, sequence_);
  put<8>(half, time_at, static_cast<std::uint64_t>(record.time.count()));
  put<4>(half, plan_at, plan_crc);
  put<4>(half, layout_at, *layout_);
  put<4>(half, resumes_at, resumes_);
  put<4>(half, sectors_at, used_sectors.value_or(0));
  const std::optional<Microseconds> running = memory_.running_time();
  put<1>(half, known_at, (used_sectors ? sectors_known : 0) | (running ? ahead_known : 0));
  put<8>(half, ahead_at, static_cast<std::uint64_t>(running ? (*running - clock_.now()).count() : 0));
  put<1>(half, starts_at, 0);
  put<2>(half, size_at, size);
  seal(half);
}

void FlightMemory::forget() {
  for (const std::size_t i : both) {
    if (const auto half = flight_half(memory_.bytes(), i); !half.empty()) {
      break_seal(half);
    }
  }
  sequence_ = 0;
  resumes_ = 0;
  sealed_at_.reset();
}

std::optional<Microseconds> clock_after_reset(hal::BackupMemory& memory, ResetCause cause, Microseconds assumed_gap) {
  const auto newest = newest_first(memory.bytes())[0];
  if (!may_be_resumed_after(cause) || newest.empty()) {
    return std::nullopt;
  }
  set_starts(memory.bytes(), starts_since(newest) + 1, false);
  const Microseconds assumed = assumed_gap * starts_since(newest);
  const std::optional<Microseconds> running = memory.running_time();
  if (running && knows(newest, ahead_known)) {
    const Microseconds ahead{static_cast<std::int64_t>(get<8>(newest, ahead_at))};
    if (*running - ahead - time_of(newest) >= assumed / 2) {
      return *running - ahead;
    }
  }
  return time_of(newest) + assumed;
}

}  // namespace fantail::avionics
