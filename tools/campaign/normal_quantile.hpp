// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::campaign {

/// The value below which a normal number with mean 0 and variance 1 lies with this probability, which is above 0 and
/// below 1. Exact to a few units in the last place of 1.
[[nodiscard]] double normal_quantile(double probability);

}  // namespace fantail::campaign
