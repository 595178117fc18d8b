// SPDX-License-Identifier: MIT
#include "hil/target.hpp"

#include <fmt/core.h>

#include "hil/remote_board.hpp"
#include "protocol/hil_codec.hpp"
#include "text/error.hpp"

namespace fantail::hil {

using protocol::HilType;

Target::Target(std::unique_ptr<Wire> wire, Waiting waiting, const Patience& patience)
    : link_{std::move(wire), std::move(waiting), patience} {
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
        fmt::format(
            "the flight computer ({} {}, {}) speaks version {} of the link with layout {:08x}, and this program "
            "version {} with layout {:08x}: build and load its image again, from the same sources",
            identity_.image, identity_.version, identity_.git_hash, version, its_layout, protocol::hil_version,
            layout)};
  }
}

sim::MakeFlightComputer Target::maker() {
  return [this](const core::FlightPlan& plan, const sim::BoardPorts& ports, const avionics::Identity& identity) {
    return std::make_unique<RemoteBoard>(*this, plan, ports, identity);
  };
}

}  // namespace fantail::hil
