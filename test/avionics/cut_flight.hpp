// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "hal/sim/torn_flash.hpp"
#include "recorder_rig.hpp"

namespace fantail::avionics {

/// The soak test tries everything, the suite a part of it.
inline bool everything_is_tried() { return std::getenv("FANTAIL_ALL_CUTS") != nullptr; }

/// One recorded flight, with each program that brought it into the flash.
class CutFlight {
 public:
  /// So many ticks before and after the launch.
  CutFlight(int ticks_before, int ticks_after) : rig_{flash_, 7} {
    rig_.run(core::Phase::armed, ticks_before + 1);
    rig_.run(core::Phase::launched, ticks_after - 1);
    rig_.tick(core::Phase::armed);
    rig_.settle(core::Phase::armed);
    begin_ = flash_map(flash_.geometry())->flight_begin;
    const NotingFlash::Program& last = programs().back();
    const auto region = region_of(flash_).first(last.address + last.bytes.size() - begin_);
    log_.assign(region.begin(), region.end());
    records_ = records_in(log_);
  }

  [[nodiscard]] std::span<const std::byte> log() const { return log_; }
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  [[nodiscard]] const std::vector<NotingFlash::Program>& programs() const { return rig_.noting.programs; }
  [[nodiscard]] std::size_t begin_of(const NotingFlash::Program& program) const { return program.address - begin_; }
  [[nodiscard]] hal::sim::Flash& flash() { return flash_; }

  /// Index of the program that brought a byte of the log.
  [[nodiscard]] std::size_t program_of(std::size_t byte) const {
    const auto after = std::ranges::upper_bound(programs(), byte, {}, [this](const auto& p) { return begin_of(p); });
    return static_cast<std::size_t>(after - programs().begin()) - 1;
  }

  /// Where a reader may begin and still see, from `byte` on, what one that began at the beginning would see: at a
  /// record some way before the one that the byte is in.
  [[nodiscard]] std::size_t reader_begin(std::size_t byte) const {
    constexpr std::ptrdiff_t some_way = 40;
    const auto after = std::ranges::upper_bound(records_, byte, {}, &Record::begin);
    return after - records_.begin() <= some_way ? 0 : std::prev(after, some_way)->begin;
  }

  /// How many records have their last byte before this one.
  [[nodiscard]] std::size_t ended_by(std::size_t byte) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(records_, byte, {}, &Record::end) - records_.begin());
  }

  /// Is what was read a record that was written, at its place and with its bytes?
  [[nodiscard]] bool was_written(const Record& read, std::span<const std::byte> bytes, std::size_t offset) const {
    const std::size_t begin = read.begin + offset;
    const auto found = std::ranges::lower_bound(records_, begin, {}, &Record::begin);
    return found != records_.end() && found->begin == begin && found->end == read.end + offset &&
           std::ranges::equal(bytes.subspan(read.begin, read.end - read.begin),
                              std::span{log_}.subspan(begin, read.end - read.begin));
  }

 private:
  hal::sim::Flash flash_{one_mib};
  RecorderRig rig_;
  std::uint32_t begin_ = 0;
  Bytes log_;
  std::vector<Record> records_;
};

}  // namespace fantail::avionics
