// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace fantail::sim {

/// What kind of thing is wrong with something a person gave us. The command line turns it into its exit code.
enum class InputFault : std::uint8_t {
  no_such_input,      ///< a file or a shipped name that does not exist
  bad_data,           ///< a file whose content cannot be what it claims to be
  bad_configuration,  ///< an unknown key, a value out of range, rules that contradict each other
};

/// Carries one complete sentence for the person: file:line: field, value, what is allowed.
class InputError : public std::runtime_error {
 public:
  InputError(InputFault fault, const std::string& message) : std::runtime_error{message}, fault_{fault} {}
  [[nodiscard]] InputFault fault() const { return fault_; }

 private:
  InputFault fault_;
};

}  // namespace fantail::sim
