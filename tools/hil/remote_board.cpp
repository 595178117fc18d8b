// SPDX-License-Identifier: MIT
#include "hil/remote_board.hpp"

#include <array>
#include <utility>

#include "core/tick_record_fields.hpp"
#include "protocol/hil_codec.hpp"
#include "protocol/plan_block.hpp"
#include "world_link/flash_call.hpp"

namespace fantail::hil {

using protocol::HilReader;
using protocol::HilType;
using protocol::HilWriter;
using protocol::LogFrame;
using world_link::FlashCall;

namespace {

void expect(bool understood) {
  if (!understood) {
    throw TargetError{"the flight computer's message is not one"};
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
  expect(writer.ok() && frames_.size() < 256);

  const LogFrame done = ask(HilType::tick, writer.size(), HilType::done);
  HilReader reader{done.payload};
  core::visit_signals(record_, reader);
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
  expect(reader.ok());
  return record_;
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
  expect(writer.ok());
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
