// SPDX-License-Identifier: MIT
#pragma once

#include "core/flight_plan.hpp"
#include "hal/contact.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::avionics {

/// A contact that has not settled does not abort, so that a reset in flight is none; but it keeps from arming.
[[nodiscard]] protocol::AbortState abort_state(core::AbortInput input, const hal::Contact& contact);

}  // namespace fantail::avionics
