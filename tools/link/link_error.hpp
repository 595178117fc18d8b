// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace fantail::link {

/// The avionics does not answer, refuses, or has ended the session. what() says it for a person.
class LinkError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// More than one avionics reports on the bus, so no report says which rocket it is about.
class TwoRockets : public LinkError {
  using LinkError::LinkError;
};

}  // namespace fantail::link
