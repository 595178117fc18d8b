// SPDX-License-Identifier: MIT
#include "hal/stm32f4/can_bus.hpp"

#include <algorithm>

#include "hal/stm32f4/can_bit_timing.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t mailboxes = 3;

// RFLM: what has arrived first is read first, and a frame that finds the FIFO full is the one that is lost.
constexpr std::uint32_t mode = can_mcr_txfp | can_mcr_rflm | can_mcr_abom | can_mcr_dbf;
constexpr std::uint32_t interrupts = can_ier_tmeie | can_ier_fmpie0 | can_ier_bofie | can_ier_lecie | can_ier_errie;

// The controller answers within some periods of its clock.
constexpr std::uint32_t looks_to_enter = 2'000;
// To leave it waits for 11 recessive bits, which even a full bus has behind each frame, so within 0.2 ms. A look takes
// two periods of the bus at least: 0.9 ms at 42 MHz.
constexpr std::uint32_t looks_to_leave = 20'000;
// Releasing a frame takes the controller some periods of its clock.
constexpr std::uint32_t looks_to_release = 16;

bool fits_can(const CanFrame& frame) {
  const std::uint32_t largest = frame.extended ? 0x1FFF'FFFFU : 0x7FFU;
  return frame.length <= frame.data.size() && frame.id <= largest;
}

std::uint32_t word(const CanFrame& frame, std::size_t first) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    bits |= static_cast<std::uint32_t>(frame.data[first + i]) << (8 * i);
  }
  return bits;
}

void put_word(CanFrame& frame, std::size_t first, std::uint32_t bits) {
  for (std::size_t i = 0; i < 4 && first + i < frame.length; ++i) {
    frame.data[first + i] = static_cast<std::uint8_t>(bits >> (8 * i) & 0xFFU);
  }
}

void load(CanMailbox& mailbox, const CanFrame& frame) {
  mailbox.length.write(frame.length);
  mailbox.data_low.write(word(frame, 0));
  mailbox.data_high.write(word(frame, 4));
  const std::uint32_t identifier =
      frame.extended ? frame.id << can_extended_place | can_identifier_ide : frame.id << can_standard_place;
  // Last: with the request the mailbox is the controller's.
  mailbox.identifier.write(identifier | (frame.remote ? can_identifier_rtr : 0U) | can_identifier_txrq);
}

CanFrame frame_in(const CanMailbox& mailbox) {
  const std::uint32_t identifier = mailbox.identifier.read();
  CanFrame frame;
  frame.extended = (identifier & can_identifier_ide) != 0;
  frame.remote = (identifier & can_identifier_rtr) != 0;
  frame.id = frame.extended ? identifier >> can_extended_place : identifier >> can_standard_place;
  // A length code above 8 is allowed on the bus and means 8.
  frame.length = static_cast<std::uint8_t>(std::min<std::uint32_t>(mailbox.length.read() & can_length_dlc, 8U));
  if (!frame.remote) {
    put_word(frame, 0, mailbox.data_low.read());
    put_word(frame, 4, mailbox.data_high.read());
  }
  return frame;
}

// For a counter that has one writer: no other may come between the load and the store.
void add_one(std::atomic<std::uint32_t>& count) {
  count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

}  // namespace

std::optional<BoardFault> CanBus::start(std::uint32_t apb1_hz, std::span<const std::uint16_t> identifiers) {
  silent_.high();
  const auto timing = can_bit_timing(apb1_hz);
  if (!timing || identifiers.size() > most_identifiers) {
    return BoardFault::can_failed;
  }
  can_.mcr.write(mode | can_mcr_inrq);  // and no longer asleep
  answers_ = wait_for(can_.msr, can_msr_inak, can_msr_inak, looks_to_enter);
  if (!answers_) {
    return BoardFault::can_failed;  // and its bit timing may only be written while it initialises
  }
  can_.btr.write(timing->bits());
  set_filters(identifiers);
  can_.ier.write(interrupts);
  silent_.low();
  can_.mcr.write(mode);
  const bool joined = wait_for(can_.msr, can_msr_inak, 0, looks_to_leave);
  return joined ? std::nullopt : std::optional{BoardFault::can_failed};
}

// Lists of four 16-bit identifiers; a remote or extended frame matches none. Places that are left repeat the last one.
void CanBus::set_filters(std::span<const std::uint16_t> identifiers) {
  const std::size_t banks = (identifiers.size() + 3) / 4;
  const std::uint32_t all_banks = (1U << banks) - 1U;
  can_.fmr.set(can_fmr_finit);
  can_.fa1r.write(0);
  can_.fs1r.write(0);
  can_.fm1r.write(all_banks);
  can_.ffa1r.write(0);
  const auto place = [&identifiers](std::size_t at) {
    const std::uint32_t identifier = identifiers[std::min(at, identifiers.size() - 1)];
    return identifier << can_filter_standard_place;
  };
  for (std::size_t bank = 0; bank < banks; ++bank) {
    can_.filter[bank][0].write(place(4 * bank) | place(4 * bank + 1) << 16U);
    can_.filter[bank][1].write(place(4 * bank + 2) | place(4 * bank + 3) << 16U);
  }
  can_.fa1r.write(all_banks);
  can_.fmr.clear(can_fmr_finit);
}

bool CanBus::send(const CanFrame& frame) {
  const CanState now = state();
  if (!fits_can(frame) || now == CanState::down || now == CanState::bus_off) {
    refused_ += 1;
    return false;
  }
  if (to_send_.full() && now == CanState::error_passive) {
    nobody_hears_.store(true, std::memory_order_relaxed);
    transmit_interrupt_.pend();
  }
  if (!to_send_.push(frame)) {
    refused_ += 1;
    return false;
  }
  // The mailboxes are the handler's alone.
  transmit_interrupt_.pend();
  return true;
}

std::optional<CanFrame> CanBus::receive() {
  if (answers_) {
    can_.ier.write(interrupts);  // the next error is counted again
  }
  const std::optional<CanFrame> frame = received_.pop();
  handed_out_ += frame ? 1U : 0U;
  return frame;
}

CanState CanBus::state() const {
  if (!answers_ || can_.msr.any(can_msr_inak)) {
    return CanState::down;
  }
  const std::uint32_t status = can_.esr.read();
  if ((status & can_esr_boff) != 0) {
    return CanState::bus_off;
  }
  if ((status & can_esr_epvf) != 0) {
    return CanState::error_passive;
  }
  return (status & can_esr_ewgf) != 0 ? CanState::error_warning : CanState::error_active;
}

CanCounters CanBus::counters() const {
  return {.sent = sent_.load(std::memory_order_relaxed),
          .received = handed_out_,
          .unsent = refused_ + given_up_.load(std::memory_order_relaxed),
          .overrun = overrun_.load(std::memory_order_relaxed),
          .errors = errors_.load(std::memory_order_relaxed)};
}

void CanBus::on_transmit_interrupt() {
  // One look for both: a frame that goes out in between would be loaded over, and a request clears RQCP uncounted.
  const std::uint32_t status = can_.tsr.read();
  count_finished_mailboxes(status);
  const bool off = can_.esr.any(can_esr_boff);
  off_ = off_ && off;
  if (nobody_hears_.load(std::memory_order_relaxed) || off) {
    nobody_hears_.store(false, std::memory_order_relaxed);
    give_up();
  }
  fill_mailboxes(status);
}

void CanBus::count_finished_mailboxes(std::uint32_t status) {
  std::uint32_t finished = 0;
  for (std::uint32_t i = 0; i < mailboxes; ++i) {
    const std::uint32_t place = i * can_tsr_bits_per_mailbox;
    if ((status >> place & can_tsr_rqcp) != 0) {
      add_one((status >> place & can_tsr_txok) != 0 ? sent_ : given_up_);
      finished |= can_tsr_rqcp << place;
    }
  }
  can_.tsr.write(finished);
}

// A mailbox whose frame is on the wire this moment ends that attempt first, and may yet succeed. Either way it is
// counted when it is empty.
void CanBus::give_up() {
  const std::uint32_t dropped = to_send_.drop_all();
  given_up_.store(given_up_.load(std::memory_order_relaxed) + dropped, std::memory_order_relaxed);
  std::uint32_t aborted = 0;
  for (std::uint32_t i = 0; i < mailboxes; ++i) {
    aborted |= can_tsr_abrq << (i * can_tsr_bits_per_mailbox);
  }
  can_.tsr.write(aborted);
}

void CanBus::fill_mailboxes(std::uint32_t status) {
  for (std::uint32_t i = 0; i < mailboxes; ++i) {
    if ((status & can_tsr_tme << i) != 0) {
      const std::optional<CanFrame> frame = to_send_.pop();
      if (!frame) {
        return;
      }
      load(can_.transmit[i], *frame);
    }
  }
}

void CanBus::on_receive_interrupt() {
  constexpr std::uint32_t most_frames = 3;
  if (can_.rf0r.any(can_rfr_fovr)) {
    add_one(overrun_);
    can_.rf0r.write(can_rfr_fovr);
  }
  for (std::uint32_t i = 0; i < most_frames && can_.rf0r.any(can_rfr_fmp); ++i) {
    if (!received_.push(frame_in(can_.receive[0]))) {
      add_one(overrun_);
    }
    can_.rf0r.write(can_rfr_rfom);
    // Until it is released the same frame would be read once more, now or by the next interrupt.
    if (!wait_for(can_.rf0r, can_rfr_rfom, 0, looks_to_release)) {
      return;
    }
  }
}

void CanBus::on_error_interrupt() {
  const std::uint32_t status = can_.esr.read();
  can_.msr.write(can_msr_erri);
  const std::uint32_t last_error = status & can_esr_lec;
  if (last_error != 0 && last_error != can_esr_lec) {
    add_one(errors_);
    can_.esr.write(can_esr_lec);
    // One a tick: a bus that is nothing but errors would interrupt 100 000 times a second.
    can_.ier.write(interrupts & ~can_ier_lecie);
  }
  const bool off = (status & can_esr_boff) != 0;
  if (off && !off_) {
    add_one(times_bus_off_);
    give_up();
  }
  off_ = off;
}

}  // namespace fantail::hal::stm32f4
