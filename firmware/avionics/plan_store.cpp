// SPDX-License-Identifier: MIT
#include "avionics/plan_store.hpp"

#include <algorithm>

#include "avionics/sealed_words.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::avionics {
namespace {

constexpr std::size_t header_words = 3;
static_assert(sealed_size<header_words> <= smallest_page);

}  // namespace

std::optional<StoredPlan> PlanStore::load(core::Microseconds now) {
  StoredPlan out{};
  Access access = read_headers(now, out);
  const bool second_first = slots_[1] && (!slots_[0] || slots_[1]->sequence > slots_[0]->sequence);
  for (const std::size_t slot : {std::size_t{second_first ? 1U : 0U}, std::size_t{second_first ? 0U : 1U}}) {
    if (access == Access::done && slots_[slot] && !out.plan && !out.newer) {
      access = read_block(now, slot, out);
    }
  }
  if (access == Access::again) {
    return std::nullopt;
  }
  loaded_ = access == Access::done;
  return loaded_ ? out : StoredPlan{.flash_failed = true};
}

Access PlanStore::read_headers(core::Microseconds now, StoredPlan& out) {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    std::array<std::byte, sealed_size<header_words>> bytes{};
    const Access access = flash_.read(now, flash_.map().plan_slots[i], bytes);
    if (access != Access::done) {
      return access;
    }
    slots_[i].reset();
    const auto words = unseal<header_words>(bytes);
    if (words && (*words)[1] <= protocol::largest_plan_block) {
      slots_[i] = Slot{.sequence = (*words)[0], .size = (*words)[1], .block_crc = (*words)[2]};
      sequence_ = std::max(sequence_, slots_[i]->sequence);
    } else if (!erased(bytes)) {
      out.broken = true;
    }
  }
  return Access::done;
}

Access PlanStore::read_block(core::Microseconds now, std::size_t slot, StoredPlan& out) {
  std::array<std::byte, protocol::largest_plan_block> buffer{};
  const auto block = std::span{buffer}.first(slots_[slot]->size);
  const Access access = flash_.read(now, flash_.map().plan_slots[slot] + flash_.map().page_size, block);
  if (access != Access::done) {
    return access;
  }
  if (protocol::plan_block_crc(block) == slots_[slot]->block_crc) {
    const protocol::PlanBlockReading reading = protocol::read_plan_block(block);
    out.plan = reading.plan;
    // Meets PLN-2.
    // Whoever loaded it wanted no older one to be flown, and newer firmware can still read it: it is spared.
    out.newer = !reading.plan && reading.fault == protocol::PlanBlockFault::newer_version;
  }
  if (out.plan || out.newer) {
    out.block_crc = slots_[slot]->block_crc;
    in_force_ = slot;
  } else {
    out.broken = true;
  }
  return Access::done;
}

void PlanStore::begin_write(std::span<const std::byte> block) {
  if (write_ == PlanWrite::under_way) {
    return;
  }
  block_ = block;
  target_ = in_force_ == std::size_t{0} ? 1 : 0;
  step_ = Step::erase;
  at_ = 0;
  write_ = loaded_ ? PlanWrite::under_way : PlanWrite::flash_failed;
}

bool PlanStore::withdraw() {
  const bool untouched = write_ != PlanWrite::under_way || step_ == Step::erase;
  if (untouched) {
    write_ = PlanWrite::none;
  }
  return untouched;
}

bool PlanStore::done(Access access) {
  if (access == Access::failed) {
    write_ = PlanWrite::flash_failed;
  }
  return access == Access::done;
}

std::array<std::byte, 16> PlanStore::header() const {
  return seal<header_words>(
      {sequence_ + 1, static_cast<std::uint32_t>(block_.size()), protocol::plan_block_crc(block_)});
}

// Meets PLN-4.
void PlanStore::update(core::Microseconds now) {
  if (write_ != PlanWrite::under_way) {
    return;
  }
  const std::uint32_t slot = flash_.map().plan_slots[target_];
  const std::uint32_t block = slot + flash_.map().page_size;
  switch (step_) {
    case Step::erase:
      if (done(flash_.erase_sector(now, slot))) {
        step_ = Step::block;
      }
      break;
    case Step::block: program_page(now, block); break;
    case Step::check_block:
      check(now, block + static_cast<std::uint32_t>(at_),
            block_.subspan(at_, std::min(FlashAccess::read_size, block_.size() - at_)));
      break;
    case Step::header:
      if (done(flash_.program(now, slot, header()))) {
        step_ = Step::check_header;
      }
      break;
    case Step::check_header: check(now, slot, header()); break;
    case Step::make_void:
      if (done(flash_.erase_sector(now, slot))) {
        step_ = Step::check_void;
      }
      break;
    case Step::check_void: check_void(now, slot); break;
  }
}

void PlanStore::program_page(core::Microseconds now, std::uint32_t address) {
  const auto page = block_.subspan(at_, std::min<std::size_t>(flash_.map().page_size, block_.size() - at_));
  if (!done(flash_.program(now, address + static_cast<std::uint32_t>(at_), page))) {
    return;
  }
  at_ += page.size();
  if (at_ == block_.size()) {
    at_ = 0;
    step_ = Step::check_block;
  }
}

void PlanStore::check(core::Microseconds now, std::uint32_t address, std::span<const std::byte> expected) {
  std::array<std::byte, FlashAccess::read_size> buffer{};
  const auto bytes = std::span{buffer}.first(expected.size());
  if (!done(flash_.read(now, address, bytes))) {
    return;
  }
  if (!std::ranges::equal(bytes, expected)) {
    // Meets PLN-5.
    // It may be the reading that was wrong, and the slot as good as new: the next power-up would find it.
    step_ = Step::make_void;
  } else if (step_ == Step::check_header) {
    write_ = PlanWrite::stored;
    in_force_ = target_;
    sequence_ += 1;
  } else if (at_ += expected.size(); at_ == block_.size()) {
    step_ = Step::header;
  }
}

void PlanStore::check_void(core::Microseconds now, std::uint32_t slot) {
  std::array<std::byte, sealed_size<header_words>> bytes{};
  if (done(flash_.read(now, slot, bytes))) {
    write_ = unseal<header_words>(bytes) ? PlanWrite::flash_failed : PlanWrite::read_back_differs;
  }
}

}  // namespace fantail::avionics
