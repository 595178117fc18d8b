// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/angle.hpp"
#include "core/tick_record_fields.hpp"

namespace fantail::protocol {

// How values cross the link between a world and a flight computer, bit for bit: little-endian, float 4 bytes, an
// integer or a time as wide as its type, flag 1, enumeration 1, an optional its flag and its value. There are three
// visitors, for one list of values each that both sides share: a writer, a reader, and what names the layout.

/// Common to the three: takes a value apart until only unsigned numbers are left, which Derived::number() is given.
template <typename Derived>
class HilVisitor {
 public:
  template <typename T>
  void operator()(T&& value) {
    each(Derived::seen(value));
  }
  template <typename T>
  void operator()(const core::SignalName&, T& value) {
    each(Derived::seen(value));
  }

 private:
  template <typename T>
  void each(T& value) {
    using Value = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Value, bool>) {
      number<1>(value, [](bool v) { return v ? 1U : 0U; }, [](std::uint64_t bits) { return bits != 0; });
    } else if constexpr (std::is_enum_v<Value>) {
      static_assert(sizeof(Value) == 1);
      plain<std::uint8_t>(value);
    } else if constexpr (std::is_same_v<Value, float>) {
      number<4>(
          value, [](float v) { return std::bit_cast<std::uint32_t>(v); },
          [](std::uint64_t bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); });
    } else if constexpr (std::is_same_v<Value, core::Angle>) {
      number<4>(
          value, [](core::Angle v) { return std::bit_cast<std::uint32_t>(v.radians()); },
          [](std::uint64_t bits) {
            return core::Angle::from_radians(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
          });
    } else if constexpr (std::is_integral_v<Value>) {
      plain<std::make_unsigned_t<Value>>(value);
    } else {
      using Count = typename Value::rep;  // a time
      number<sizeof(Count)>(
          value, [](Value v) { return static_cast<std::make_unsigned_t<Count>>(v.count()); },
          [](std::uint64_t bits) { return Value{static_cast<Count>(bits)}; });
    }
  }
  template <typename T, std::size_t n>
  void each(std::array<T, n>& values) {
    for (T& value : values) {
      each(value);
    }
  }
  template <typename T, std::size_t n>
  void each(const std::array<T, n>& values) {
    for (const T& value : values) {
      each(value);
    }
  }
  template <typename T>
  void each(const std::optional<T>& value) {
    const bool there = value.has_value();
    const T content = value.value_or(T{});
    each(there);
    each(content);
  }
  template <typename T>
  void each(std::optional<T>& value) {
    bool there = value.has_value();
    T content = value.value_or(T{});
    each(there);
    each(content);
    value.reset();
    if (there) {
      value.emplace(content);
    }
  }

  template <typename Bits, typename T>
  void plain(T& value) {
    using Value = std::remove_const_t<T>;
    number<sizeof(Bits)>(
        value, [](Value v) { return static_cast<Bits>(v); },
        [](std::uint64_t bits) { return static_cast<Value>(bits); });
  }
  template <std::size_t bytes, typename T, typename ToBits, typename FromBits>
  void number(T& value, ToBits to_bits, FromBits from_bits) {
    static_cast<Derived&>(*this).template value<bytes>(value, to_bits, from_bits);
  }
};

// As put() and get(), in one access instead of one for every byte: a record of 50 signals crosses in every tick.
static_assert(std::endian::native == std::endian::little);
template <std::size_t bytes>
using Word = std::conditional_t<
    bytes == 1, std::uint8_t,
    std::conditional_t<bytes == 2, std::uint16_t, std::conditional_t<bytes == 4, std::uint32_t, std::uint64_t>>>;
template <std::size_t bytes>
void store(std::byte* out, std::uint64_t number) {
  const auto word = static_cast<Word<bytes>>(number);
  std::memcpy(out, &word, sizeof word);
}
template <std::size_t bytes>
[[nodiscard]] std::uint64_t load(const std::byte* in) {
  Word<bytes> word;
  std::memcpy(&word, in, sizeof word);
  return word;
}

/// Writes into a buffer. What finds no room is left out, and ok() is false.
class HilWriter : public HilVisitor<HilWriter> {
 public:
  explicit HilWriter(std::span<std::byte> out) : out_{out} {}

  /// So many bytes, after their number.
  void bytes(std::span<const std::byte> bytes) {
    append<2>(bytes.size());
    if (ok_ && bytes.size() <= out_.size() - size_) {
      std::ranges::copy(bytes, out_.begin() + static_cast<std::ptrdiff_t>(size_));
      size_ += bytes.size();
    } else {
      ok_ = false;
    }
  }
  void text(std::string_view text) { bytes(std::as_bytes(std::span{text})); }

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  friend HilVisitor;
  template <typename T>
  static const T& seen(const T& value) {
    return value;
  }
  template <std::size_t bytes>
  void append(std::uint64_t number) {
    if (bytes > out_.size() - size_) {
      ok_ = false;
      return;
    }
    store<bytes>(out_.data() + size_, number);
    size_ += bytes;
  }
  template <std::size_t bytes, typename T, typename ToBits, typename FromBits>
  void value(const T& value, ToBits to_bits, FromBits) {
    append<bytes>(to_bits(value));
  }

  std::span<std::byte> out_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

/// Reads what a writer wrote, in the same order. Beyond the end everything is zero, and ok() is false.
class HilReader : public HilVisitor<HilReader> {
 public:
  explicit HilReader(std::span<const std::byte> in) : in_{in} {}

  [[nodiscard]] std::span<const std::byte> bytes() {
    const auto count = static_cast<std::size_t>(take<2>());
    ok_ = ok_ && count <= in_.size() - at_;
    const auto part = ok_ ? in_.subspan(at_, count) : std::span<const std::byte>{};
    at_ += part.size();
    return part;
  }
  [[nodiscard]] std::string_view text() {
    const auto part = bytes();
    return {reinterpret_cast<const char*>(part.data()), part.size()};
  }

  /// Nothing was missing so far.
  [[nodiscard]] bool within() const { return ok_; }
  /// After everything has been read.
  [[nodiscard]] bool ok() const { return ok_ && at_ == in_.size(); }

 private:
  friend HilVisitor;
  template <typename T>
  static T& seen(T& value) {
    return value;
  }
  template <std::size_t bytes>
  std::uint64_t take() {
    if (bytes > in_.size() - at_) {
      ok_ = false;
      return 0;
    }
    const std::uint64_t number = load<bytes>(in_.data() + at_);
    at_ += bytes;
    return number;
  }
  template <std::size_t bytes, typename T, typename ToBits, typename FromBits>
  void value(T& value, ToBits, FromBits from_bits) {
    value = from_bits(take<bytes>());
  }

  std::span<const std::byte> in_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

/// What a layout is known by: changes when a signal comes, goes, or changes its name, its unit or its width.
class HilLayout : public HilVisitor<HilLayout> {
 public:
  template <typename T>
  void operator()(const core::SignalName& name, T& value) {
    mix(name.name);
    mix(name.unit);
    (*this)(value);
  }
  using HilVisitor::operator();

  [[nodiscard]] std::uint32_t hash() const { return hash_; }

 private:
  friend HilVisitor;
  template <typename T>
  static const T& seen(const T& value) {
    return value;
  }
  void mix(std::uint32_t word) { hash_ = (hash_ ^ word) * 16777619U; }  // FNV-1a
  void mix(std::string_view text) {
    for (const char c : text) {
      mix(static_cast<std::uint8_t>(c));
    }
    mix(0xFFU);
  }
  template <std::size_t bytes, typename T, typename ToBits, typename FromBits>
  void value(const T&, ToBits, FromBits) {
    mix(std::uint32_t{bytes});
  }

  std::uint32_t hash_ = 2166136261U;
};

/// What a tick's record has of it on the link: its signals, and the gyro's zero, which is none.
template <typename Record, typename Visitor>
void visit_record(Record& record, Visitor& visit) {
  core::visit_signals(record, visit);
  auto& bias = record.motion.gyro_bias_rad_s;
  visit(core::SignalName{"gyro_bias_x", "rad_s"}, bias.x);
  visit(core::SignalName{"gyro_bias_y", "rad_s"}, bias.y);
  visit(core::SignalName{"gyro_bias_z", "rad_s"}, bias.z);
}

/// Of a tick's record.
[[nodiscard]] inline std::uint32_t record_layout() {
  const core::TickRecord record{};
  HilLayout layout;
  visit_record(record, layout);
  return layout.hash();
}

}  // namespace fantail::protocol
