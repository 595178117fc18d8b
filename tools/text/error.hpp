// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "text/quoting.hpp"

namespace fantail::text {

/// Why a program ends without having done what it was asked to. The command line turns it into its exit code.
enum class ErrorKind : std::uint8_t {
  usage,                ///< words on the command line that contradict each other or say nothing
  no_such_input,        ///< a file or a shipped name that does not exist
  bad_data,             ///< a file whose content cannot be what it claims to be
  bad_configuration,    ///< an unknown key, a value out of range, rules that contradict each other
  requirement_not_met,  ///< it was done, and the answer is no
  interrupted,
};

/// Carries one complete sentence for the person: file:line: field, value, what is allowed. It may quote what stands in
/// a file: whatever of it is no printable character becomes a question mark, so that no file writes to a terminal. What
/// fails outside of the program (a disk, a bus, a network, a flight computer) is another std::runtime_error.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error{printable(message)}, kind_{kind} {}
  [[nodiscard]] ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// A file that cannot be what it claims to be.
[[noreturn]] inline void refuse(const std::string& complaint) { throw Error{ErrorKind::bad_data, complaint}; }

}  // namespace fantail::text
