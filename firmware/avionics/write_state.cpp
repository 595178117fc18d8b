// SPDX-License-Identifier: MIT
#include "avionics/write_state.hpp"

namespace fantail::avionics {

std::size_t write_state(core::Autopilot& law, std::span<std::byte> out, protocol::StateExtent extent,
                        protocol::StatePart part) {
  protocol::StateWriter writer{out, extent, part};
  law.visit_state(writer);
  return writer.size();
}

}  // namespace fantail::avionics
