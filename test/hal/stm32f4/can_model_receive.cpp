// SPDX-License-Identifier: MIT
// The side of the model that hears: filters and FIFO.
#include "can_model.hpp"

namespace fantail::hal::stm32f4::test {

using namespace registers;

namespace {

// As the controller keeps a frame; also how a filter sees it.
std::uint32_t identifier_bits(const CanFrame& frame) {
  const std::uint32_t identifier =
      frame.extended ? frame.id << can_extended_place | can_identifier_ide : frame.id << can_standard_place;
  return identifier | (frame.remote ? can_identifier_rtr : 0U);
}

std::uint32_t data_word(const CanFrame& frame, std::size_t first) {
  std::uint32_t bits = 0xA5A5'A5A5;  // beyond the length there is what was there before
  for (std::size_t i = 0; i < 4 && first + i < frame.length; ++i) {
    bits &= ~(0xFFU << 8 * i);
    bits |= static_cast<std::uint32_t>(frame.data[first + i]) << 8 * i;
  }
  return bits;
}

}  // namespace

void CanModel::install_fifo() {
  world_.on_read(can_.rf0r, [this] {
    happen();
    if (reads_to_release_ > 0 && --reads_to_release_ == 0) {
      fifo_.pop_front();
      show_oldest();
    }
    return static_cast<std::uint32_t>(fifo_.size()) | (fovr_ ? can_rfr_fovr : 0U) |
           (reads_to_release_ > 0 ? can_rfr_rfom : 0U);
  });
  world_.on_write(can_.rf0r, [this](std::uint32_t value) {
    fovr_ = fovr_ && (value & can_rfr_fovr) == 0;
    if ((value & can_rfr_rfom) != 0 && !fifo_.empty()) {
      mistakes += reads_to_release_ > 0 ? 1 : 0;
      reads_to_release_ = reads_to_release_ > 0 ? reads_to_release_ : 4;
    }
  });
}

void CanModel::show_oldest() {
  if (!fifo_.empty()) {
    const CanFrame& frame = fifo_.front();
    CanMailbox& place = can_.receive[0];
    RegisterWorld::poke(place.identifier, identifier_bits(frame));
    RegisterWorld::poke(place.length, frame.length);
    RegisterWorld::poke(place.data_low, data_word(frame, 0));
    RegisterWorld::poke(place.data_high, data_word(frame, 4));
  }
}

bool CanModel::arrive(const CanFrame& frame) {
  if (!on_bus() || !passes(frame)) {
    return false;
  }
  if (fifo_.size() == 3) {
    fovr_ = true;
    if ((mcr_ & can_mcr_rflm) == 0) {
      fifo_.back() = frame;
    }
  } else {
    fifo_.push_back(frame);
    show_oldest();
  }
  serve();
  return true;
}

void CanModel::install_filters() {
  world_.on_write(can_.fmr, [this](std::uint32_t value) { finit_ = (value & can_fmr_finit) != 0; });
  world_.on_read(can_.fmr, [this] { return finit_ ? can_fmr_finit : 0U; });
  world_.on_write(can_.fa1r, [this](std::uint32_t value) { active_ = value; });
  for (Register* kind : {&can_.fm1r, &can_.fs1r, &can_.ffa1r}) {
    world_.on_write(*kind, [this, kind](std::uint32_t value) {
      mistakes += finit_ ? 0 : 1;
      RegisterWorld::poke(*kind, value);
    });
  }
  for (std::uint32_t bank = 0; bank < 28; ++bank) {
    for (Register& half : can_.filter[bank]) {
      world_.on_write(half, [this, bank, &half](std::uint32_t value) {
        mistakes += finit_ || (active_ >> bank & 1U) == 0 ? 0 : 1;
        RegisterWorld::poke(half, value);
      });
    }
  }
}

// The only kind that the driver uses: lists of 16-bit identifiers for FIFO 0.
bool CanModel::passes(const CanFrame& frame) const {
  const std::uint32_t bits = identifier_bits(frame);
  const std::uint32_t seen = (bits >> 16U & 0xFFE0U) | (bits & can_identifier_rtr ? 0x10U : 0U) |
                             (bits & can_identifier_ide ? 0x08U : 0U) | (bits >> 18U & 7U);
  for (std::uint32_t bank = 0; bank < 28 && !finit_; ++bank) {
    const std::uint32_t mask = 1U << bank;
    const bool is_list = (RegisterWorld::peek(can_.fm1r) & mask) != 0 && (RegisterWorld::peek(can_.fs1r) & mask) == 0 &&
                         (RegisterWorld::peek(can_.ffa1r) & mask) == 0;
    for (const Register& half : can_.filter[bank]) {
      const std::uint32_t two = RegisterWorld::peek(half);
      if ((active_ & mask) != 0 && is_list && (seen == (two & 0xFFFFU) || seen == two >> 16U)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace fantail::hal::stm32f4::test
