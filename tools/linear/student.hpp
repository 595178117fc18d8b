// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::linear {

/// Of Student's distribution: 97.5 % lie below. To 1 % from 3 degrees of freedom on; fewer than 2 count as 2.
[[nodiscard]] double student_975(double degrees_of_freedom);

}  // namespace fantail::linear
