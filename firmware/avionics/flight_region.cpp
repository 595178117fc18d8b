// SPDX-License-Identifier: MIT
#include "avionics/flight_region.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "avionics/sealed_words.hpp"

namespace fantail::avionics {
namespace {

constexpr std::uint8_t most_bad_in_a_row = 8;

/// By words: byte by byte, a page takes longer than the flight law.
bool are_equal(std::span<const std::byte> one, std::span<const std::byte> other) {
  std::size_t at = 0;
  for (; at + 4 <= one.size(); at += 4) {
    std::uint32_t here = 0;
    std::uint32_t there = 0;
    std::memcpy(&here, one.data() + at, 4);
    std::memcpy(&there, other.data() + at, 4);
    if (here != there) {
      return false;
    }
  }
  return std::ranges::equal(one.subspan(at), other.subspan(at));
}

}  // namespace

void FlightRegion::update(core::Microseconds now) {
  switch (step_) {
    case Step::look: look(now); break;
    case Step::check_next: check_next(now); break;
    case Step::erase: erase(now); break;
    case Step::check_erase: {
      // That a read is done says that the last erase has ended.
      std::array<std::byte, smallest_page> first{};
      if (done(flash_.read(now, address(0), first))) {
        step_ = Step::ready;
      }
      break;
    }
    case Step::ready:
    case Step::failed: break;
  }
}

bool FlightRegion::done(Access access) {
  if (access == Access::failed) {
    step_ = Step::failed;
  }
  return access == Access::done;
}

void FlightRegion::look(core::Microseconds now) {
  std::array<std::byte, smallest_page> first{};
  if (!done(flash_.read(now, address(sector_), first))) {
    return;
  }
  sector_ += 1;
  end_ = erased(first) ? end_ : sector_;
  if (sector_ == flash_.map().flight_sectors()) {
    step_ = end_ < sector_ ? Step::check_next : Step::ready;
  }
}

void FlightRegion::look_from(std::uint32_t used_sectors) {
  if (step_ == Step::look) {
    end_ = std::min(used_sectors, flash_.map().flight_sectors());
    step_ = end_ < flash_.map().flight_sectors() ? Step::check_next : Step::ready;
  }
}

void FlightRegion::check_next(core::Microseconds now) {
  const std::uint32_t sector_size = flash_.map().sector_size;
  std::array<std::byte, FlashAccess::read_size> buffer{};
  const auto bytes = std::span{buffer}.first(std::min<std::size_t>(buffer.size(), sector_size - offset_));
  if (!done(flash_.read(now, address(end_) + offset_, bytes))) {
    return;
  }
  offset_ += static_cast<std::uint32_t>(bytes.size());
  if (!erased(bytes)) {
    end_ += 1;
    offset_ = 0;
  }
  if (offset_ == sector_size || end_ == flash_.map().flight_sectors()) {
    step_ = Step::ready;
  }
}

std::optional<std::uint32_t> FlightRegion::free_bytes() const {
  if (!finished() || failed()) {
    return std::nullopt;
  }
  return (flash_.map().flight_sectors() - end_) * flash_.map().sector_size;
}

std::optional<std::uint32_t> FlightRegion::open() {
  if (step_ != Step::ready || end_ == flash_.map().flight_sectors()) {
    return std::nullopt;
  }
  write_at_ = address(end_);
  return end_;
}

Access FlightRegion::append(core::Microseconds now, std::span<const std::byte> bytes) {
  const Access access = flash_.program(now, write_at_, bytes);
  if (done(access)) {
    const std::uint32_t sector_size = flash_.map().sector_size;
    write_at_ += static_cast<std::uint32_t>(bytes.size());
    end_ = (write_at_ - flash_.map().flight_begin + sector_size - 1) / sector_size;
  }
  return access;
}

FlightRegion::Kept FlightRegion::look_back(core::Microseconds now, std::span<const std::byte> bytes) {
  std::array<std::byte, FlashAccess::read_size> there{};
  const auto out = std::span{there}.first(bytes.size());
  const Access access = flash_.read(now, write_at_ - static_cast<std::uint32_t>(bytes.size()), out);
  if (!done(access)) {
    return access == Access::again ? Kept::again : Kept::failed;
  }
  if (are_equal(out, bytes)) {
    bad_in_a_row_ = 0;
    return Kept::yes;
  }
  if (++bad_in_a_row_ > most_bad_in_a_row) {
    step_ = Step::failed;
    return Kept::failed;
  }
  return Kept::no;
}

Access FlightRegion::pass_over(core::Microseconds now, std::size_t size) {
  const std::array<std::byte, FlashAccess::read_size> zeros{};
  const Access access = flash_.program(now, write_at_ - static_cast<std::uint32_t>(size), std::span{zeros}.first(size));
  if (done(access)) {
    bad_pages_ = static_cast<std::uint16_t>(bad_pages_ + 1U);
    write_at_ = address(end_);
  }
  return access;
}

Access FlightRegion::read(core::Microseconds now, std::uint32_t offset, std::span<std::byte> out) {
  const FlashMap map = flash_.map();
  const std::uint32_t size = map.flight_end - map.flight_begin;
  if (offset > size || out.size() > size - offset || out.size() > FlashAccess::read_size) {
    return Access::failed;
  }
  return flash_.read(now, map.flight_begin + offset, out);
}

bool FlightRegion::begin_erase() {
  if (step_ == Step::ready) {
    step_ = Step::erase;
  }
  return step_ == Step::erase;
}

void FlightRegion::erase(core::Microseconds now) {
  if (end_ == 0) {
    step_ = Step::check_erase;
  } else if (done(flash_.erase_sector(now, address(end_ - 1)))) {
    end_ -= 1;
  }
}

}  // namespace fantail::avionics
