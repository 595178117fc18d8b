// SPDX-License-Identifier: MIT
#include "board_server.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/tick_record_fields.hpp"
#include "protocol/plan_block.hpp"
#include "text/error.hpp"
#include "world_link/exchange.hpp"

namespace fantail::board {
namespace {

using protocol::HilReader;
using protocol::HilType;
using protocol::HilWriter;

constexpr std::string_view name_of_image = "fantail-stm32f405";

}  // namespace

BoardServer::BoardServer(const Image& image, const Pace& pace, hal::emulator::Channel& channel)
    : image_{image}, pace_{pace}, identity_{identity_of(image, pace)}, link_{channel}, flash_{link_, cycles_} {}

void BoardServer::serve() {
  const protocol::LogFrame question = link_.receive();
  switch (static_cast<HilType>(question.head.type)) {
    case HilType::hello: present(); break;
    case HilType::begin: begin(question.payload); break;
    case HilType::tick: tick(question.payload); break;
    default: refuse("this is not a request"); break;
  }
}

void BoardServer::present() {
  HilWriter writer{link_.payload()};
  writer(protocol::hil_version);
  const std::uint32_t layout = world_link::layout();
  writer(layout);
  writer.text(name_of_image);
  writer.text(fmt::format("{} at {} cycles an instruction", identity_.version, pace_.cycles_per_instruction));
  writer.text(identity_.git_hash);
  writer(std::uint32_t{0});
  writer(std::uint32_t{0});
  link_.answer(HilType::ready, writer.size());
}

void BoardServer::begin(std::span<const std::byte> payload) {
  HilReader reader{payload};
  const auto plan = protocol::read_plan_block(reader.bytes());
  hal::FlashGeometry geometry;
  world_link::visit_geometry(geometry, reader);
  hal::sim::WorldSide scales{};
  world_link::visit_scales(scales, reader);
  (void)reader.text();  // the vehicle: nobody tells a board what it is in
  (void)reader.text();
  if (!reader.ok() || !plan.plan) {
    refuse(reader.ok() ? "this is not a flight plan" : "this is not a valid message");
    return;
  }
  flash_.set_geometry(geometry);
  said_.clear();
  console_.clear();
  flown_ = std::make_unique<BoardInWorld>(
      image_, pace_, *plan.plan,
      sim::BoardPorts{.can_bus = boards_node_, .flash = flash_, .console = console_, .entropy = entropy_});
  flown_->hardware() = scales;
  link_.answer(HilType::begun, 0);
}

void BoardServer::tick(std::span<const std::byte> payload) {
  if (!flown_) {
    refuse("no flight was started");
    return;
  }
  HilReader reader{payload};
  hal::sim::WorldSide& hardware = flown_->hardware();
  world_link::visit_inputs(hardware, reader);
  std::uint32_t random = 0;
  reader(random);
  exchange(reader);
  if (!reader.ok()) {
    refuse("this is not a valid message");
    return;
  }
  const core::TickRecord record = flown_->tick();
  HilWriter writer{link_.payload()};
  protocol::visit_record(record, writer);
  world_link::visit_outputs(hardware, writer);
  const world_link::TickTimes times{};
  world_link::visit_times(times, writer);
  writer.text(console_.text());
  said_ += console_.text();
  console_.clear();
  while (const auto frame = worlds_node_.receive()) {
    writer(true);
    world_link::visit_frame(*frame, writer);
  }
  writer(false);
  link_.answer(HilType::done, writer.size(), hardware.time);
}

void BoardServer::exchange(HilReader& reader) {
  hal::CanState state{};
  reader(state);
  std::uint8_t count = 0;
  reader(count);
  for (std::uint8_t i = 0; i < count && reader.within(); ++i) {
    hal::CanFrame frame;
    world_link::visit_frame(frame, reader);
    (void)worlds_node_.send(frame);
  }
}

void BoardServer::refuse(std::string_view why) {
  HilWriter writer{link_.payload()};
  writer.text(why);
  link_.answer(HilType::refused, writer.size());
}

}  // namespace fantail::board
