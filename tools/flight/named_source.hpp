// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flight/units.hpp"

namespace fantail::flight {

// How a person says which column of a file is what: "time=t:ms,roll_rate=p:rad/s". All throw text::Error
// (bad_configuration), which begins with `where`.

/// One part of it, as it stands there.
struct NamedSource {
  std::string where;     ///< for messages: the option and the part
  std::string quantity;  ///< before the =
  std::string source;    ///< behind it
};
/// `example` is shown for a part that is none.
[[nodiscard]] std::vector<NamedSource> named_sources(std::string_view text, const std::string& option,
                                                     std::string_view example);

[[noreturn]] void refuse_unknown_quantity(const std::string& where, const std::string& word,
                                          std::span<const std::string> allowed);

struct ColumnInUnit {
  std::string column;
  const Unit* unit;
};
/// "p:rad/s". A name may contain colons itself, a unit none.
[[nodiscard]] ColumnInUnit column_in_unit(const std::string& where, std::string_view quantity,
                                          const std::string& source, Dimension dimension);

}  // namespace fantail::flight
