// SPDX-License-Identifier: MIT
#include "hal/emulator/world_link.hpp"

#include "protocol/hil_codec.hpp"

namespace fantail::hal::emulator {

std::uint32_t layout() {
  protocol::HilLayout layout;
  const sim::WorldSide world{};
  visit_scales(world, layout);
  visit_inputs(world, layout);
  visit_outputs(world, layout);
  const CanFrame frame{};
  visit_frame(frame, layout);
  const FlashGeometry geometry{};
  visit_geometry(geometry, layout);
  const TickTimes times{};
  visit_times(times, layout);
  return layout.hash() ^ protocol::record_layout();
}

}  // namespace fantail::hal::emulator
