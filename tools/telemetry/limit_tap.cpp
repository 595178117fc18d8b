// SPDX-License-Identifier: MIT
#include "telemetry/limit_tap.hpp"

#include "avionics/can_frame.hpp"

namespace fantail::telemetry {

bool LimitTap::send(const hal::CanFrame& frame) {
  const auto decoded = protocol::decode_from_avionics(avionics::bus_frame(frame));
  if (decoded.message) {
    if (const auto* limits = std::get_if<protocol::LimitReport>(&*decoded.message)) {
      for (std::size_t i = 0; i < limits_rad_.size(); ++i) {
        limits_rad_[i] = static_cast<double>(limits->limit[i].radians());
      }
    }
  }
  return bus_.send(frame);
}

}  // namespace fantail::telemetry
