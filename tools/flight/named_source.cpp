// SPDX-License-Identifier: MIT
#include "flight/named_source.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "flight/table.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"

namespace fantail::flight {
namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, where + ": " + complaint};
}

}  // namespace

std::vector<NamedSource> named_sources(std::string_view text, const std::string& option, std::string_view example) {
  std::vector<NamedSource> sources;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string part{text.substr(0, comma)};
    const std::size_t equals = part.find('=');
    const std::string where = fmt::format("{} {}", option, part);
    if (equals == std::string::npos || equals == 0 || equals + 1 == part.size()) {
      refuse(where, fmt::format("expected QUANTITY=COLUMN:UNIT, several with commas between, as in {}", example));
    }
    sources.push_back({where, part.substr(0, equals), part.substr(equals + 1)});
    if (comma == text.size()) {
      return sources;
    }
    text.remove_prefix(comma + 1);
  }
}

void refuse_unknown_quantity(const std::string& where, const std::string& word, std::span<const std::string> allowed) {
  std::string message = fmt::format("unknown quantity {}", in_quotes(word));
  if (const auto meant = input::suggestion(word, allowed)) {
    message += "; did you mean " + *meant + "?";
  }
  message += " Allowed:";
  for (const std::string& name : allowed) {
    message += " " + name;
  }
  refuse(where, message);
}

ColumnInUnit column_in_unit(const std::string& where, std::string_view quantity, const std::string& source,
                            Dimension dimension) {
  const std::string allowed = unit_names(dimension);
  const std::size_t colon = source.rfind(':');
  if (colon == std::string::npos || colon == 0) {
    refuse(where, fmt::format("{}: its unit is missing, as in {}:{}; allowed: {}", in_quotes(source), source,
                              allowed.substr(0, allowed.find(',')), allowed));
  }
  const std::string word = source.substr(colon + 1);
  const Unit* const unit = find_unit(word);
  if (unit == nullptr || unit->dimension != dimension) {
    refuse(where, fmt::format("{} is no unit of {}; allowed: {}", in_quotes(word), quantity, allowed));
  }
  return {source.substr(0, colon), unit};
}

}  // namespace fantail::flight
