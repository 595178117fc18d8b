// SPDX-License-Identifier: MIT
#include "world_link/exchange.hpp"

#include "protocol/hil_codec.hpp"

namespace fantail::world_link {

std::uint32_t layout() {
  protocol::HilLayout layout;
  const hal::sim::WorldSide world{};
  visit_scales(world, layout);
  visit_inputs(world, layout);
  visit_second_imu(world, layout);
  visit_barometer(world, layout);
  visit_outputs(world, layout);
  const hal::CanFrame frame{};
  visit_frame(frame, layout);
  const hal::FlashGeometry geometry{};
  visit_geometry(geometry, layout);
  const TickTimes times{};
  visit_times(times, layout);
  return layout.hash() ^ protocol::record_layout();
}

}  // namespace fantail::world_link
