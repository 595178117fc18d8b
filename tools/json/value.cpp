// SPDX-License-Identifier: MIT
#include "json/value.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace fantail::json {
namespace {

using Theirs = nlohmann::ordered_json;

constexpr int deepest = 200;  // nlohmann/json reads any depth; copying and destroying what it read are recursive

}  // namespace

struct Nlohmann {
  static std::string dump(const Value& value, int indent) {
    return from(value).dump(indent, ' ', false, Theirs::error_handler_t::replace);
  }

  static Theirs from(const Value& value) {
    return std::visit([](const auto& content) { return from(content); }, value.content_);
  }
  static Theirs from(std::monostate) { return nullptr; }
  static Theirs from(const std::vector<Value>& elements) {
    Theirs all = Theirs::array();
    for (const Value& element : elements) {
      all.push_back(from(element));
    }
    return all;
  }
  static Theirs from(const std::vector<Member>& members) {
    Theirs all = Theirs::object();
    for (const Member& member : members) {
      all.emplace(member.key, from(member.value));
    }
    return all;
  }
  template <typename Scalar>
  static Theirs from(const Scalar& scalar) {
    return scalar;
  }

  static Value to(const Theirs& theirs, int depth = 0) {
    if (depth > deepest) {
      throw Error{fmt::format("nested deeper than {} levels", deepest)};
    }
    switch (theirs.type()) {
      case Theirs::value_t::boolean: return theirs.get<bool>();
      case Theirs::value_t::number_integer: return theirs.get<std::int64_t>();
      case Theirs::value_t::number_unsigned: return theirs.get<std::uint64_t>();
      case Theirs::value_t::number_float: return theirs.get<double>();
      case Theirs::value_t::string: return theirs.get_ref<const std::string&>();
      case Theirs::value_t::array: {
        Value all = Value::array();
        for (const Theirs& element : theirs) {
          all.push_back(to(element, depth + 1));
        }
        return all;
      }
      case Theirs::value_t::object: {
        Value all;
        auto& members = all.content_.emplace<std::vector<Member>>();
        for (const auto& [key, value] : theirs.items()) {
          members.push_back({key, to(value, depth + 1)});
        }
        return all;
      }
      default: return {};
    }
  }
};

namespace {

[[noreturn]] void refuse(const Value& value, std::string_view wanted) {
  throw Error{fmt::format("not {}: {}", wanted, value.dump().substr(0, 100))};
}

}  // namespace

Value::Value() noexcept = default;
Value::Value(std::string text) : content_{std::move(text)} {}
Value::Value(std::vector<Value> elements) : content_{std::move(elements)} {}
Value::Value(std::initializer_list<Member> members) : content_{std::vector<Member>(members)} {}
Value Value::array(std::initializer_list<Value> elements) { return std::vector<Value>(elements); }

Value::Value(const Value& other) = default;
Value::Value(Value&& other) noexcept = default;
Value& Value::operator=(const Value& other) = default;
Value& Value::operator=(Value&& other) noexcept = default;
Value::~Value() = default;

void Value::set(bool value) { content_ = value; }
void Value::set(double value) { content_ = value; }
void Value::set(std::uint64_t value) { content_ = value; }
void Value::set(std::int64_t value) {
  if (value < 0) {
    content_ = value;
  } else {
    content_ = static_cast<std::uint64_t>(value);
  }
}

Value& Value::operator[](std::string_view key) & {
  if (is_null()) {
    content_ = std::vector<Member>{};
  }
  auto* members = std::get_if<std::vector<Member>>(&content_);
  if (members == nullptr) {
    refuse(*this, "an object");
  }
  const auto found = std::ranges::find(*members, key, &Member::key);
  return found != members->end() ? found->value : members->emplace_back(std::string{key}).value;
}

Value& Value::operator[](std::size_t index) & { return const_cast<Value&>(std::as_const(*this)[index]); }

void Value::push_back(Value element) {
  if (is_null()) {
    content_ = std::vector<Value>{};
  }
  auto* elements = std::get_if<std::vector<Value>>(&content_);
  if (elements == nullptr) {
    refuse(*this, "an array");
  }
  elements->push_back(std::move(element));
}

const Value* Value::find(std::string_view key) const {
  const auto* members = std::get_if<std::vector<Member>>(&content_);
  if (members == nullptr) {
    return nullptr;
  }
  const auto found = std::ranges::find(*members, key, &Member::key);
  return found != members->end() ? &found->value : nullptr;
}

const Value& Value::operator[](std::string_view key) const& {
  const Value* found = find(key);
  if (found == nullptr) {
    refuse(*this, fmt::format("an object with \"{}\"", key));
  }
  return *found;
}

const Value& Value::operator[](std::size_t index) const& {
  if (!is_array() || index >= size()) {
    refuse(*this, fmt::format("an array with an element {}", index));
  }
  return begin()[index];
}

template <typename Content>
const Content& Value::content(std::string_view wanted) const {
  const auto* content = std::get_if<Content>(&content_);
  if (content == nullptr) {
    refuse(*this, wanted);
  }
  return *content;
}

bool Value::boolean() const { return content<bool>("true or false"); }
std::uint64_t Value::count() const { return content<std::uint64_t>("a whole number from 0 on"); }
const std::string& Value::text() const { return content<std::string>("text"); }
const std::vector<Member>& Value::members() const { return content<std::vector<Member>>("an object"); }
double Value::number() const {
  if (const auto* negative = std::get_if<std::int64_t>(&content_)) {
    return static_cast<double>(*negative);
  }
  return is_count() ? static_cast<double>(count()) : content<double>("a number");
}

bool Value::is_null() const { return std::holds_alternative<std::monostate>(content_); }
bool Value::is_number() const {
  return is_count() || std::holds_alternative<std::int64_t>(content_) || std::holds_alternative<double>(content_);
}
bool Value::is_count() const { return std::holds_alternative<std::uint64_t>(content_); }
bool Value::is_text() const { return std::holds_alternative<std::string>(content_); }
bool Value::is_array() const { return std::holds_alternative<std::vector<Value>>(content_); }
bool Value::is_object() const { return std::holds_alternative<std::vector<Member>>(content_); }

std::size_t Value::size() const {
  const auto* members = std::get_if<std::vector<Member>>(&content_);
  return members != nullptr ? members->size() : static_cast<std::size_t>(end() - begin());
}
const Value* Value::begin() const {
  const auto* elements = std::get_if<std::vector<Value>>(&content_);
  return elements != nullptr ? elements->data() : nullptr;
}
const Value* Value::end() const {
  const auto* elements = std::get_if<std::vector<Value>>(&content_);
  return elements != nullptr ? elements->data() + elements->size() : nullptr;
}

std::string Value::dump() const { return Nlohmann::dump(*this, -1); }
std::string Value::pretty() const { return Nlohmann::dump(*this, 2) + "\n"; }

bool operator==(const Value& a, const Value& b) {
  const bool numbers = a.is_number() && b.is_number() && a.content_.index() != b.content_.index();
  return numbers ? a.number() == b.number() : a.content_ == b.content_;
}

std::ostream& operator<<(std::ostream& stream, const Value& value) { return stream << value.dump(); }

Value parse(std::string_view text) {
  try {
    return Nlohmann::to(Theirs::parse(text));
  } catch (const Theirs::exception& error) {
    throw Error{std::string{error.what()}.substr(0, 300)};  // it repeats what it has read, to the end of the file
  }
}

void keep_exact(Value& object, std::string_view key) {
  constexpr std::uint64_t most = (std::uint64_t{1} << 53U) - 1U;
  if (const Value* value = object.find(key); value != nullptr && value->is_count() && value->count() > most) {
    object[std::string{key} + "_text"] = Value{value->dump()};
  }
}

Value text_or_null(std::string_view text) { return text.empty() ? Value{} : Value{text}; }

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const double result = std::round(value * scale) / scale;
  return result == 0.0 ? 0.0 : result;
}

std::optional<double> rounded(const std::optional<double>& value, int decimals) {
  return value ? std::optional{rounded(*value, decimals)} : std::nullopt;
}

Value printed(const std::optional<double>& value, int decimals) {
  return value && std::isfinite(*value) ? parse(fmt::format("{:.{}f}", *value, decimals)) : Value{};
}

}  // namespace fantail::json
