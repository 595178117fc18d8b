// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/scenario.hpp"
#include "tune/law.hpp"
#include "tune/request.hpp"
#include "tune/speeds_flown.hpp"

namespace fantail::tune {

/// Which demand binds a law that meets them all, a sentence: what is missed with the next larger round number of that
/// by which it rejects an offset (without rejection, of kp), as the linear loop says.
/// `reserve_rad`: what the search asks for beside the phase margin of the request.
[[nodiscard]] std::string bound_sentence(const sim::Scenario& scenario, const SpeedsFlown& speeds,
                                         const Request& request, double reserve_rad, const Law& law);

}  // namespace fantail::tune
