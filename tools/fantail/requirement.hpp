// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "text/error.hpp"

namespace fantail::tool {

/// The program did what it was asked to, and the answer is no. what() is for standard error; it may be empty when the
/// answer has been printed.
class RequirementNotMet : public text::Error {
 public:
  explicit RequirementNotMet(const std::string& message) : Error{text::ErrorKind::requirement_not_met, message} {}
};

}  // namespace fantail::tool
