// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flash_access.hpp"
#include "core/flight_plan.hpp"
#include "core/time.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// What lay in flash at power-up.
struct StoredPlan {
  std::optional<core::FlightPlan> plan{};
  std::uint32_t block_crc = 0;  ///< protocol::plan_block_crc() of its block
  bool newer = false;           ///< the newest one was made for a newer version of the firmware; then there is no plan
  bool broken = false;          ///< a slot holds what cannot be flown; beside a plan it may be a write that was cut off
  bool flash_failed = false;    ///< nothing is known
};

[[nodiscard]] constexpr protocol::PlanSource source_of(const StoredPlan& stored) {
  using protocol::PlanSource;
  if (stored.flash_failed) {
    return PlanSource::flash_unreadable;
  }
  if (stored.plan) {
    return PlanSource::stored;
  }
  if (stored.newer) {
    return PlanSource::stored_is_newer;
  }
  return stored.broken ? PlanSource::stored_is_broken : PlanSource::built_in;
}

enum class PlanWrite : std::uint8_t {
  none,
  under_way,
  stored,             ///< read back, and taken at the next power-up
  flash_failed,       ///< it does not answer, or has been busy for more than 2 s. When that happens at the very end,
                      ///< nobody knows which plan the next power-up will find; it is an intact one
  read_back_differs,  ///< it does not hold what was written, and its slot has been made void: the plan in the other
                      ///< one is taken at the next power-up too
};

/// The flight plan in flash, in two slots of which the older one is written. A slot is a page that begins with a header
/// (sequence number, size of the block, its plan_block_crc(), CRC-32C of these three), and the pages of the block. The
/// header is written last, and only when the block has been read back: a power cut, or a flash that does not keep what
/// it was told, leaves the plan in the other slot.
class PlanStore {
 public:
  /// The access outlives this object.
  explicit PlanStore(FlashAccess& flash) : flash_{flash} {}

  /// At power-up. Reads and checks up to two blocks at once, so not within a tick. Empty while the flash is busy, which
  /// it can be with what was begun before a reset: try again.
  std::optional<StoredPlan> load(core::Microseconds now);

  /// `block` has 1 to protocol::largest_plan_block bytes, and stays as it is until the write has ended. Fails when the
  /// flash could not be read at power-up: then nobody knows which slot to spare.
  void begin_write(std::span<const std::byte> block);

  /// Takes the write back if nothing has been erased yet; else it goes on, and the answer is false.
  bool withdraw();

  /// Once a tick: at most one call to the flash.
  void update(core::Microseconds now);

  [[nodiscard]] PlanWrite write() const { return write_; }

 private:
  enum class Step : std::uint8_t { erase, block, check_block, header, check_header, make_void, check_void };
  struct Slot {
    std::uint32_t sequence;
    std::uint32_t size;
    std::uint32_t block_crc;
  };

  Access read_headers(core::Microseconds now, StoredPlan& out);
  Access read_block(core::Microseconds now, std::size_t slot, StoredPlan& out);
  [[nodiscard]] bool done(Access access);
  [[nodiscard]] std::array<std::byte, 16> header() const;
  void program_page(core::Microseconds now, std::uint32_t address);
  void check(core::Microseconds now, std::uint32_t address, std::span<const std::byte> expected);
  void check_void(core::Microseconds now, std::uint32_t slot);

  FlashAccess& flash_;
  std::array<std::optional<Slot>, 2> slots_{};  ///< those whose header is intact, at power-up
  bool loaded_ = false;
  std::optional<std::size_t> in_force_;  ///< the slot that must be spared
  std::uint32_t sequence_ = 0;           ///< highest that was ever seen

  PlanWrite write_ = PlanWrite::none;
  Step step_ = Step::erase;
  std::span<const std::byte> block_{};
  std::size_t target_ = 0;
  std::size_t at_ = 0;  ///< bytes of the block that are programmed, or checked
};

}  // namespace fantail::avionics
