// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "avionics/flash_access.hpp"
#include "core/time.hpp"

namespace fantail::avionics {

/// Where the records of flights lie: one behind the other from the bottom, each begun on a fresh sector, and none ever
/// overwritten. Only an erase of them all gives room back.
///
/// Nothing says where the last one ends but the flash itself, so that no power cut can spoil it. At power-up the
/// beginning of every sector is looked at, one a tick (4 s for 16 MiB): the next flight comes behind the last sector
/// that begins with anything, if the sector there is blank to its last byte. An erase or a first page that was cut off
/// may have left something deeper in; such a sector is stepped over.
class FlightRegion {
 public:
  /// The access outlives this object.
  explicit FlightRegion(FlashAccess& flash) : flash_{flash} {}

  /// Once a tick while nobody else has the flash: at most one call to it, for the look or for an erase.
  void update(core::Microseconds now);

  /// Instead of the look at power-up, by whoever knows for certain that nothing lies behind these sectors but what was
  /// appended since: the next flight comes behind that, as soon as a blank sector has been found.
  void look_from(std::uint32_t used_sectors);
  /// Empty until the whole region has been looked at.
  [[nodiscard]] std::optional<std::uint32_t> used_sectors() const {
    return finished() && !failed() ? std::optional{end_} : std::nullopt;
  }

  /// The look at power-up has ended.
  [[nodiscard]] bool finished() const { return step_ != Step::look && step_ != Step::check_next; }
  /// The flash does not answer.
  [[nodiscard]] bool failed() const { return step_ == Step::failed; }
  /// Empty until the whole region has been looked at.
  [[nodiscard]] std::optional<std::uint32_t> free_bytes() const;

  // ---- one flight ----

  /// Begins a flight, which uses nothing before its first byte. Its number, by which one is told from the others of
  /// this flash: its first sector. Empty: full, failed, being erased, or not yet looked at.
  std::optional<std::uint32_t> open();
  /// Bytes that the open flight may still have.
  [[nodiscard]] std::size_t room() const { return flash_.map().flight_end - write_at_; }
  /// Bytes that may be appended at once.
  [[nodiscard]] std::size_t page_room() const {
    const std::uint32_t page = flash_.map().page_size;
    return page - write_at_ % page;  // NOLINT(clang-analyzer-core.DivideZero): without a map no flight is open
  }
  /// Within the page. Not in a tick in which update() was called.
  Access append(core::Microseconds now, std::span<const std::byte> bytes);

  /// A flash does not say that a cell has not taken what it was given: only to read it back does.
  enum class Kept : std::uint8_t { yes, no, again, failed };
  /// Does what was appended last, which these bytes are, lie there? Failed, too, when many sectors in a row keep
  /// nothing.
  Kept look_back(core::Microseconds now, std::span<const std::byte> bytes);
  /// It does not: as much of it as can be is made zeros, so that no reader finds part of it twice, and the flight goes
  /// on in the next sector.
  Access pass_over(core::Microseconds now, std::size_t size);
  /// That did not keep what they were given, since power-up.
  [[nodiscard]] std::uint32_t bad_pages() const { return bad_pages_; }

  // ---- all of them ----

  /// Of the region, from its beginning: flights and what lies between them, up to a whole sector.
  [[nodiscard]] std::uint32_t used_bytes() const { return end_ * flash_.map().sector_size; }
  /// Stored bytes, from `offset` in the region on; `out` has at most FlashAccess::read_size bytes. Failed beyond the
  /// region's end.
  Access read(core::Microseconds now, std::uint32_t offset, std::span<std::byte> out);

  /// Erases all flights, from the last sector down, so that what a power cut leaves is a row of flights that ends
  /// early. False when it is not to be had now. Whoever calls this knows that nobody flies.
  bool begin_erase();
  /// Ends it after the sector that is being erased; until that is done it is erasing() still.
  void stop_erase() { step_ = step_ == Step::erase ? Step::check_erase : step_; }
  [[nodiscard]] bool erasing() const { return step_ == Step::erase || step_ == Step::check_erase; }

 private:
  enum class Step : std::uint8_t { look, check_next, ready, erase, check_erase, failed };

  void look(core::Microseconds now);
  void check_next(core::Microseconds now);
  void erase(core::Microseconds now);
  [[nodiscard]] bool done(Access access);
  [[nodiscard]] std::uint32_t address(std::uint32_t sector) const {
    return flash_.map().flight_begin + sector * flash_.map().sector_size;
  }

  FlashAccess& flash_;
  Step step_ = Step::look;
  std::uint32_t sector_ = 0;    ///< that is looked at next
  std::uint32_t offset_ = 0;    ///< in the sector that is checked
  std::uint32_t end_ = 0;       ///< sectors in use
  std::uint32_t write_at_ = 0;  ///< address
  std::uint16_t bad_pages_ = 0;
  std::uint8_t bad_in_a_row_ = 0;
};

}  // namespace fantail::avionics
