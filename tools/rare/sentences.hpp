// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "rare/study.hpp"

namespace fantail::rare {

// What a study says, in words.

[[nodiscard]] result::Answer answer_of(const Study& study);
/// What the first level alone shows, 95 % upper bounds: of all failures, and of those without a figure.
[[nodiscard]] double plain_bound(const Study& study);
[[nodiscard]] double events_bound(const Study& study);
[[nodiscard]] std::string heading(const Study& study);
[[nodiscard]] std::string sentence(const Study& study);
/// What the answer does not count, a sentence or two each.
[[nodiscard]] std::vector<std::string> limits(const Study& study);
/// Of a flight that does not meet it, a clause; `criterion`: Mode::criterion.
[[nodiscard]] std::string words_of(const std::string& criterion);

}  // namespace fantail::rare
