// SPDX-License-Identifier: MIT
#include "files/sources.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "flight/table.hpp"
#include "input/document.hpp"
#include "input/messages.hpp"
#include "input/section.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::files {
namespace {

constexpr const char* table_name = "columns";
constexpr double one_g_m_s2 = 9.80665;

[[noreturn]] void refuse(const std::string& where, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, where + ": " + complaint};
}

// Where a quantity and its source are said: the option and the part of it, or the line of a file.
struct Said {
  std::string where;
  std::string quantity;
  std::string source;
};

Said said(std::string_view part, const std::string& option) {
  const std::size_t equals = part.find('=');
  const std::string where = fmt::format("{} {}", option, part);
  if (equals == std::string::npos || equals == 0 || equals + 1 == part.size()) {
    refuse(where,
           "expected QUANTITY=COLUMN:UNIT, several with commas between, as in time=t:ms,roll_rate=p:rad/s,axial=-Ay:g");
  }
  return {where, std::string{part.substr(0, equals)}, std::string{part.substr(equals + 1)}};
}

/// `by_column`: asked for by the names of Fantail's own columns, as the older option has it.
const KnownQuantity& quantity_of(const Said& said, std::span<const Quantity> asked, bool by_column) {
  std::vector<std::string> names;
  for (const KnownQuantity& known : known_quantities()) {
    if (std::ranges::find(asked, known.quantity) == asked.end()) {
      continue;
    }
    if (said.quantity == known.name || (said.quantity == known.column && !known.column.empty())) {
      return known;
    }
    const std::string_view name = by_column ? known.column : known.name;
    if (!name.empty() && std::ranges::find(names, name) == names.end()) {
      names.emplace_back(name);
    }
  }
  std::string message =
      fmt::format("unknown {} {}", by_column ? "column" : "quantity", flight::in_quotes(said.quantity));
  if (const auto meant = input::suggestion(said.quantity, names)) {
    message += "; did you mean " + *meant + "?";
  }
  message += " Allowed:";
  for (const std::string& name : names) {
    message += " " + name;
  }
  refuse(said.where, message);
}

// Takes "-" and "SCALE*" off the front of a column's name.
double sign_and_scale(const std::string& where, std::string& column) {
  double factor = 1.0;
  if (column.starts_with('-')) {
    factor = -1.0;
    column.erase(0, 1);
  }
  if (const std::size_t star = column.find('*'); star != std::string::npos) {
    const auto scale = text::number(column.substr(0, star));
    constexpr double largest = 1e12;
    if (!scale || !(std::abs(*scale) >= 1.0 / largest && std::abs(*scale) <= largest)) {
      refuse(where, fmt::format("{} is not a scale; a number from 1e-12 to 1e12 is expected before the *, as in "
                                "0.5*{}",
                                flight::in_quotes(column.substr(0, star)), column.substr(star + 1)));
    }
    factor *= *scale;
    column.erase(0, star + 1);
  }
  if (column.empty()) {
    refuse(where, "the name of the column is missing");
  }
  return factor;
}

Source without_unit(const KnownQuantity& known, const std::string& said) {
  return {.quantity = known.quantity,
          .name = known.dimension ? known.column : known.name,
          .column = said,
          .factor = known.dimension ? own_unit(*known.dimension).si : 1.0,
          .offset = known.from_rest ? one_g_m_s2 : 0.0,
          .words = said};
}

Source source_of(const Said& said, std::span<const Quantity> asked) {
  const KnownQuantity& known = quantity_of(said, asked, false);
  if (!known.dimension) {
    return without_unit(known, said.source);
  }
  const std::size_t colon = said.source.rfind(':');
  const std::string allowed = unit_names(*known.dimension);
  if (colon == std::string::npos || colon == 0) {
    if (said.quantity == known.column) {
      return without_unit(known, said.source);
    }
    refuse(said.where, fmt::format("{}: its unit is missing, as in {}:{}; allowed: {}", flight::in_quotes(said.source),
                                   said.source, allowed.substr(0, allowed.find(',')), allowed));
  }
  const std::string word = said.source.substr(colon + 1);
  const Unit* const unit = find_unit(word);
  if (unit == nullptr || unit->dimension != *known.dimension) {
    refuse(said.where,
           fmt::format("{} is not a unit of {}; allowed: {}", flight::in_quotes(word), known.name, allowed));
  }
  Source source{.quantity = known.quantity,
                .name = known.name,
                .column = said.source.substr(0, colon),
                .unit = unit,
                .offset = unit->offset + (known.from_rest ? one_g_m_s2 : 0.0),
                .words = said.source};
  source.factor = sign_and_scale(said.where, source.column) * unit->si;
  if (source.quantity == Quantity::time && source.factor < 0.0) {
    refuse(said.where, "a time cannot run backwards; allowed: a scale above 0");
  }
  return source;
}

void add(Sources& sources, const std::string& where, Source source) {
  if (find(sources, source.quantity) != nullptr) {
    refuse(where, fmt::format("the quantity {} appears twice", known(source.quantity).name));
  }
  sources.push_back(std::move(source));
}

}  // namespace

Sources parse_columns(std::string_view text, const std::string& option, std::span<const Quantity> asked) {
  Sources sources;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const Said part = said(text.substr(0, comma), option);
    add(sources, part.where, source_of(part, asked));
    if (comma == text.size()) {
      return sources;
    }
    text.remove_prefix(comma + 1);
  }
}

Source parse_column(std::string_view text, const std::string& option, std::span<const Quantity> asked) {
  const Said part = said(text, option);
  return without_unit(quantity_of(part, asked, true), part.source);
}

Sources sources_of(const Logger& logger, std::span<const Quantity> asked) {
  Sources sources = parse_columns(logger.columns, std::string{logger.name}, asked);
  for (Source& source : sources) {
    source.no_value = logger.no_value;
    source.must_be_there = source.quantity == Quantity::time || source.quantity == Quantity::axial;
  }
  return sources;
}

Sources merged(const Sources& first, const Sources& second) {
  Sources both = first;
  std::ranges::copy_if(second, std::back_inserter(both),
                       [&](const Source& source) { return find(first, source.quantity) == nullptr; });
  return both;
}

const Source* find(const Sources& sources, Quantity quantity) {
  const auto found = std::ranges::find(sources, quantity, &Source::quantity);
  return found == sources.end() ? nullptr : &*found;
}

std::string in_words(const Sources& sources) {
  std::string words;
  for (const Source& source : sources) {
    const std::string_view all = source.words;
    words += fmt::format("{}{} is {}", words.empty() ? "" : ", ", known(source.quantity).name,
                         all.substr(0, source.unit == nullptr ? all.size() : all.rfind(':')));
    words += source.unit == nullptr ? "" : fmt::format(" in {}", source.unit->name);
  }
  return words;
}

std::filesystem::path kept_sources_file(const std::filesystem::path& log) { return log.string() + ".columns.toml"; }

Sources read_sources(const std::filesystem::path& file, std::span<const Quantity> asked) {
  const input::Document document = input::Document::load(file.string());
  input::refuse_unknown_sections(document, std::vector<std::string>{table_name});
  input::Section section{document, table_name};
  Sources sources;
  for (const std::string& word : document.root()[table_name].keys()) {
    const std::string source = section.text(word);
    add(sources, section.where(word), source_of({section.where(word), word, source}, asked));
  }
  return sources;
}

std::string sources_toml(const Sources& sources, const std::string& log) {
  std::string text = fmt::format("# How Fantail reads {}: the name and the unit of each column in that file.\n[{}]\n",
                                 log, table_name);
  for (const Source& source : sources) {
    std::string words = source.words;
    for (std::size_t at = 0; (at = words.find_first_of("\\\"", at)) != std::string::npos; at += 2) {
      words.insert(at, 1, '\\');
    }
    text += fmt::format("{} = \"{}\"\n", source.name, words);
  }
  return text;
}

}  // namespace fantail::files
