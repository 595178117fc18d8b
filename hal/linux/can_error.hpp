// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace fantail::hal::on_linux {

/// There is no bus to use; the message names the interface and tells what to do.
class CanError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fantail::hal::on_linux
