// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace fantail::telemetry {

/// The files of types/, made into constants when the program is built.
namespace type_texts {
extern const std::string_view state_t;
extern const std::string_view canards_t;
extern const std::string_view event_t;
extern const std::string_view health_t;
}  // namespace type_texts

struct TypeFile {
  std::string_view name;  ///< "state_t.lcm"
  std::string_view text;
};

/// All that lcm-gen needs to decode the messages.
[[nodiscard]] inline std::array<TypeFile, 4> type_files() {
  return {{{"state_t.lcm", type_texts::state_t},
           {"canards_t.lcm", type_texts::canards_t},
           {"event_t.lcm", type_texts::event_t},
           {"health_t.lcm", type_texts::health_t}}};
}

}  // namespace fantail::telemetry
