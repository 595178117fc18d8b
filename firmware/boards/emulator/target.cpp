// SPDX-License-Identifier: MIT
#include "boards/emulator/target.hpp"

#include <algorithm>

#include "avionics/identity.hpp"
#include "core/tick_record_fields.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::boards::emulator {
namespace {

using protocol::HilReader;
using protocol::HilType;
using protocol::HilWriter;

// The text outlives the message that it came with.
std::string_view keep(std::string_view text, std::array<char, 32>& place) {
  const std::size_t count = std::min(text.size(), place.size());
  std::copy_n(text.begin(), count, place.begin());
  return {place.data(), count};
}

}  // namespace

Target::Target(hal::emulator::Channel& channel, hal::emulator::Stopwatch& stopwatch, std::string_view name,
               const Measured& measured)
    : stopwatch_{stopwatch}, name_{name}, measured_{measured}, link_{channel}, flash_{link_, stopwatch} {}

void Target::serve(std::uint32_t late) {
  const protocol::LogFrame question = link_.receive();
  switch (static_cast<HilType>(question.head.type)) {
    case HilType::hello: present(); break;
    case HilType::begin: begin(question.payload); break;
    case HilType::tick:
      overruns_ += ticked_ ? late : 0;
      tick(question.payload);
      break;
    default: refuse("this is not a request"); break;
  }
}

void Target::present() {
  HilWriter writer{link_.payload()};
  writer(protocol::hil_version);
  const std::uint32_t layout = world_link::layout();
  writer(layout);
  writer.text(name_);
  writer.text(avionics::firmware_version());
  writer.text(avionics::git_hash());
  writer(measured_.instructions);
  writer(measured_.counts);
  link_.answer(HilType::ready, writer.size());
}

void Target::begin(std::span<const std::byte> payload) {
  HilReader reader{payload};
  const auto plan = protocol::read_plan_block(reader.bytes());
  hal::FlashGeometry geometry;
  world_link::visit_geometry(geometry, reader);
  devices_.world = {};
  world_link::visit_scales(devices_.world, reader);
  const std::string_view vehicle = keep(reader.text(), vehicle_);
  const std::string_view sensors = keep(reader.text(), sensors_);
  if (!reader.ok() || !plan.plan) {
    refuse(reader.ok() ? "this is not a flight plan" : "this is not a valid message");
    return;
  }
  devices_.arm_switch.power_up();
  devices_.abort_contact.power_up();
  flash_.set_geometry(geometry);
  console_.clear();
  avionics_.reset();
  can_bus_.emplace(wire_);
  world_bus_.emplace(wire_);
  ticked_ = false;
  overruns_ = 0;
  avionics_.emplace(avionics::Devices{.clock = devices_.clock,
                                      .imu = devices_.imu,
                                      .accelerometer = devices_.accelerometer,
                                      .servo = devices_.servo,
                                      .encoder = devices_.encoder,
                                      .arm_switch = devices_.arm_switch,
                                      .abort_contact = devices_.abort_contact,
                                      .can_bus = *can_bus_,
                                      .flash = flash_,
                                      .console = console_,
                                      .watchdog = devices_.watchdog,
                                      .entropy = entropy_,
                                      .board = devices_.board,
                                      .backup_memory = backup_memory_,
                                      .second_imu = &devices_.second_imu,
                                      .barometer = &devices_.barometer},
                    *plan.plan,
                    avionics::Identity{.firmware_version = avionics::firmware_version(),
                                       .git_hash = avionics::git_hash(),
                                       .vehicle = vehicle,
                                       .sensors = sensors});
  link_.answer(HilType::begun, 0);
}

void Target::tick(std::span<const std::byte> payload) {
  HilReader reader{payload};
  world_link::visit_inputs(devices_.world, reader);
  std::uint32_t random = 0;
  reader(random);
  entropy_.set(random);
  if (!avionics_) {
    refuse("no flight was started");
    return;
  }
  take_frames(reader);
  if (!reader.ok()) {
    refuse("this is not a valid message");
    return;
  }
  ticked_ = true;
  devices_.arm_switch.update();
  devices_.abort_contact.update();
  stopwatch_.begin();
  const core::TickRecord& record = avionics_->tick();
  const world_link::TickTimes times{
      .tick = stopwatch_.end(), .step = measured_.step != nullptr ? *measured_.step : 0, .overruns = overruns_};
  HilWriter writer{link_.payload()};
  protocol::visit_record(record, writer);
  world_link::visit_outputs(devices_.world, writer);
  world_link::visit_times(times, writer);
  writer.text(console_.text());
  console_.clear();
  give_frames(writer);
  link_.answer(HilType::done, writer.size(), devices_.world.time);
}

void Target::refuse(std::string_view why) {
  HilWriter writer{link_.payload()};
  writer.text(why);
  link_.answer(HilType::refused, writer.size());
}

void Target::take_frames(HilReader& reader) {
  hal::CanState state{};
  reader(state);
  std::uint8_t count = 0;
  reader(count);
  // The others on the bus sent them before it changed, if it did.
  wire_.set_state(hal::CanState::error_active);
  for (std::uint8_t i = 0; i < count && reader.within(); ++i) {
    hal::CanFrame frame;
    world_link::visit_frame(frame, reader);
    world_bus_->send(frame);
  }
  wire_.set_state(state);
}

void Target::give_frames(HilWriter& writer) {
  while (const auto frame = world_bus_->receive()) {
    writer(true);
    world_link::visit_frame(*frame, writer);
  }
  writer(false);
}

}  // namespace fantail::boards::emulator
