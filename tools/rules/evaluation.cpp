// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "rules/expression.hpp"

namespace fantail::rules {
namespace {

using Maybe = std::optional<Known>;

/// A product of zero and infinity, or a difference of two infinities, can be anything.
Maybe between(std::initializer_list<double> ends) {
  if (std::ranges::any_of(ends, [](double end) { return std::isnan(end); })) {
    return std::nullopt;
  }
  return Number{std::min(ends), std::max(ends)};
}

/// What lies beyond every number is no value.
Maybe finite(const Maybe& known) {
  const auto* number = known ? std::get_if<Number>(&*known) : nullptr;
  return number == nullptr || can_be_finite(*number) ? known : std::nullopt;
}

Maybe calculated(char sign, const Number& a, const Number& b) {
  switch (sign) {
    case '+': return between({a.low + b.low, a.high + b.high});
    case '-': return between({a.low - b.high, a.high - b.low});
    case '*': return between({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    default: break;
  }
  if (b.low <= 0.0 && b.high >= 0.0) {
    return std::nullopt;
  }
  return between({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
}

Maybe either(bool is_true, bool is_false) { return is_true ? Maybe{true} : is_false ? Maybe{false} : std::nullopt; }

Maybe less(const Number& a, const Number& b) { return either(a.high < b.low, a.low >= b.high); }
Maybe equal(const Known& a, const Known& b) {
  const auto* one = std::get_if<Number>(&a);
  const auto* other = std::get_if<Number>(&b);
  if (one == nullptr || other == nullptr) {
    return a == b;
  }
  const bool are_points = one->low == one->high && other->low == other->high;
  return either(are_points && one->low == other->low, one->high < other->low || other->high < one->low);
}
Maybe opposite(const Maybe& flag) { return flag ? Maybe{!std::get<bool>(*flag)} : std::nullopt; }

bool is(const Maybe& flag, bool wanted) { return flag && std::get<bool>(*flag) == wanted; }

}  // namespace

std::optional<Known> Expression::value_at(std::size_t at, const ValueOf& value_of) const {
  const Node& node = nodes_[at];
  const std::string& does = node.operation;
  if (does.empty()) {
    return node.name.empty() ? Maybe{node.literal} : finite(value_of(node.name));
  }
  const Maybe left = value_at(node.left, value_of);
  if (does == "not") {
    return opposite(left);
  }
  if (does == "negative") {
    return left ? finite(calculated('-', {}, std::get<Number>(*left))) : std::nullopt;
  }
  const Maybe right = value_at(node.right, value_of);
  if (does == "and") {
    return either(is(left, true) && is(right, true), is(left, false) || is(right, false));
  }
  if (does == "or") {
    return either(is(left, true) || is(right, true), is(left, false) && is(right, false));
  }
  if (!left || !right) {
    return std::nullopt;
  }
  if (does == "==" || does == "!=") {
    const Maybe same = equal(*left, *right);
    return does == "==" ? same : opposite(same);
  }
  const Number& a = std::get<Number>(*left);
  const Number& b = std::get<Number>(*right);
  if (does == "<" || does == ">=") {
    return does == "<" ? less(a, b) : opposite(less(a, b));
  }
  if (does == ">" || does == "<=") {
    return does == ">" ? less(b, a) : opposite(less(b, a));
  }
  return finite(calculated(does.front(), a, b));
}

std::vector<std::string> Expression::deciding_names_at(std::size_t at, const ValueOf& value_of) const {
  const Node& node = nodes_[at];
  if (node.operation.empty()) {
    return node.name.empty() ? std::vector<std::string>{} : std::vector{node.name};
  }
  std::vector<std::string> all = deciding_names_at(node.left, value_of);
  if (node.operation == "not" || node.operation == "negative") {
    return all;
  }
  const std::vector<std::string> right = deciding_names_at(node.right, value_of);
  if (node.operation == "and" || node.operation == "or") {
    const bool decides = node.operation == "or";
    if (is(value_at(node.left, value_of), decides)) {
      return all;
    }
    if (is(value_at(node.right, value_of), decides)) {
      return right;
    }
  }
  all.insert(all.end(), right.begin(), right.end());
  return all;
}

}  // namespace fantail::rules
