// SPDX-License-Identifier: MIT
#include "avionics/abort_input.hpp"

namespace fantail::avionics {

protocol::AbortState abort_state(core::AbortInput input, const hal::Contact& contact) {
  using enum protocol::AbortState;
  if (input == core::AbortInput::none) {
    return none_fitted;
  }
  if (!contact.open() && !contact.closed()) {
    return unsettled;
  }
  return contact.open() == (input == core::AbortInput::open_aborts) ? asks_to_abort : ready;
}

}  // namespace fantail::avionics
