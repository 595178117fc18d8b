// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::flight {

/// An encoder has noise and the play of a gear: this far from trim a canard still stands there.
inline constexpr double encoder_tolerance_deg = 0.5;

/// So long a canard may take back to trim.
inline constexpr double longest_return_s = 0.5;

}  // namespace fantail::flight
