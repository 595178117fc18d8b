// SPDX-License-Identifier: MIT
#include "avionics/boot_counter.hpp"

#include <algorithm>
#include <limits>

#include "avionics/sealed_words.hpp"

namespace fantail::avionics {
namespace {

constexpr std::uint32_t record_size = sealed_size<1>;
constexpr int most_spoilt = 4;
// The record of the number after this one is all ones: it would look erased.
constexpr std::uint32_t last_count = std::numeric_limits<std::uint32_t>::max() - 1;

}  // namespace

std::optional<std::uint32_t> BootCounter::count() const {
  return step_ == Step::done ? std::optional{count_} : std::nullopt;
}

bool BootCounter::done(Access access) {
  if (access == Access::failed) {
    step_ = Step::failed;
  }
  return access == Access::done;
}

// Meets ARM-8.
void BootCounter::update(core::Microseconds now) {
  const std::uint32_t begin = flash_.map().boot_sectors[sector_];
  switch (step_) {
    case Step::scan: scan(now); break;
    case Step::erase:
      if (done(flash_.erase_sector(now, begin))) {
        step_ = Step::program;
      }
      break;
    case Step::program:
      if (done(flash_.program(now, begin + offset_, seal<1>({count_})))) {
        step_ = Step::check;
      }
      break;
    case Step::check: check(now); break;
    case Step::done:
    case Step::failed: break;
  }
}

void BootCounter::scan(core::Microseconds now) {
  const FlashMap map = flash_.map();
  std::array<std::byte, FlashAccess::read_size> buffer{};
  const auto records = std::span{buffer}.first(std::min<std::size_t>(buffer.size(), map.sector_size - offset_));
  if (!done(flash_.read(now, map.boot_sectors[sector_] + offset_, records))) {
    return;
  }
  look_at(sectors_[sector_], offset_, records);
  offset_ += static_cast<std::uint32_t>(records.size());
  if (offset_ == map.sector_size) {
    offset_ = 0;
    sector_ += 1;
  }
  if (sector_ == sectors_.size()) {
    choose();
  }
}

void BootCounter::look_at(Sector& sector, std::uint32_t offset, std::span<const std::byte> records) {
  for (; !records.empty(); records = records.subspan(record_size), offset += record_size) {
    const auto record = records.first<record_size>();
    if (const auto words = unseal<1>(record); words && words->front() > sector.highest) {
      sector = {.highest = words->front()};
    } else if (!erased(record)) {
      sector.unreadable += 1;
    } else if (!sector.blank) {
      sector.blank = offset;
    }
  }
}

void BootCounter::choose() {
  const std::size_t newest = sectors_[1].highest > sectors_[0].highest ? 1 : 0;
  const Sector& last = sectors_[newest];
  const Sector& other = sectors_[1 - newest];
  // A sector without a record that can be read may have been begun after the other one was full.
  const std::uint64_t count =
      std::uint64_t{last.highest} + last.unreadable + (other.highest == 0 ? other.unreadable : 0U) + 1U;
  if (count > last_count) {
    step_ = Step::failed;
    return;
  }
  count_ = static_cast<std::uint32_t>(count);
  const bool goes_on = last.highest != 0 && last.blank;
  sector_ = goes_on ? newest : 1 - newest;
  offset_ = goes_on ? *last.blank : 0;
  step_ = goes_on ? Step::program : Step::erase;
}

void BootCounter::check(core::Microseconds now) {
  std::array<std::byte, record_size> record{};
  if (!done(flash_.read(now, flash_.map().boot_sectors[sector_] + offset_, record))) {
    return;
  }
  if (record == seal<1>({count_})) {
    step_ = Step::done;
    return;
  }
  // The next slot, but not beyond this sector: the other one may hold the last record that can be read.
  spoilt_ += 1;
  offset_ += record_size;
  const bool one_more = spoilt_ < most_spoilt && offset_ < flash_.map().sector_size && count_ < last_count;
  count_ += one_more ? 1 : 0;
  step_ = one_more ? Step::program : Step::failed;
}

}  // namespace fantail::avionics
