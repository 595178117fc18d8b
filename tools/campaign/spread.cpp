// SPDX-License-Identifier: MIT
#include "campaign/spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "flight/table.hpp"
#include "input/shipped.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

using input::Section;

constexpr std::array<std::string_view, 5> laws{"normal", "uniform", "triangular", "rows", "next_row"};
constexpr std::array<std::string_view, 3> effects{"value", "offset", "factor"};
constexpr std::array<std::string_view, 2> outsides{"refuse", "truncate"};
constexpr input::Limits any{-1e300, 1e300};
constexpr std::size_t most_fields = 50;

template <typename Choice>
void read_choice(Section& section, std::string_view key, std::span<const std::string_view> words, Choice& choice) {
  if (section.has(key)) {
    choice = static_cast<Choice>(section.choice(key, words));
  }
}

/// What changes nothing would look like what does not matter.
void require_effect(Section& section, const input::ScenarioFiles& files, const Spread& spread) {
  constexpr std::array only_in_six_dof{"wind", "recovery", "airframe"};
  const input::NumberField& field = spread.fields.back();
  if (std::ranges::find(only_in_six_dof, field.section) != only_in_six_dof.end() &&
      files.scenario().root()["flight"]["motion"].text().value_or("straight") != "six_dof") {
    section.refuse("field",
                   field.name() + " has no effect on a straight line; allowed: with flight.motion = \"six_dof\"");
  }
  if (spread.effect == Effect::factor && std::ranges::all_of(field.values, [](double value) { return value == 0.0; })) {
    section.refuse("effect",
                   "= \"factor\" changes nothing of " + field.name() + ", which is 0; allowed: offset or value");
  }
}

void read_fields(Section& section, const input::ScenarioFiles& files, Spread& spread) {
  const bool several = section.has("fields");
  if (several == section.has("field")) {
    section.refuse("field", several ? "and fields are both given; allowed: one of them"
                                    : "is missing; allowed: section.key, or several of them as a list in fields");
  }
  const auto names = several ? section.texts("fields", most_fields) : std::vector{section.text("field")};
  if (names.empty()) {
    section.refuse("fields", "is empty; allowed: one name or more");
  }
  for (const std::string& name : names) {
    try {
      spread.fields.push_back(input::number_field(files, name));
    } catch (const text::Error& error) {
      section.refuse(several ? "fields" : "field", "= \"" + name + "\": " + error.what());
    }
    require_effect(section, files, spread);
    if (spread.effect == Effect::value && spread.fields.back().values.size() > 1) {
      section.refuse("effect", fmt::format("must be offset or factor: {} has {} values", name,
                                           spread.fields.back().values.size()));
    }
  }
}

std::vector<double> one_a_field(Section& section, const char* single, const char* list, input::Limits limits,
                                const Spread& spread) {
  const std::size_t count = spread.fields.size();
  const char* key = count == 1 ? single : list;
  std::vector<double> values =
      count == 1 ? std::vector{section.number(single, limits)} : section.numbers(list, limits, most_fields);
  if (values.size() != count) {
    section.refuse(key, fmt::format("has {} values; allowed: {}, one for each of fields", values.size(), count));
  }
  return values;
}

// Where no mean is said, the values that the files say are in the middle.
std::vector<double> usual_means(const Spread& spread) {
  std::vector<double> means;
  means.reserve(spread.fields.size());
  for (const input::NumberField& field : spread.fields) {
    means.push_back(spread.effect == Effect::value    ? field.values.front()
                    : spread.effect == Effect::factor ? 1.0
                                                      : 0.0);
  }
  return means;
}

constexpr std::size_t place(std::size_t row, std::size_t column) { return row * (row + 1) / 2 + column; }

/// Cholesky's root of the matrix with ones on its diagonal and these numbers below it, row by row.
std::vector<double> root_of(Section& section, const std::vector<double>& correlations, std::size_t count) {
  if (correlations.size() != count * (count - 1) / 2) {
    section.refuse("correlations", fmt::format("has {} values; allowed: {}, those below the diagonal row by row",
                                               correlations.size(), count * (count - 1) / 2));
  }
  std::vector<double> root(place(count, 0), 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double left = i == j ? 1.0 : correlations[i * (i - 1) / 2 + j];
      for (std::size_t k = 0; k < j; ++k) {
        left -= root[place(i, k)] * root[place(j, k)];
      }
      if (i == j && !(left > 0.0)) {
        section.refuse("correlations",
                       "are impossible: they contradict each other, or one quantity would follow exactly from others");
      }
      root[place(i, j)] = i == j ? std::sqrt(left) : left / root[place(j, j)];
    }
  }
  return root;
}

void read_normal(Section& section, Spread& spread) {
  const bool several = spread.fields.size() > 1;
  spread.means_are_the_file_s = !section.has(several ? "means" : "mean");
  spread.means = spread.means_are_the_file_s ? usual_means(spread) : one_a_field(section, "mean", "means", any, spread);
  spread.standard_deviations =
      one_a_field(section, "standard_deviation", "standard_deviations", {0.0, any.maximum}, spread);
  if (several) {
    const std::size_t count = spread.fields.size();
    spread.correlation_root =
        section.has("correlations")
            ? root_of(section, section.numbers("correlations", {-1.0, 1.0}, place(most_fields, 0)), count)
            : root_of(section, std::vector<double>(count * (count - 1) / 2, 0.0), count);
  } else {
    spread.correlation_root = {1.0};
  }
}

void read_range(Section& section, Spread& spread) {
  if (spread.fields.size() > 1) {
    section.refuse("fields", "has several names; allowed: one with law = \"" +
                                 std::string{laws[static_cast<std::size_t>(spread.law)]} + "\"");
  }
  spread.low = section.number("low", any);
  spread.high = section.number("high", any);
  if (!(spread.low < spread.high)) {
    section.refuse("high", fmt::format("= {} must be more than low = {}", spread.high, spread.low));
  }
  if (spread.law == Law::triangular) {
    spread.mode = section.number("mode", {spread.low, spread.high});
  }
}

void read_rows(Section& section, const input::Document& document, Spread& spread) {
  spread.table = input::find_named_input(input::Shipped::tunnel_result, document, section, "table");
  const flight::Table table = flight::Table::load(spread.table.string());
  const std::vector<std::string> columns = section.texts("columns", most_fields);
  if (columns.size() != spread.fields.size()) {
    section.refuse("columns",
                   fmt::format("has {} names; allowed: {}, one for each field", columns.size(), spread.fields.size()));
  }
  const std::size_t fewest = spread.law == Law::next_row ? fewest_rows : 1;
  if (table.rows() < fewest) {
    section.refuse("table", fmt::format("= {} has {} rows; allowed: {} or more with law = \"{}\"", table.name(),
                                        table.rows(), fewest, laws[static_cast<std::size_t>(spread.law)]));
  }
  spread.rows.resize(table.rows());
  for (const std::string& column : columns) {
    const std::size_t number = table.column(column);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const auto value = table.number(row, number);
      if (!value) {
        throw text::Error{
            text::ErrorKind::bad_data,
            table.where(row) + ": " + column + " = " + flight::in_quotes(table.cell(row, number)) + " is not a number"};
      }
      spread.rows[row].push_back(*value);
    }
  }
  if (spread.law == Law::next_row) {
    spread.next_row.emplace(spread.rows);
  }
}

Spread read_spread(Section& section, const input::ScenarioFiles& files) {
  Spread spread{.where = section.where("law")};
  read_choice(section, "effect", effects, spread.effect);
  read_choice(section, "outside", outsides, spread.outside);
  read_fields(section, files, spread);
  spread.law = static_cast<Law>(section.choice("law", laws));
  switch (spread.law) {
    case Law::normal: read_normal(section, spread); break;
    case Law::uniform:
    case Law::triangular: read_range(section, spread); break;
    case Law::rows:
    case Law::next_row: read_rows(section, files.scenario(), spread); break;
  }
  section.finish();
  return spread;
}

}  // namespace

std::vector<Spread> read_spreads(const input::ScenarioFiles& files) {
  std::vector<Spread> spreads;
  const input::Document& document = files.scenario();
  const input::TomlNode node = document.root()["spread"];
  if (!node) {
    return spreads;
  }
  const auto elements = node.elements();
  if (!elements || elements->empty() || !std::ranges::all_of(*elements, &input::TomlNode::is_table)) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      document.where("", "spread", node) + ": spread must be written as [[spread]]"};
  }
  std::vector<std::string> drawn;
  for (const input::TomlNode element : *elements) {
    Section section{document, "spread", element};
    spreads.push_back(read_spread(section, files));
    for (const input::NumberField& field : spreads.back().fields) {
      if (std::ranges::find(drawn, field.name()) != drawn.end()) {
        section.refuse(section.has("fields") ? "fields" : "field",
                       "= \"" + field.name() + "\" is drawn by two spreads");
      }
      drawn.push_back(field.name());
    }
  }
  return spreads;
}

}  // namespace fantail::campaign
