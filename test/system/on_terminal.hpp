// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "system/folder.hpp"
#include "system/refusal.hpp"
#include "system/screen.hpp"

namespace fantail::test {

using Variables = std::vector<std::pair<const char*, const char*>>;  // null: none of that name

inline std::function<void()> surroundings(const Variables& variables) {
  return [variables] {
    for (const auto& [name, value] : variables) {
      value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    }
  };
}

inline const Variables plain{{"TERM", "xterm"}, {"NO_COLOR", nullptr}};

inline Outcome on_terminal(const Words& words, const Folder& folder, unsigned short columns = 80,
                           const Variables& variables = plain) {
  return Screen{columns}.fantail(words, {.working_folder = folder.path(), .prepare = surroundings(variables)});
}

inline bool has_escape(const std::string& text) { return text.find('\033') != std::string::npos; }

}  // namespace fantail::test
