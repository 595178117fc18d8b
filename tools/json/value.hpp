// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace fantail::json {

/// Text that is no JSON, or a value that is not what it was taken for.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Member;

/// One JSON value. nlohmann/json does the work, and value.cpp alone includes it: it takes seconds in every file.
///
///   Value all{{"name", "x"}, {"line", {{"slope", 1.5}}}, {"known", std::optional<double>{}}};  objects, and a null
///   all["limits"] = Value::array({1, 2});                                                      arrays say so
class Value {
 public:
  Value() noexcept;  ///< null
  Value(std::nullptr_t) noexcept : Value{} {}
  Value(std::string text);
  Value(std::string_view text) : Value{std::string{text}} {}
  Value(const char* text) : Value{std::string{text}} {}
  Value(std::vector<Value> elements);
  Value(std::initializer_list<Member> members);  ///< an object; it keeps this order

  template <typename Number>
    requires std::is_arithmetic_v<Number>
  Value(Number number) : Value{} {
    if constexpr (std::is_same_v<Number, bool>) {
      set(number);
    } else if constexpr (std::is_floating_point_v<Number>) {
      set(static_cast<double>(number));
    } else if constexpr (std::is_signed_v<Number>) {
      set(static_cast<std::int64_t>(number));
    } else {
      set(static_cast<std::uint64_t>(number));
    }
  }
  template <typename T>
  Value(const std::optional<T>& value) : Value{} {
    if (value) {
      *this = Value(*value);
    }
  }
  template <typename T>
  Value(const std::vector<T>& list) : Value{std::vector<Value>(list.begin(), list.end())} {}

  [[nodiscard]] static Value array(std::initializer_list<Value> elements = {});

  Value(const Value& other);
  Value(Value&& other) noexcept;
  Value& operator=(const Value& other);
  Value& operator=(Value&& other) noexcept;
  ~Value();

  /// To build with: the member, made when there is none. Null becomes an object here, and an array in push_back().
  [[nodiscard]] Value& operator[](std::string_view key) &;
  [[nodiscard]] Value& operator[](std::size_t index) &;
  void push_back(Value element);

  /// Null when this is no object or has no such member.
  [[nodiscard]] const Value* find(std::string_view key) const;
  [[nodiscard]] bool contains(std::string_view key) const { return find(key) != nullptr; }

  // These throw Error, which says what there is instead.
  [[nodiscard]] const Value& operator[](std::string_view key) const&;
  [[nodiscard]] const Value& operator[](std::size_t index) const&;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] const std::vector<Member>& members() const;

  [[nodiscard]] bool is_null() const;
  [[nodiscard]] bool is_number() const;
  [[nodiscard]] bool is_count() const;  ///< whole and not negative
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] bool is_array() const;
  [[nodiscard]] bool is_object() const;

  /// Of an array's elements or an object's members; other values have none.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// Over an array's elements; other values have none.
  [[nodiscard]] const Value* begin() const;
  [[nodiscard]] const Value* end() const;

  // What is no number becomes null, and bytes that are no UTF-8, as a file's name may have, become U+FFFD.
  [[nodiscard]] std::string dump() const;    ///< in one line, which has no end
  [[nodiscard]] std::string pretty() const;  ///< of a file: indented, with a line end

  /// 1 and 1.0 are equal; objects with other orders are not.
  friend bool operator==(const Value& a, const Value& b);
  friend std::ostream& operator<<(std::ostream& stream, const Value& value);

 private:
  friend struct Nlohmann;

  template <typename Content>
  [[nodiscard]] const Content& content(std::string_view wanted) const;
  void set(bool value);
  void set(double value);
  void set(std::int64_t value);
  void set(std::uint64_t value);

  // An std::int64_t is negative here, so that equal integers have one form.
  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, std::vector<Value>,
               std::vector<Member>>
      content_;
};

struct Member {
  std::string key;
  Value value;

  friend bool operator==(const Member&, const Member&) = default;
};

[[nodiscard]] Value parse(std::string_view text);

[[nodiscard]] Value text_or_null(std::string_view text);

/// A count beyond 2^53, which jq and JavaScript round, gets a second member with its digits: "seed_text" of "seed".
void keep_exact(Value& object, std::string_view key);

/// To so many decimals, and never -0.0: two files that differ in nothing else would compare unequal.
[[nodiscard]] double rounded(double value, int decimals = 6);
[[nodiscard]] std::optional<double> rounded(const std::optional<double>& value, int decimals = 6);

/// The decimals that "{:.4f}" prints. They are those of the exact value, where rounded() multiplies first.
[[nodiscard]] Value printed(const std::optional<double>& value, int decimals);

}  // namespace fantail::json
