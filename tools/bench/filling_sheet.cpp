// SPDX-License-Identifier: MIT
#include "bench/sheet.hpp"
#include "bench/sheet_parts.hpp"

namespace fantail::bench {

std::optional<std::string> FillingSheet::take(const link::Tick& tick) {
  const std::size_t turns_over = exercise_.turns_before(tick.stretch);
  if (!recording_.add(tick) || turns_over <= turns_over_) {
    return std::nullopt;
  }
  turns_over_ = turns_over;
  return html("");
}

std::string FillingSheet::given_up(const std::string& why) const {
  return turns_over_ == 0 ? no_sheet_html(title(heading_), why) : html(why);
}

std::string FillingSheet::html(const std::string& given_up_because) const {
  const Exercise first = exercise_.beginning(turns_over_);
  const Sheet sheet = examine(recording_, first, tolerances_, heading_);
  return sheet_so_far_html(sheet, recording_, first, exercise_.turns().size() - turns_over_, given_up_because);
}

}  // namespace fantail::bench
