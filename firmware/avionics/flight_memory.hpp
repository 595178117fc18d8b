// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/autopilot.hpp"
#include "core/inputs.hpp"
#include "core/tick_record.hpp"
#include "core/time.hpp"
#include "hal/backup_memory.hpp"
#include "hal/board.hpp"
#include "hal/clock.hpp"
#include "protocol/log_notes.hpp"

namespace fantail::avionics {

/// Keeps a flight where a reset leaves it alone, so that the rest of it can be flown after one.
///
/// From launch detection on, the state of the flight law is sealed with a CRC-32C every 10 ms, in two halves in turn:
/// one of them is whole at any moment. On the pad nothing valid lies there. After a reset by the watchdog or by
/// the firmware itself the flight goes on from the newer half that is intact and of the plan and the law that are in
/// force; after any other reset, and after the third resume of one flight, the rocket is Safe. It never comes back
/// armed.
///
/// What is written goes straight into that memory. A seal takes the state written out and a CRC over 0.7 kB; with it
/// goes how far the clock that runs on over a reset is ahead of the board's.
class FlightMemory {
 public:
  static constexpr core::Microseconds period{10'000};
  /// After this time the attitude of the rocket is unknown.
  static constexpr core::Microseconds longest_gap{250'000};
  /// A flight that crashes the processor again and again is not flown on: the canards are brought to trim, in Safe.
  static constexpr std::uint32_t most_resumes = 3;

  /// Nothing that lies in the memory is left valid, unless a flight may be resumed. Both devices outlive this object.
  [[gnu::cold]] FlightMemory(hal::BackupMemory& memory, const hal::Clock& clock, hal::ResetCause cause);

  /// A flight lies there: resume() wants to be called, once it is known which plan is in force.
  [[nodiscard]] bool waits() const { return waits_; }

  struct Resumed {
    core::Microseconds sealed_at{};
    protocol::ResumedAfter after{};
    std::optional<std::uint32_t> used_sectors{};  ///< as given to keep()
  };
  /// Before step(first). `law` is made of the plan in force. Empty: it must be made anew, and nothing valid is left.
  [[nodiscard, gnu::cold]] std::optional<Resumed> resume(const core::Inputs& first, std::uint32_t plan_crc,
                                                         core::Autopilot& law);

  /// Once a tick, after the law's step. `used_sectors`: of the flash's region of flights, when that is known.
  void keep(const core::TickRecord& record, std::uint32_t plan_crc, std::optional<std::uint32_t> used_sectors,
            core::Autopilot& law);

  /// Of this flight.
  [[nodiscard]] std::uint32_t resumes() const { return resumes_; }

 private:
  [[gnu::cold]] void forget();

  hal::BackupMemory& memory_;
  const hal::Clock& clock_;
  bool waits_ = false;
  protocol::ResumedAfter after_ = protocol::ResumedAfter::software;
  std::uint32_t sequence_ = 0;
  std::uint32_t resumes_ = 0;
  std::optional<core::Microseconds> sealed_at_{};
  std::optional<std::uint32_t> layout_{};  ///< the same for every state by one plan
  std::uint32_t layout_plan_ = 0;          ///< that plan's CRC
};

/// For a board whose clock begins anew with a reset: where it must begin so that a flight that lies in the memory can
/// be resumed, because the clock goes on in flight. Empty: at zero, as after power-up. A clock that runs on over the
/// reset has measured it. Where there is none, `assumed_gap` is taken for it: from the last seal to the first look at
/// the clock. It is taken too where that clock shows less than half of it, which is a clock that stood still.
///
/// Once, as early as can be: this start is counted against the flight, so that a firmware that crashes before its first
/// tick comes to Safe too, and each start since the seal is another assumed gap.
[[nodiscard, gnu::cold]] std::optional<core::Microseconds> clock_after_reset(hal::BackupMemory& memory,
                                                                             hal::ResetCause cause,
                                                                             core::Microseconds assumed_gap);

}  // namespace fantail::avionics
