// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fantail::rules {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A number of which only the ends are known lies between them: "3.1 or more" reaches to infinity. Most have equal
/// ends.
struct Number {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const Number&) const = default;
};
/// False for one that lies beyond every number, or is none.
[[nodiscard]] constexpr bool can_be_finite(const Number& number) {
  constexpr double largest = std::numeric_limits<double>::max();
  return number.low <= largest && number.high >= -largest;
}
[[nodiscard]] constexpr Number exactly(double value) { return {value, value}; }
/// In the order of Type.
using Known = std::variant<bool, Number, std::string>;
enum class Type : std::uint8_t { flag, number, text };

/// What a name in an expression stands for.
struct Meaning {
  Type type = Type::number;
  std::vector<std::string> words{};  ///< of a text: all that it can be; empty: anything
};

struct Vocabulary {
  std::function<std::optional<Meaning>(const std::string& name)> meaning_of{};
  std::function<std::vector<std::string>()> names{};  ///< for a suggestion
};

/// The position counts characters from 1.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(std::size_t position, const std::string& complaint)
      : std::runtime_error{complaint}, position_{position} {}
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

/// Names, numbers, "texts", true and false with `or`, `and`, `not`, == != < <= > >=, + - * / and parentheses; they bind
/// in this order, the last ones closest.
///
/// Unknown is a value like others: `true or unknown` is true, `false and unknown` is false, all else that has an
/// unknown part is unknown. A comparison of numbers of which only the ends are known is true or false where each number
/// between them makes it so, and else unknown. What is divided by zero or grows beyond every number is unknown.
class Expression {
 public:
  /// Every part has been checked for its type. Throws ExpressionError.
  [[nodiscard]] static Expression parse(std::string_view text, const Vocabulary& vocabulary);

  using ValueOf = std::function<std::optional<Known>(const std::string& name)>;
  /// Empty: unknown.
  [[nodiscard]] std::optional<Known> value(const ValueOf& value_of) const {
    return value_at(nodes_.size() - 1, value_of);
  }
  [[nodiscard]] Type type() const { return nodes_.back().type; }
  /// Each once, in the order in which they stand.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Those without a part of an `and` or `or` that the other part has decided, in the order in which they stand.
  [[nodiscard]] std::vector<std::string> deciding_names(const ValueOf& value_of) const {
    return deciding_names_at(nodes_.size() - 1, value_of);
  }

 private:
  friend class Parser;

  struct Node {
    std::string operation;  ///< "or", "<", "+", "negative", ...; empty: a value or a name
    Type type = Type::flag;
    std::size_t left = 0;
    std::size_t right = 0;
    Known literal{};
    std::string name{};  ///< empty: the literal
    std::size_t position = 0;
    std::vector<std::string> words{};
  };
  [[nodiscard]] std::optional<Known> value_at(std::size_t node, const ValueOf& value_of) const;
  [[nodiscard]] std::vector<std::string> deciding_names_at(std::size_t node, const ValueOf& value_of) const;

  std::vector<Node> nodes_;  ///< each behind its parts; the last is the whole
  std::vector<std::string> names_;
};

}  // namespace fantail::rules
