// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace fantail::tool {

/// The program did what it was asked to, and the answer is no. what() is for standard error; it may be empty when the
/// answer has been printed.
class RequirementNotMet : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fantail::tool
