// SPDX-License-Identifier: MIT
#include "avionics/write_state.hpp"

namespace fantail::avionics {

std::uint32_t state_layout(core::Autopilot& law) {
  protocol::StateLayout layout;
  law.visit_state(layout);
  return layout.hash();
}

}  // namespace fantail::avionics
