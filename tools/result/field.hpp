// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "result/answer.hpp"
#include "text/degrees.hpp"

namespace fantail::result {

/// How a number in SI is written: in files with "_deg" behind its key, for people with "deg" behind it.
struct Unit {
  std::string_view suffix{};
  std::string_view symbol{};
  double per_si = 1.0;
  double shown_per_si = per_si;  ///< a share is 0.25 in files and 25 % for people
};
namespace units {
inline constexpr Unit none{}, times{"", "times"}, share{"_share", "%", 1.0, 100.0}, percent{"", "%", 1.0, 100.0};
inline constexpr Unit s{"_s", "s"}, m{"_m", "m"}, m2{"_m2", "m2"}, m_s{"_m_s", "m/s"}, n{"_n", "N"}, n_m{"_n_m", "N m"},
    pa{"_pa", "Pa"}, rad_s{"_rad_s", "rad/s"};
inline constexpr Unit deg{"_deg", "deg", text::degrees(1.0)}, deg_s{"_deg_s", "deg/s", text::degrees(1.0)};
}  // namespace units

/// Of many runs: their mean, and the values below which 5, 50 and 95 % of them lie.
struct Spread {
  double mean = 0.0;
  double p5 = 0.0;
  double p50 = 0.0;
  double p95 = 0.0;
  auto operator<=>(const Spread&) const = default;
};
/// How often something happened, with its 95 % interval.
struct Share {
  std::size_t count = 0;
  std::size_t of = 0;
  double value = 0.0;
  double low = 0.0;
  double high = 1.0;
  auto operator<=>(const Share&) const = default;
};
/// A number whose 95 % interval reaches equally far to both sides; in JSON "value", "low_95" and "high_95".
struct Estimate {
  double value = 0.0;
  double reach = 0.0;
  auto operator<=>(const Estimate&) const = default;
};
/// A number and its standard deviation, which JSON has under a key of its own. With as many decimals as two digits of
/// the deviation need, whatever the column says.
struct Uncertain {
  double value = 0.0;
  double deviation = 0.0;  ///< 0: not known
  auto operator<=>(const Uncertain&) const = default;
};
/// From where to where: "22.1 to 23.7", "above 22.1"; in JSON two numbers, null for an end that is open.
struct Range {
  std::optional<double> low{};
  std::optional<double> high{};
  auto operator<=>(const Range&) const = default;
};
/// A number as it is read, where the row says its decimals and not the column. Good or bad, as the next.
struct Digits {
  std::string text{};
  Answer answer = Answer::none;
  std::string below{};  ///< a second, smaller line, on pages alone
  auto operator<=>(const Digits&) const = default;
};
/// Words that are good or bad; in JSON with underscores.
struct Judged {
  Answer answer = Answer::none;
  std::string words{};
  std::string below{};  ///< likewise
  auto operator<=>(const Judged&) const = default;
};
/// What is called by a name, as options and files have it. A page has it in words, and the name below.
struct Named {
  std::string name{};
  std::string words{};
  auto operator<=>(const Named&) const = default;
};

/// The content of one place: nothing, when it is unknown; a number in SI, alone, with its interval or deviation or of
/// many runs; an interval; a count; words; yes or no.
using Cell = std::variant<std::monostate, double, Estimate, Uncertain, Range, Spread, Share, std::uint64_t, Digits,
                          std::string, Judged, Named, bool>;

enum class Worse : std::uint8_t { neither, larger, smaller };
[[nodiscard]] bool is_worse(const Cell& one, const Cell& than, Worse worse);

/// Words for a number of a column in its unit, where digits are not enough.
using Words = std::string (*)(double shown);

struct Column {
  std::string key{};    ///< without its unit
  std::string label{};  ///< for people
  Unit unit{};
  int decimals = 0;
  Worse worse = Worse::neither;
  Words words = nullptr;
  std::string absent = "-";  ///< what people read where the value is unknown
  std::string meaning{};     ///< a clause
};
struct Figure : Column {
  Cell value{};
  std::string remark{};
};

/// Where a field's value is: in a member of the row, or made of the row by a function.
template <typename Row>
class Get {
 public:
  template <typename Source>
    requires std::invocable<Source, const Row&>
  constexpr Get(Source source) : source_{normal(source)} {}

  [[nodiscard]] Cell operator()(const Row& row) const {
    return std::visit([&row](auto source) { return cell(std::invoke(source, row)); }, source_);
  }
  [[nodiscard]] constexpr bool is_member() const { return !std::holds_alternative<Cell (*)(const Row&)>(source_); }
  /// From row to row. A value that a function makes cannot be copied.
  void copy(const Row& from, Row& to) const {
    std::visit(
        [&](auto source) {
          if constexpr (std::is_member_object_pointer_v<decltype(source)>) {
            to.*source = from.*source;
          }
        },
        source_);
  }

 private:
  template <typename Source>
  static constexpr auto normal(Source source) {
    if constexpr (std::is_member_object_pointer_v<Source>) {
      return source;
    } else {
      return static_cast<Cell (*)(const Row&)>(source);
    }
  }
  static Cell cell(const Cell& value) { return value; }
  static Cell cell(std::size_t value) { return std::uint64_t{value}; }
  static Cell cell(const std::string& value) { return value; }
  static Cell cell(double value) { return value; }
  static Cell cell(bool value) { return value; }
  static Cell cell(const Spread& value) { return value; }
  static Cell cell(const Share& value) { return value; }
  template <typename T>
  static Cell cell(const std::optional<T>& value) {
    return value ? cell(*value) : Cell{};
  }

  std::variant<double Row::*, std::optional<double> Row::*, Spread Row::*, std::optional<Spread> Row::*, Share Row::*,
               std::size_t Row::*, std::string Row::*, bool Row::*, Cell (*)(const Row&)>
      source_;
};

/// One figure of a row: said once, printed everywhere.
template <typename Row>
struct Field {
  std::string_view key;
  std::string_view label;
  Unit unit;
  int decimals;
  Get<Row> get;
  std::string_view meaning;  ///< a clause without a full stop, for the manual
  Worse worse = Worse::neither;
  Words words = nullptr;
  std::string_view absent = "-";
};

template <typename List, typename Row>
concept Fields = std::ranges::range<List> && std::same_as<std::ranges::range_value_t<List>, Field<Row>>;

/// A list of fields. It does not compile when two have the same key, or one has no label or no meaning.
template <typename Row, std::size_t count>
[[nodiscard]] consteval std::array<Field<Row>, count> fields(const Field<Row> (&list)[count]) {
  for (std::size_t i = 0; i < count; ++i) {
    if (list[i].key.empty() || list[i].label.empty()) {
      throw "a field without key or label";
    }
    if (list[i].meaning.empty() || list[i].meaning.ends_with('.')) {
      throw "a field needs a meaning, a clause without a full stop";
    }
    if (list[i].worse != Worse::neither && !list[i].get.is_member()) {
      throw "a field that can be worse has to be a member";
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (list[i].key == list[j].key && list[i].unit.suffix == list[j].unit.suffix) {
        throw "two fields with one key";
      }
    }
  }
  return std::to_array(list);
}

/// The fields of one place in JSON ("worst", "effects[]") or of a spreadsheet ("runs.csv"), for the manual.
struct Listed {
  std::string place{};
  std::vector<Column> columns{};
};

template <typename Row>
[[nodiscard]] Column column(const Field<Row>& field) {
  return {.key = std::string{field.key},
          .label = std::string{field.label},
          .unit = field.unit,
          .decimals = field.decimals,
          .worse = field.worse,
          .words = field.words,
          .absent = std::string{field.absent},
          .meaning = std::string{field.meaning}};
}

template <typename Row, std::size_t count>
[[nodiscard]] Listed listed(std::string place, const std::array<Field<Row>, count>& fields) {
  Listed all{.place = std::move(place)};
  for (const Field<Row>& field : fields) {
    all.columns.push_back(column(field));
  }
  return all;
}

/// "6.28", "-", "+25", "6.3 (5.1 to 7.0)", "6.3 ± 0.9": without the unit, for people.
[[nodiscard]] std::string shown(const Column& column, const Cell& cell);
/// Decimals that show so many digits of a number, from the first that is not zero.
[[nodiscard]] int decimals_for(double value, int digits);
/// "5.1 to 7.0"
[[nodiscard]] std::string ends(const Column& column, const Spread& spread);

}  // namespace fantail::result
