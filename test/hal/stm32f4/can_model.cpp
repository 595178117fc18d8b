// SPDX-License-Identifier: MIT
#include "can_model.hpp"

#include <algorithm>
#include <utility>

namespace fantail::hal::stm32f4::test {

using namespace registers;

CanModel::CanModel(RegisterWorld& world, Can& can) : world_{world}, can_{can} {
  install_control();
  install_mailboxes();
  install_fifo();
  install_filters();
}

void CanModel::connect(Handlers handlers, Register& set_pending) {
  handlers_ = std::move(handlers);
  world_.on_write(set_pending, [this](std::uint32_t value) {
    mistakes += value == 1U << 19U ? 0 : 1;  // CAN1_TX, RM0090 table 62
    pended_ = true;
    serve();
  });
}

bool CanModel::transmit_line() const {
  return (ier_ & can_ier_tmeie) != 0 &&
         std::ranges::any_of(mailboxes_, [](const Mailbox& box) { return box.flags != 0; });
}
bool CanModel::receive_line() const { return !fifo_.empty() && (ier_ & can_ier_fmpie0) != 0; }
bool CanModel::error_line() const { return erri_ && (ier_ & can_ier_errie) != 0; }

void CanModel::happen() {
  if (meanwhile && !happening_) {
    happening_ = true;
    meanwhile();
    happening_ = false;
  }
}

void CanModel::install_control() {
  world_.on_write(can_.mcr, [this](std::uint32_t value) {
    mcr_ = value;
    reads_to_inak_ = 3;
  });
  world_.on_read(can_.mcr, [this] { return mcr_; });
  world_.on_read(can_.msr, [this] {
    happen();
    const bool wants = (mcr_ & can_mcr_inrq) != 0;
    if (!dead && wants != inak_ && (wants || !stuck_bus) && --reads_to_inak_ <= 0) {
      inak_ = wants;
    }
    return (inak_ ? can_msr_inak : 0U) | (erri_ ? can_msr_erri : 0U);
  });
  world_.on_write(can_.msr, [this](std::uint32_t value) { erri_ = erri_ && (value & can_msr_erri) == 0; });
  world_.on_write(can_.ier, [this](std::uint32_t value) {
    ier_ = value;
    serve();
  });
  world_.on_read(can_.ier, [this] { return ier_; });
  world_.on_read(can_.esr, [this] {
    happen();
    return esr();
  });
  world_.on_write(can_.esr, [this](std::uint32_t value) { lec_ = (value & can_esr_lec) >> 4U; });
  world_.on_write(can_.btr, [this](std::uint32_t value) {
    mistakes += inak_ ? 0 : 1;
    btr_ = inak_ ? value : btr_;
  });
}

std::uint32_t CanModel::esr() const {
  const bool warns = tec_ >= 96 || rec_ >= 96;
  const bool passive = tec_ >= 128 || rec_ >= 128;
  return (warns ? can_esr_ewgf : 0U) | (passive ? can_esr_epvf : 0U) | (boff_ ? can_esr_boff : 0U) | lec_ << 4U |
         (tec_ & 0xFFU) << 16U | rec_ << 24U;
}

void CanModel::install_mailboxes() {
  world_.on_read(can_.tsr, [this] {
    const std::uint32_t seen = tsr();
    happen();  // after the look: this is the dangerous moment
    return seen;
  });
  world_.on_write(can_.tsr, [this](std::uint32_t value) { write_tsr(value); });
  for (std::size_t i = 0; i < mailboxes_.size(); ++i) {
    world_.on_write(can_.transmit[i].identifier, [this, i](std::uint32_t value) { request(i, value); });
    for (Register* content : {&can_.transmit[i].length, &can_.transmit[i].data_low, &can_.transmit[i].data_high}) {
      world_.on_write(*content, [this, i, content](std::uint32_t value) {
        mistakes += mailboxes_[i].pending ? 1 : 0;
        RegisterWorld::poke(*content, value);
      });
    }
  }
}

std::uint32_t CanModel::tsr() const {
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < mailboxes_.size(); ++i) {
    bits |= mailboxes_[i].flags << 8 * i;
    bits |= mailboxes_[i].pending ? 0U : can_tsr_tme << i;
  }
  return bits;
}

void CanModel::write_tsr(std::uint32_t value) {
  for (std::size_t i = 0; i < mailboxes_.size(); ++i) {
    const std::uint32_t bits = value >> 8 * i;
    if ((bits & can_tsr_rqcp) != 0) {
      mailboxes_[i].flags = 0;
    }
    if ((bits & can_tsr_abrq) != 0 && mailboxes_[i].pending) {
      // The one that is next may be on the wire this moment.
      if (on_bus() && next_mailbox() == i) {
        mailboxes_[i].abort = true;
      } else {
        finish(i, false);
      }
    }
  }
  serve();
}

void CanModel::request(std::size_t mailbox, std::uint32_t identifier) {
  Mailbox& box = mailboxes_[mailbox];
  mistakes += box.pending || (identifier & can_identifier_txrq) == 0 ? 1 : 0;
  mistakes += (box.flags & can_tsr_rqcp) != 0 ? 1 : 0;  // cleared without having been looked at
  box = {.pending = true, .order = requests_++, .identifier = identifier};
}

void CanModel::finish(std::size_t mailbox, bool sent) {
  mailboxes_[mailbox].pending = mailboxes_[mailbox].abort = false;
  mailboxes_[mailbox].flags = can_tsr_rqcp | (sent ? can_tsr_txok : 0U);
}

int CanModel::pending_mailboxes() const {
  return static_cast<int>(std::ranges::count(mailboxes_, true, &Mailbox::pending));
}

// By identifier, of equal ones the lower mailbox; with TXFP in the order of the requests. Section 32.7.1.
std::optional<std::size_t> CanModel::next_mailbox() const {
  std::optional<std::size_t> next;
  for (std::size_t i = 0; i < mailboxes_.size(); ++i) {
    const bool by_order = (mcr_ & can_mcr_txfp) != 0;
    const auto rank = [by_order](const Mailbox& box) { return by_order ? box.order : box.identifier; };
    if (mailboxes_[i].pending && (!next || rank(mailboxes_[i]) < rank(mailboxes_[*next]))) {
      next = i;
    }
  }
  return next;
}

CanFrame CanModel::frame_of(std::size_t mailbox) const {
  const std::uint32_t bits = mailboxes_[mailbox].identifier;
  CanFrame frame;
  frame.extended = (bits & can_identifier_ide) != 0;
  frame.remote = (bits & can_identifier_rtr) != 0;
  frame.id = frame.extended ? bits >> can_extended_place : bits >> can_standard_place;
  frame.length = static_cast<std::uint8_t>(RegisterWorld::peek(can_.transmit[mailbox].length) & can_length_dlc);
  for (std::size_t i = 0; i < 8 && i < frame.length; ++i) {
    const Register& word = i < 4 ? can_.transmit[mailbox].data_low : can_.transmit[mailbox].data_high;
    frame.data[i] = static_cast<std::uint8_t>(RegisterWorld::peek(word) >> 8 * (i % 4) & 0xFFU);
  }
  return frame;
}

bool CanModel::slot() {
  const auto next = on_bus() ? next_mailbox() : std::nullopt;
  if (!next) {
    return false;
  }
  if (heard) {
    wire.push_back(frame_of(*next));
    tec_ -= tec_ > 0 ? 1U : 0U;
    lec_ = 0;
    finish(*next, true);
  } else {
    // An error passive node that hears no acknowledgement does not count it (ISO 11898-1, exception 1 of rule c).
    tec_ = tec_ >= 128 ? tec_ : tec_ + 8;
    if (mailboxes_[*next].abort || (mcr_ & can_mcr_nart) != 0) {
      finish(*next, false);
    }
    disturb(3);
  }
  serve();
  return heard;
}

void CanModel::run(int slots) {
  for (int i = 0; i < slots; ++i) {
    (void)slot();
  }
}

void CanModel::disturb(std::uint32_t code) {
  lec_ = code;
  erri_ = erri_ || (ier_ & can_ier_lecie) != 0;
  serve();
}

void CanModel::set_errors(std::uint32_t transmit, std::uint32_t receive) {
  tec_ = transmit;
  rec_ = receive;
}

void CanModel::go_bus_off() {
  boff_ = true;
  sequences_ = 0;
  erri_ = erri_ || (ier_ & can_ier_bofie) != 0;
  serve();
}

void CanModel::recessive(int sequences) {
  sequences_ += sequences;
  if (boff_ && sequences_ >= 128 && (mcr_ & can_mcr_abom) != 0) {
    boff_ = false;
    tec_ = rec_ = 0;
  }
}

void CanModel::serve() {
  if (!handlers_ || serving_ || masked) {
    return;
  }
  serving_ = true;
  for (int i = 0; i < 1000; ++i) {
    if (pended_ || transmit_line()) {
      pended_ = false;
      handlers_->transmit();
    } else if (receive_line()) {
      handlers_->receive();
    } else if (error_line()) {
      handlers_->error();
    } else {
      serving_ = false;
      return;
    }
    interrupts += 1;
  }
  serving_ = false;
  mistakes += 1;  // an interrupt that nobody ends
}

}  // namespace fantail::hal::stm32f4::test
