// SPDX-License-Identifier: MIT
#pragma once

#include "paper/runs.hpp"
#include "tunnel/swirl.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::paper {

/// What the tunnel's own instruments would have logged in this run.
[[nodiscard]] tunnel::TunnelLog wind_log(const Run& run);

/// A run in which the rocket rolled freely, as its log would show it.
[[nodiscard]] tunnel::RollSession roll_session(const Run& run);

}  // namespace fantail::paper
