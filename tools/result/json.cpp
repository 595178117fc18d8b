// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "json/value.hpp"
#include "result/document.hpp"
#include "text/number.hpp"

namespace fantail::result {
namespace {

using json::Value;

std::string key(const Column& column) { return column.key + std::string{column.unit.suffix}; }

double with_digits(double value, int digits) {
  const double result = text::decimal(fmt::format("{:.{}g}", value, digits)).value_or(value);
  return result == 0.0 ? 0.0 : result;
}

struct As {
  const Unit& unit;
  int decimals;
  Value operator()(std::monostate) const { return {}; }
  Value operator()(double si) const {
    const double value = unit.per_si * si;
    return std::isfinite(value) ? Value{decimals < 0 ? with_digits(value, -decimals) : json::rounded(value, decimals)}
                                : Value{};
  }
  Value operator()(const Uncertain& of) const { return (*this)(of.value); }
  Value operator()(const Range& of) const {
    const auto end = [this](const std::optional<double>& at) { return at ? (*this)(*at) : Value{}; };
    return Value::array({end(of.low), end(of.high)});
  }
  Value operator()(const Estimate& of) const {
    const As& as = *this;
    return {{"value", as(of.value)}, {"low_95", as(of.value - of.reach)}, {"high_95", as(of.value + of.reach)}};
  }
  Value operator()(const Digits& of) const { return of.text; }
  Value operator()(const Named& of) const { return of.name; }
  Value operator()(const Spread& of) const {
    const As& as = *this;
    return {{"mean", as(of.mean)}, {"p5", as(of.p5)}, {"p50", as(of.p50)}, {"p95", as(of.p95)}};
  }
  Value operator()(const Share& of) const {
    return {{"count", of.count},
            {"of", of.of},
            {"share", json::rounded(of.value)},
            {"low", json::rounded(of.low)},
            {"high", json::rounded(of.high)}};
  }
  Value operator()(const Judged& of) const {
    std::string words = of.words;
    std::ranges::replace(words, ' ', '_');
    return words;
  }
  Value operator()(const auto& as_it_is) const { return as_it_is; }
};

/// "3": the fourth element of a list, which is made where the list ends before it.
Value& member(Value& of, std::string_view name) {
  const std::optional<std::uint64_t> index = text::whole_number(name);
  if (!index) {
    return of[name];
  }
  if (*index == of.size()) {
    of.push_back({});
  }
  return of[*index];
}

/// "stability.worst": the member of a member; "": the document itself.
Value& place(Value& all, std::string_view path) {
  if (path.empty()) {
    return all;
  }
  const std::size_t dot = path.find('.');
  return place(member(all, path.substr(0, dot)), dot == path.npos ? "" : path.substr(dot + 1));
}

void put(Value& all, std::string_view key, Value value) {
  Value& there = place(all, key);
  if (!there.is_null()) {
    throw std::logic_error{fmt::format("a document has two of {}", key)};
  }
  there = std::move(value);
}

void add(Value&, const std::string&, int) {}
void add(Value&, const Picture&, int) {}
void add(Value&, const Live&, int) {}
void add(Value&, const Drawing&, int) {}
void add(Value&, const Links&, int) {}
void add(Value& all, const Data& data, int) { put(all, data.key, data.value); }
void add(Value& all, const Sentences& sentences, int) {
  if (sentences.key) {
    put(all, *sentences.key, sentences.all);
  }
}
void add(Value& all, const Figures& figures, int decimals) {
  if (figures.key) {
    for (const Figure& one : figures.all) {
      put(place(all, *figures.key), key(one), json_of(one.unit, one.value, decimals));
    }
  }
}
void add(Value& all, const Table& table, int decimals) {
  if (table.key) {
    Value rows = Value::array();
    for (const std::vector<Cell>& cells : table.rows) {
      Value row;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        put(row, key(table.columns[i]), json_of(table.columns[i].unit, cells[i], decimals));
      }
      rows.push_back(row);
    }
    put(all, *table.key, rows);
  }
}

}  // namespace

json::Value json_of(const Unit& unit, const Cell& cell, int decimals) { return std::visit(As{unit, decimals}, cell); }

std::string json(const Document& document) {
  Value all;
  put_answer(all, document.verdict.answer, document.verdict.sentence, document.made);
  for (const Fact& fact : document.facts) {
    if (!fact.key.empty()) {
      put(all, fact.key, fact.value);
      json::keep_exact(all, fact.key);
    }
  }
  for (const Section& section : document.sections) {
    for (const Block& block : section.blocks) {
      std::visit([&](const auto& one) { add(all, one, document.json_decimals); }, block);
    }
  }
  return all.pretty();
}

}  // namespace fantail::result
