// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hardover/study.hpp"
#include "input/scenario_file.hpp"

namespace fantail::hardover {

inline Study study(const std::vector<std::string>& changes, const Options& options) {
  return fly(input::load_scenario("tasha3_launch2", input::parse_overrides(changes)), options,
             [](std::size_t, std::size_t) {});
}

inline std::string text_of(const Study& found) { return result::text(answer(found)); }
inline std::string page_of(const Study& found) { return result::html(answer(found)); }
inline std::string json_of(const Study& found) { return result::json(answer(found)); }

}  // namespace fantail::hardover
