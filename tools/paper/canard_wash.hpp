// SPDX-License-Identifier: MIT
#pragma once

#include "paper/claim.hpp"
#include "paper/runs.hpp"

namespace fantail::paper {

/// Whether a lower offset at the begin of a tunnel step can come from canard-fin interaction, as printed: a step flown
/// with fins that take back a share of the canards' torque later, and identified with the published model, which knows
/// no such thing.
[[nodiscard]] Claim canard_fin_interaction(const Tell& tell);

}  // namespace fantail::paper
