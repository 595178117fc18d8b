// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

#include "core/state_visitor.hpp"

namespace fantail::core {

/// A visitor (core/state_visitor.hpp) that takes every remembered value of one object, and after give() gives them to
/// another.
class StateCopy {
 public:
  template <typename... T>
  void operator()(T&... values) {
    (each(values), ...);
  }
  template <typename... T>
  void below(std::size_t /*limit*/, T&... values) {
    (each(values), ...);
  }
  template <typename... T>
  void on_pad(T&... values) {
    (each(values), ...);
  }
  void give() { gives_ = true; }

 private:
  template <typename T, std::size_t n>
  void each(std::array<T, n>& values) {
    for (T& value : values) {
      each(value);
    }
  }
  template <typename T>
  void each(T& value) {
    if constexpr (RemembersState<T, StateCopy>) {
      value.visit_state(*this);
    } else if (gives_) {
      std::memcpy(static_cast<void*>(&value), &bytes_.at(given_), sizeof value);
      given_ += sizeof value;
    } else {
      const auto* const first = reinterpret_cast<const std::byte*>(&value);
      bytes_.insert(bytes_.end(), first, first + sizeof value);
    }
  }

  std::vector<std::byte> bytes_;
  bool gives_ = false;
  std::size_t given_ = 0;
};

/// `to` goes on from where `from` is.
template <typename Law>
void copy_state(Law& from, Law& to) {
  StateCopy copy;
  from.visit_state(copy);
  copy.give();
  to.visit_state(copy);
}

}  // namespace fantail::core
