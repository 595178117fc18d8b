// SPDX-License-Identifier: MIT
#include "avionics/pad_ring.hpp"

namespace fantail::avionics {

void PadRing::begin(const core::Autopilot& law, const protocol::SampleTimes& times, const SampleScales& scales,
                    const core::CanardsPlan& canards) {
  law_ = law;
  times_ = times;
  scales_ = scales;
  canards_ = canards;
}

void PadRing::retire_oldest(TickQueue& queue) {
  if (const auto tick = protocol::unpack_tick(queue.time(), queue.tick(), times_)) {
    (void)law_->step(inputs_of(*tick, scales_, canards_));
  }
  queue.pop();
}

}  // namespace fantail::avionics
