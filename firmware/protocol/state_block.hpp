// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/angle.hpp"
#include "core/finite.hpp"
#include "core/state_visitor.hpp"
#include "core/time.hpp"
#include "core/vector3.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

// What the flight law remembers (core/state_visitor.hpp) as bytes, little-endian and the same on every processor: float
// 4 bytes, std::uint32_t 4, time 8, flag 1, enumeration or index 1, an optional its flag and its value. Every state of
// one version of the law and one plan has one size and one layout: a law that flies on two gyros remembers more.

enum class StateExtent : std::uint8_t {
  whole,      ///< a law that is given it goes on bit for bit
  in_flight,  ///< without what is of use on the pad only: two fifths of the whole
};

/// Common to the three visitors: takes a value apart until only plain ones are left, which Derived::plain() is given.
template <typename Derived>
class StateVisitor {
 public:
  explicit StateVisitor(StateExtent extent = StateExtent::whole) : extent_{extent} {}

  template <typename... T>
  void operator()(T&... values) {
    (each(values), ...);
  }

  template <typename... T>
  void below(std::size_t limit, T&... values) {
    (derived().small(limit, values), ...);
  }

  template <typename... T>
  void on_pad(T&... values) {
    if (extent_ == StateExtent::whole) {
      (each(values), ...);
    }
  }

 private:
  Derived& derived() { return static_cast<Derived&>(*this); }

  template <typename T>
  void each(T& value) {
    constexpr bool is_plain = requires { derived().plain(value); };
    if constexpr (!is_plain && core::RemembersState<T, Derived>) {
      value.visit_state(derived());
    } else {
      derived().plain(value);
    }
  }
  template <typename T, std::size_t n>
  void each(std::array<T, n>& values) {
    for (T& value : values) {
      each(value);
    }
  }
  template <typename T>
  void each(std::optional<T>& value) {
    bool there = value.has_value();
    derived().plain(there);
    T content = value.value_or(T{});
    each(content);
    derived().replace(value, there, content);
  }

  StateExtent extent_;
};

/// Of the values of a state those that begin in these bytes of it.
struct StatePart {
  std::size_t begin = 0;
  std::size_t size = std::numeric_limits<std::size_t>::max();
};

/// Writes a state, or a part of it to its place in the whole. Other values, and bytes beyond the room, are counted and
/// not written.
class StateWriter : public StateVisitor<StateWriter> {
 public:
  explicit StateWriter(std::span<std::byte> out, StateExtent extent = StateExtent::whole, StatePart part = {})
      : StateVisitor{extent}, out_{out}, part_{part} {}
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  friend StateVisitor;
  // Called, not written in: there are hundreds of values, and the image has no room for as many copies.
  template <std::size_t bytes>
  [[gnu::noinline]] void append(WordOf<bytes> value) {
    if (wanted(bytes)) {
      put<bytes>(out_, size_, value);
    }
    size_ += bytes;
  }
  [[nodiscard]] bool wanted(std::size_t bytes) const {
    return size_ - part_.begin < part_.size && size_ + bytes <= out_.size();  // what lies before the part wraps round
  }
  void plain(float value) { append<4>(std::bit_cast<std::uint32_t>(value)); }
  // Most of a state are vectors: at once what three floats would be.
  [[gnu::noinline]] void plain(const core::Vector3& value) {
    if (wanted(12)) {
      put<4>(out_, size_, std::bit_cast<std::uint32_t>(value.x));
      put<4>(out_, size_ + 4, std::bit_cast<std::uint32_t>(value.y));
      put<4>(out_, size_ + 8, std::bit_cast<std::uint32_t>(value.z));
    }
    size_ += 12;
  }
  void plain(core::Angle value) { plain(value.radians()); }
  void plain(std::uint32_t value) { append<4>(value); }
  void plain(core::Microseconds value) { append<8>(static_cast<std::uint64_t>(value.count())); }
  void plain(bool value) { append<1>(value ? 1 : 0); }
  template <typename T>
  void small(std::size_t, T value) {
    append<1>(static_cast<std::uint8_t>(value));
  }
  template <typename T>
  static void replace(const std::optional<T>&, bool, const T&) {}

  std::span<std::byte> out_;
  StatePart part_;
  std::size_t size_ = 0;
};

/// Reads a state back. A state that the law could not have had (an index beyond its array, a number that is none, a
/// time of 140000 years, another size) makes ok() false, and then what was read into must not be used.
class StateReader : public StateVisitor<StateReader> {
 public:
  explicit StateReader(std::span<const std::byte> in, StateExtent extent = StateExtent::whole)
      : StateVisitor{extent}, in_{in} {}
  /// After the visit.
  [[nodiscard]] bool ok() const { return ok_ && at_ == in_.size(); }

 private:
  friend StateVisitor;
  template <std::size_t bytes>
  std::uint64_t take() {
    const bool there = at_ + bytes <= in_.size();
    const std::uint64_t value = there ? get<bytes>(in_, at_) : 0;
    ok_ = ok_ && there;
    at_ += bytes;
    return value;
  }
  void plain(float& value) {
    constexpr float largest = 1e9F;  // far beyond every sum that the law makes, and it converts to an integer
    value = take_number(largest);
  }
  // An angle may be that of an encoder, and the law takes any that is a number.
  void plain(core::Angle& value) { value = core::Angle::from_radians(take_number(std::numeric_limits<float>::max())); }
  float take_number(float largest) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(take<4>()));
    const bool fits = core::is_within(value, largest);
    ok_ = ok_ && fits;
    return fits ? value : 0.0F;
  }
  void plain(std::uint32_t& value) { value = static_cast<std::uint32_t>(take<4>()); }
  void plain(core::Microseconds& value) {
    constexpr std::int64_t largest = std::int64_t{1} << 62U;  // two of them can be added or subtracted
    const auto count = static_cast<std::int64_t>(take<8>());
    ok_ = ok_ && count > -largest && count < largest;
    value = core::Microseconds{ok_ ? count : 0};
  }
  void plain(bool& value) {
    const std::uint64_t byte = take<1>();
    ok_ = ok_ && byte <= 1;
    value = byte == 1;
  }
  template <typename T>
  void small(std::size_t limit, T& value) {
    const std::uint64_t byte = take<1>();
    ok_ = ok_ && byte < limit;
    value = static_cast<T>(byte < limit ? byte : 0);
  }
  template <typename T>
  static void replace(std::optional<T>& value, bool there, const T& content) {
    value = there ? std::optional{content} : std::nullopt;
  }

  std::span<const std::byte> in_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

/// Gives a law that was just made the state that the bytes are, whole or in flight: the two have different sizes.
/// False, and the law must not be used, when they are neither.
template <typename Law>
[[nodiscard]] bool restore_state(Law& law, std::span<const std::byte> state) {
  StateWriter whole{{}};
  law.visit_state(whole);
  StateReader reader{state, state.size() == whole.size() ? StateExtent::whole : StateExtent::in_flight};
  law.visit_state(reader);
  return reader.ok();
}

/// What a layout is known by: changes when a value comes, goes, or changes its kind or its limit.
class StateLayout : public StateVisitor<StateLayout> {
 public:
  [[nodiscard]] std::uint32_t hash() const { return hash_; }

 private:
  friend StateVisitor;
  void mix(std::uint32_t kind) { hash_ = (hash_ ^ kind) * 16777619U; }  // FNV-1a
  void plain(float) { mix(1); }
  void plain(core::Angle) { mix(2); }
  void plain(std::uint32_t) { mix(3); }
  void plain(core::Microseconds) { mix(4); }
  void plain(bool) { mix(5); }
  template <typename T>
  void small(std::size_t limit, T) {
    mix(6);
    mix(static_cast<std::uint32_t>(limit));
  }
  template <typename T>
  void replace(const std::optional<T>&, bool, const T&) {
    mix(7);
  }

  std::uint32_t hash_ = 2166136261U;
};

}  // namespace fantail::protocol
