// SPDX-License-Identifier: MIT
#include "switched_board.hpp"

#include <utility>

#include "text/error.hpp"

namespace fantail::board {

SwitchedBoard::SwitchedBoard(const Image& image, std::vector<std::byte> flash, const sim::BoardPorts& ports)
    : image_{image}, flash_{std::move(flash)}, ports_{ports} {}

void SwitchedBoard::switch_on() {
  if (!powered_) {
    powered_ = std::make_unique<BoardInWorld>(image_, Pace{}, std::move(flash_), ports_);
  }
}

void SwitchedBoard::switch_off() {
  if (!powered_) {
    return;
  }
  devices::FakeW25q& flash = powered_->board().flash;
  flash.cut_power(powered_->board().timeline.counts());  // how far it came is chance
  flash_ = std::move(flash.cells);
  powered_.reset();
  record_ = {};
  hardware_.pulses = {};
  hardware_.had_tick = true;  // of the next one that is switched on
}

const core::TickRecord& SwitchedBoard::tick() {
  if (!powered_) {
    while (ports_.can_bus.receive()) {  // nobody is there
    }
    return record_;
  }
  powered_->hardware() = hardware_;
  record_ = powered_->tick();
  powered_->board().traffic.clear();  // it may run for days
  hardware_.pulses = powered_->hardware().pulses;
  hardware_.had_tick = powered_->hardware().had_tick;
  return record_;
}

core::Microseconds SwitchedBoard::restart(const sim::Reset& /*reset*/) {
  throw text::Error{text::ErrorKind::bad_configuration, "faults.kind = \"reset\" cannot be run here: type reset"};
}

}  // namespace fantail::board
