// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::core {

/// Height over the pad, where the pressure is `ratio` of the pad's, in the standard atmosphere with the pad's
/// temperature: T / L (1 - ratio^(R L / g)), L = 6.5 K/km (ISO 2533). Up to 11 km, within 0.1 %. By roots, because
/// powers are not the same in every C library.
[[nodiscard]] float pressure_height_m(float ratio, float pad_temperature_k);

}  // namespace fantail::core
