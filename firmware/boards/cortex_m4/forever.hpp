// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>
#include <utility>

namespace fantail::boards {

/// Room for one object that is made once and never destroyed: a static variable would bring along the list of what is
/// to be destroyed when the program ends, which on a board it does not.
template <typename T>
class Forever {
 public:
  template <typename... Arguments>
  T& make(Arguments&&... arguments) {
    return *new (room_) T{std::forward<Arguments>(arguments)...};
  }

 private:
  alignas(T) std::byte room_[sizeof(T)];
};

}  // namespace fantail::boards
