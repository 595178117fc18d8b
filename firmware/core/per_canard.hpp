// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "core/inputs.hpp"

namespace fantail::core {

/// What `make` gives for each canard, 0 to 3. An array of optionals that is filled in later would begin with a call to
/// clear it.
template <typename Make>
[[nodiscard]] constexpr auto per_canard(const Make& make) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{make(i)...};
  }(std::make_index_sequence<canard_count>{});
}

}  // namespace fantail::core
