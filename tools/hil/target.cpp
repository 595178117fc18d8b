// SPDX-License-Identifier: MIT
#include "hil/target.hpp"

#include <array>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/tick_record_fields.hpp"
#include "protocol/hil_codec.hpp"
#include "protocol/plan_block.hpp"
#include "text/error.hpp"
#include "world_link/flash_call.hpp"

namespace fantail::hil {

using Clock = std::chrono::steady_clock;

protocol::LogFrame Link::ask(protocol::HilType type, std::size_t payload_size, core::Microseconds time) {
  sequence_ += 1;
  const auto question = out_.seal(type, sequence_, payload_size, time);
  wire_->write(question);
  const std::uint32_t damaged_before = damaged();
  std::optional<Clock::time_point> silent_since;
  for (;;) {
    while (const auto frame = in_.next()) {
      if (frame->head.sequence == sequence_) {  // else the answer to a question that was asked twice
        return *frame;
      }
    }
    const std::size_t count = wire_->read(in_.room(), timeouts_.send_again);
    in_.arrived(count);
    if (count != 0) {
      continue;
    }
    if (waiting_) {
      waiting_();
    }
    const auto now = Clock::now();
    silent_since = silent_since.value_or(now - timeouts_.send_again);
    if (now - *silent_since >= timeouts_.give_up) {
      give_up(damaged() - damaged_before);
    }
    asked_again_ += 1;
    wire_->write(question);
  }
}

void Link::give_up(std::uint32_t damaged_frames) const {
  const double seconds = 1e-3 * static_cast<double>(timeouts_.give_up.count());
  throw TargetError{
      damaged_frames == 0
          ? fmt::format("the flight computer has sent nothing for {:g} s", seconds)
          : fmt::format("frames from the flight computer arrive damaged, {} of them in {:g} s: does it use "
                        "another baud rate, or run another program?",
                        damaged_frames, seconds)};
}

using protocol::HilType;

Target::Target(std::unique_ptr<Wire> wire, Waiting waiting, const Timeouts& timeouts)
    : link_{std::move(wire), std::move(waiting), timeouts} {
  protocol::HilWriter writer{link_.payload()};
  const std::uint32_t layout = world_link::layout();
  writer(protocol::hil_version);
  writer(layout);
  const protocol::LogFrame answer = link_.ask(HilType::hello, writer.size());
  protocol::HilReader reader{answer.payload};
  std::uint16_t version = 0;
  std::uint32_t its_layout = 0;
  reader(version);
  reader(its_layout);
  identity_.image = reader.text();
  identity_.version = reader.text();
  identity_.git_hash = reader.text();
  reader(identity_.instructions);
  reader(identity_.counts);
  const bool understood = answer.head.type == static_cast<std::uint8_t>(HilType::ready) && reader.within();
  if (!understood || version != protocol::hil_version || its_layout != layout) {
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("the flight computer ({} {}, {}) uses version {} of the link with layout {:08x}, but this program "
                    "uses version {} with layout {:08x}. Build and load its image again from the same sources",
                    identity_.image, identity_.version, identity_.git_hash, version, its_layout, protocol::hil_version,
                    layout)};
  }
}

sim::MakeFlightComputer Target::maker() {
  return [this](const core::FlightPlan& plan, const sim::BoardPorts& ports, const avionics::Identity& identity) {
    return std::make_unique<RemoteBoard>(*this, plan, ports, identity);
  };
}

using protocol::HilReader;
using protocol::HilType;
using protocol::HilWriter;
using protocol::LogFrame;
using world_link::FlashCall;

namespace {

void expect(bool understood, const char* otherwise = "the flight computer sent a message that cannot be read") {
  if (!understood) {
    throw TargetError{otherwise};
  }
}

}  // namespace

const core::TickRecord& RemoteBoard::tick() {
  if (!std::exchange(begun_, true)) {
    begin();
  }
  frames_.clear();
  while (const auto frame = ports_.can_bus.receive()) {
    frames_.push_back(*frame);
  }
  HilWriter writer{target_.link_.payload()};
  world_link::visit_inputs(hardware_, writer);
  writer(ports_.entropy.draw());
  writer(ports_.can_bus.state());
  writer(static_cast<std::uint8_t>(frames_.size()));
  for (const hal::CanFrame& frame : frames_) {
    world_link::visit_frame(frame, writer);
  }
  expect(writer.ok() && frames_.size() < 256, "more CAN frames came in one tick than the link can carry");

  const LogFrame done = ask(HilType::tick, writer.size(), HilType::done);
  HilReader reader{done.payload};
  protocol::visit_record(record_, reader);
  world_link::visit_outputs(hardware_, reader);
  world_link::visit_times(target_.times_, reader);
  if (const auto text = reader.text(); !text.empty()) {
    ports_.console.write(text);
  }
  for (bool more = false; reader(more), more;) {
    hal::CanFrame frame;
    world_link::visit_frame(frame, reader);
    (void)ports_.can_bus.send(frame);
  }
  expect(reader.ok() &&
         (!hardware_.restarted_by || static_cast<std::size_t>(*hardware_.restarted_by) < hal::reset_causes));
  return record_;
}

core::Microseconds RemoteBoard::restart(const sim::Reset& /*reset*/) {
  throw TargetError{"the simulator cannot reset a flight computer that runs outside of it"};
}

void RemoteBoard::begin() {
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(plan_, block);
  HilWriter writer{target_.link_.payload()};
  writer.bytes(std::span{block}.first(size));
  const hal::FlashGeometry geometry = ports_.flash.geometry();
  world_link::visit_geometry(geometry, writer);
  world_link::visit_scales(hardware_, writer);
  writer.text(vehicle_);
  writer.text(sensors_);
  expect(writer.ok(), "the plan and the names are longer than the link can carry");
  (void)ask(HilType::begin, writer.size(), HilType::begun);
}

LogFrame RemoteBoard::ask(HilType question, std::size_t size, HilType wanted) {
  LogFrame answer = target_.link_.ask(question, size, hardware_.time);
  while (answer.head.type == static_cast<std::uint8_t>(HilType::flash_request)) {
    answer = target_.link_.ask(HilType::flash_answer, do_as_asked(answer.payload), hardware_.time);
  }
  if (answer.head.type == static_cast<std::uint8_t>(HilType::refused)) {
    HilReader reader{answer.payload};
    throw TargetError{"the flight computer refused: " + std::string{reader.text()}};
  }
  expect(answer.head.type == static_cast<std::uint8_t>(wanted));
  return answer;
}

std::size_t RemoteBoard::do_as_asked(std::span<const std::byte> flash_request) {
  HilReader reader{flash_request};
  FlashCall call{};
  std::uint32_t address = 0;
  std::uint32_t room = 0;
  reader(call);
  reader(address);
  reader(room);
  const auto bytes = reader.bytes();
  expect(reader.ok() && room <= protocol::largest_hil_payload / 2);
  read_.assign(room, std::byte{0});
  hal::FlashResult result{};
  switch (call) {
    case FlashCall::read: result = ports_.flash.read(address, read_); break;
    case FlashCall::program: result = ports_.flash.program(address, bytes); break;
    case FlashCall::erase: result = ports_.flash.erase_sector(address); break;
    case FlashCall::busy: result = ports_.flash.busy() ? hal::FlashResult::busy : hal::FlashResult::ok; break;
    default: expect(false);
  }
  HilWriter writer{target_.link_.payload()};
  writer(result);
  writer.bytes(read_);
  return writer.size();
}

}  // namespace fantail::hil
