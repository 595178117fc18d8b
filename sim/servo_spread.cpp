// SPDX-License-Identifier: MIT
#include "sim/servo_spread.hpp"

#include <algorithm>

namespace fantail::sim {

ServoParameters one_of_the_spread(const ServoParameters& typical, const ServoSpread& spread, Random& random) {
  const auto even = [&random] { return 2.0 * random.uniform() - 1.0; };
  const auto factor = [&] { return 1.0 + spread.share * even(); };
  ServoParameters one = typical;
  one.lag_s = std::clamp(typical.lag_s * factor(), shortest_lag_s, longest_lag_s);
  one.delay_s = std::min(typical.delay_s * factor(), longest_delay_s);
  one.rate_limit_rad_s = typical.rate_limit_rad_s * factor();
  one.backlash_rad = typical.backlash_rad * factor();
  one.centre_rad = std::clamp(typical.centre_rad + spread.centre_rad * even(), -typical.stop_rad, typical.stop_rad);
  return one;
}

}  // namespace fantail::sim
