// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "input/section.hpp"
#include "sim/units.hpp"

// The fields of a document, as a table: one row for each key that a file may have. Reading, checking and the manual are
// made from that table; what spans several keys is checked by whoever reads the document.
namespace fantail::input {

/// A number as files have it and as structs have it.
struct Unit {
  std::string_view name{};  ///< empty for a pure number
  double scale = 1.0;       ///< inside value = scale * file value, or
  bool inverted = false;    ///< 1 / file value: a rate that is kept as its period
  double first = 0.0;       ///< what files call the first of several, which is number 0 inside

  [[nodiscard]] constexpr double inside(double file) const { return inverted ? 1.0 / file : scale * file - first; }
  [[nodiscard]] constexpr double in_file(double inside) const {
    return inverted ? 1.0 / inside : (inside + first) / scale;
  }
};

inline constexpr Unit deg{.name = "deg", .scale = sim::radians_per_degree};
inline constexpr Unit deg_s{.name = "deg/s", .scale = sim::radians_per_degree};

enum class FieldKind : std::uint8_t { number, integer, choice, text, file };

using Words = std::span<const std::string_view>;

/// What may stand behind a key.
struct Allowed {
  FieldKind kind = FieldKind::text;
  Unit unit{};
  Limits range{};        ///< of a number, in the file's unit
  Words words{};         ///< of a choice; inside it is the place of the word
  std::size_t most = 1;  ///< values: 1; 4, one a canard; the most of a list
  bool is_list = false;  ///< of any length up to that

  [[nodiscard]] constexpr bool is_text() const { return kind == FieldKind::text || kind == FieldKind::file; }
};

constexpr Allowed number(Unit unit, Limits range) { return {.kind = FieldKind::number, .unit = unit, .range = range}; }
constexpr Allowed number(std::string_view unit, Limits range) { return number(Unit{.name = unit}, range); }
constexpr Allowed integer(Unit unit, Limits range) {
  return {.kind = FieldKind::integer, .unit = unit, .range = range};
}
constexpr Allowed choice(Words words) { return {.kind = FieldKind::choice, .words = words}; }
constexpr Allowed text() { return {.kind = FieldKind::text}; }
constexpr Allowed file() { return {.kind = FieldKind::file}; }  ///< a shipped name or a path; whoever reads opens it
/// One value for each canard, or none.
constexpr Allowed four(Allowed each) {
  each.most = 4;
  return each;
}
constexpr Allowed list(std::size_t most, Allowed each) {
  each.most = most;
  each.is_list = true;
  return each;
}

/// Must the key be there?
enum class Presence : std::uint8_t { may, must, must_in_its_section };
using enum Presence;

/// Where a `Thing` keeps a value: inside values of numbers and choices, and texts. What is read elsewhere has no place.
template <typename Thing>
struct Place {
  void (*set)(Thing&, std::size_t slot, double inside) = nullptr;
  double (*get)(const Thing&, std::size_t slot) = nullptr;  ///< NaN where there is none
  void (*set_text)(Thing&, std::size_t slot, std::string text) = nullptr;
};

/// One key of a file about a `Thing`. What may be absent has the value of a `Thing` that nobody has changed.
template <typename Thing>
struct Field {
  std::string_view section;  ///< empty: ahead of all sections
  std::string_view key;
  Allowed allowed;
  Presence presence;
  Place<Thing> place;
  std::string_view meaning;  ///< a plain sentence, in Markdown
};

/// `Member` is a type of function (thing, slot) -> reference, for a thing that may be const; FANTAIL_PLACE writes it.
template <typename Thing, typename Member>
constexpr Place<Thing> place_of(Member) {
  using Value = std::remove_cvref_t<decltype(Member{}(std::declval<Thing&>(), 0))>;
  if constexpr (std::is_assignable_v<Value&, std::string>) {
    return {.set_text = [](Thing& thing, std::size_t i, std::string text) { Member{}(thing, i) = std::move(text); }};
  } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
    return {.set = [](Thing& thing, std::size_t i, double inside) { Member{}(thing, i) = inside; },
            .get = [](const Thing& thing,
                      std::size_t i) { return Member{}(thing, i).value_or(std::numeric_limits<double>::quiet_NaN()); }};
  } else {
    return {.set =
                [](Thing& thing, std::size_t i, double inside) {
                  if constexpr (std::is_enum_v<Value>) {
                    Member{}(thing, i) = static_cast<Value>(static_cast<std::underlying_type_t<Value>>(inside));
                  } else {
                    Member{}(thing, i) = static_cast<Value>(inside);
                  }
                },
            .get = [](const Thing& thing, std::size_t i) { return static_cast<double>(Member{}(thing, i)); }};
  }
}

// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name in parentheses is no longer one
#define FANTAIL_PLACE(Thing, expression) \
  place_of<Thing>([](auto& it, [[maybe_unused]] std::size_t i) -> auto& { return expression; })

/// What is there when its section is; the usual one where it is not.
template <typename Thing>
Thing& made(std::optional<Thing>& thing) {
  return thing ? *thing : thing.emplace(Thing{});
}
template <typename Thing>
const Thing& made(const std::optional<Thing>& thing) {
  static const Thing usual{};
  return thing ? *thing : usual;
}

/// The place of slot `i` of a list that grows as it is read; the usual one where it has not grown so far.
template <typename Value>
Value& grown(std::vector<Value>& values, std::size_t i) {
  values.resize(std::max(values.size(), i + 1));
  return values[i];
}
template <typename Value>
const Value& grown(const std::vector<Value>& values, std::size_t i) {
  static const Value usual{};
  return i < values.size() ? values[i] : usual;
}

/// File values of a key that must be there; the place of a word for a choice. Throws text::Error.
[[nodiscard]] std::vector<double> read_numbers(Section& section, std::string_view key, const Allowed& allowed);
[[nodiscard]] std::vector<std::string> read_texts(Section& section, std::string_view key, const Allowed& allowed);

/// Leaves the thing alone where the key is absent and may be. Throws text::Error.
template <typename Thing>
void read_field(Section& section, const Field<Thing>& field, Thing& thing) {
  const bool must =
      field.presence == Presence::must || (field.presence == Presence::must_in_its_section && section.is_there());
  if (!section.has(field.key) && !must) {
    return;
  }
  if (!field.allowed.is_text()) {
    const std::vector<double> values = read_numbers(section, field.key, field.allowed);
    for (std::size_t i = 0; i < values.size(); ++i) {
      field.place.set(thing, i, field.allowed.unit.inside(values[i]));
    }
    return;
  }
  const std::vector<std::string> texts = read_texts(section, field.key, field.allowed);
  for (std::size_t i = 0; i < texts.size() && field.place.set_text != nullptr; ++i) {
    field.place.set_text(thing, i, texts[i]);
  }
}

/// Reads one section, or what stands ahead of all. Of a section it refuses every key that the table has not. Throws
/// text::Error.
template <typename Thing>
void read_section(const Document& document, std::string_view name, std::span<const Field<Thing>> fields, Thing& thing) {
  Section section{document, std::string{name}};
  for (const Field<Thing>& field : fields) {
    if (field.section == name) {
      read_field(section, field, thing);
    }
  }
  if (!name.empty()) {
    section.finish();
  }
}

/// The sections of a table, in its order.
template <typename Thing>
std::vector<std::string> sections_of(std::span<const Field<Thing>> fields) {
  std::vector<std::string> names;
  for (const Field<Thing>& field : fields) {
    if (!field.section.empty() && (names.empty() || names.back() != field.section)) {
      names.emplace_back(field.section);
    }
  }
  return names;
}

}  // namespace fantail::input
