// SPDX-License-Identifier: MIT
#include "fake_w25q.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "hal/sim/torn_flash.hpp"

namespace fantail::hal::stm32f4::test {
namespace {

constexpr std::size_t page_size = 256, sector_size = 4096;

}  // namespace

std::size_t FakeW25q::address() const {
  return (std::size_t{bytes_[1]} << 16U | std::size_t{bytes_[2]} << 8U | bytes_[3]) % cells.size();
}

// Section 7.1: any block protection, or none of it complemented, or the individual locks, which are all on at power-up.
bool FakeW25q::is_protected() const {
  return (status[0] & 0x1CU) != 0 || (status[1] & 0x40U) != 0 || (status[2] & 0x04U) != 0;
}

bool FakeW25q::busy() {
  if (doing_ != Doing::nothing && clock_.time >= done_at_) {
    finish();
  }
  return always_busy || doing_ != Doing::nothing;
}

std::uint8_t FakeW25q::exchange(std::uint8_t out) {
  if (stuck_at) {
    return *stuck_at;
  }
  const bool is_busy = busy();
  if (bytes_.empty()) {
    const bool status_is_read = out == 0x05 || out == 0x35 || out == 0x15;
    ignored_ = (asleep && out != 0xAB) || (is_busy && !status_is_read);
    bytes_.push_back(out);
    return 0xFF;
  }
  const std::uint8_t in = ignored_ ? std::uint8_t{0xFF} : answer();
  bytes_.push_back(out);
  return in;
}

std::uint8_t FakeW25q::answer() const {
  const std::size_t n = bytes_.size();
  switch (bytes_[0]) {
    case 0x05:
      return static_cast<std::uint8_t>(status[0] | (write_enabled_ ? 2U : 0U) |
                                       (always_busy || doing_ != Doing::nothing ? 1U : 0U));
    case 0x35: return status[1];
    case 0x15: return status[2];
    case 0x9F: return n <= 3 ? id[n - 1] : std::uint8_t{0};
    case 0x03:
      return n < 4 ? std::uint8_t{0xFF} : std::to_integer<std::uint8_t>(cells[(address() + n - 4) % cells.size()]);
    default: return 0xFF;
  }
}

void FakeW25q::deselected() {
  if (stuck_at || ignored_ || bytes_.empty()) {
    return;
  }
  obey();
}

void FakeW25q::obey() {
  const std::size_t n = bytes_.size();
  const bool was_volatile = std::exchange(volatile_enabled_, false);
  switch (bytes_[0]) {
    case 0x06: write_enabled_ = !ignores_write_enable; break;
    case 0x50: volatile_enabled_ = true; break;
    case 0xAB: asleep = false; break;
    case 0x01:
    case 0x31:
    case 0x11:
      if (n == 2 && was_volatile && !status_locked) {
        status[bytes_[0] == 0x01   ? 0
               : bytes_[0] == 0x31 ? 1
                                   : 2] = static_cast<std::uint8_t>(bytes_[0] == 0x01 ? bytes_[1] & 0xFCU : bytes_[1]);
      }
      break;
    case 0x02:
      if (write_enabled_ && n > 4 && !is_protected()) {
        page_.assign(page_size, std::byte{0xFF});
        for (std::size_t i = 4; i < n; ++i) {
          page_[(address() + i - 4) % page_size] = static_cast<std::byte>(bytes_[i]);
        }
        address_ = address() / page_size * page_size;
        begin(Doing::program);
      }
      break;
    case 0x20:
      if (write_enabled_ && n == 4 && !is_protected()) {
        address_ = address() / sector_size * sector_size;
        begin(Doing::erase);
      }
      break;
    default: break;
  }
}

void FakeW25q::begin(Doing what) {
  doing_ = what;
  (what == Doing::program ? programs : erases) += 1;
  done_at_ = clock_.time + (what == Doing::program ? program_time : erase_time);
}

void FakeW25q::finish() {
  const auto place = std::span{cells}.subspan(address_);
  if (doing_ == Doing::program) {
    const std::byte before = worn ? cells[worn->address] : std::byte{0};
    hal::sim::tear_program(place.first(page_size), page_, 1);
    if (worn) {
      cells[worn->address] |= before & worn->mask;
    }
  } else {
    hal::sim::tear_erase(place.first(sector_size), 1);
  }
  if (on_change) {
    on_change(address_, doing_ == Doing::program ? page_size : sector_size);
  }
  doing_ = Doing::nothing;
  write_enabled_ = false;
}

void FakeW25q::cut_power(std::uint64_t seed) {
  if (busy() && doing_ == Doing::program) {
    hal::sim::tear_program(std::span{cells}.subspan(address_, page_size), page_, seed);
  } else if (doing_ == Doing::erase) {
    hal::sim::tear_erase(std::span{cells}.subspan(address_, sector_size), seed);
  }
  doing_ = Doing::nothing;
  write_enabled_ = false;
  volatile_enabled_ = false;
  asleep = false;
}

}  // namespace fantail::hal::stm32f4::test
