// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flight/flight.hpp"

namespace fantail::report {

// Sentences of a verdict, each with a space before it; empty where there is nothing to say.

/// Each reset and standstill of the processor in flight, and whether the flight went on after it.
[[nodiscard]] std::string outages(const flight::Flight& flight);

/// When the gyro was silent, and from when on height and speed are lower bounds.
[[nodiscard]] std::string unmeasured(const flight::Flight& flight);

/// The first finding of the monitor about each canard, how long it lasted, and what became of it.
[[nodiscard]] std::string canard_faults(const flight::Flight& flight);

/// A clause without that space, "canard 1 does not follow its command": stalled or slipping for its monitor, when
/// control ended; empty: none.
[[nodiscard]] std::string not_following(const flight::Flight& flight);

}  // namespace fantail::report
