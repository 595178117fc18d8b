// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sim/wind.hpp"

namespace fantail::predict {

/// The wind of one run: its speed normal about the stated one, drawn again until it is not below zero, and where it
/// comes from anywhere within the spread to both sides of what is stated, each direction alike. Profile, gust and
/// turbulence stay as stated; turbulence has a stream of its own. The same seed draws the same wind, and a spread of
/// zero the stated one.
[[nodiscard]] sim::WindParameters drawn_wind(const sim::WindParameters& stated, const sim::WindSpread& spread,
                                             std::uint64_t seed);

}  // namespace fantail::predict
