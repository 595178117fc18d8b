// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "listen/heard.hpp"
#include "result/answer.hpp"
#include "text/layout.hpp"

namespace fantail::listen {

/// For a terminal: the finding, the phases, the law beside the log, and the notes.
[[nodiscard]] std::string as_text(const Heard& heard, std::size_t columns = text::any_width);
/// listen.json; `version` is the program's.
[[nodiscard]] std::string as_json(const Heard& heard, std::string_view version, const result::Made& made = {});
/// Was the launch detected in time, and nothing else taken for one? Undecided where the log has no launch, or doubts.
[[nodiscard]] result::Answer answer(const Heard& heard);
/// listen.html.
[[nodiscard]] std::string as_html(const Heard& heard);

/// A quantity of the law beside the log's: for text and page.
struct Row {
  std::string what{};
  std::string law{};
  std::string log{};
};
[[nodiscard]] std::vector<Row> comparison(const Heard& heard);
/// "Launched", "launch detected", ... for each phase that was entered.
struct PhaseRow {
  std::string phase{};
  std::string reason{};
  std::string log_time{};        ///< s
  std::string since_lift_off{};  ///< s; empty without lift-off
  std::string height{};          ///< m
  std::string speed{};           ///< m/s
  std::string tilt{};            ///< deg
};
[[nodiscard]] std::vector<PhaseRow> phase_rows(const Heard& heard);

}  // namespace fantail::listen
