// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fantail/command_line.hpp"
#include "text/error.hpp"

namespace fantail::tool {

/// What the program says to a script. The numbers of the errors are those of <sysexits.h>, the
/// last two those that a shell gives to a signal.
enum class ExitCode : int {
  done = 0,
  requirement_not_met = 1,
  usage = 64,
  bad_data = 65,
  no_such_input = 66,
  not_installed = 69,
  internal_error = 70,
  input_output = 74,
  bad_configuration = 78,
  interrupted = 130,
  pipe_closed = 141,
};

/// The program did what it was asked to, and the answer is no. what() is for standard error; it may be empty when the
/// answer has been printed.
class RequirementNotMet : public text::Error {
 public:
  explicit RequirementNotMet(const std::string& message) : Error{text::ErrorKind::requirement_not_met, message} {}
};

/// A verb of the program or library that this is linked into. Its name is one of verb_table.hpp.
struct VerbCode {
  using Describe = void (*)(const Verb& verb);
  VerbCode(const char* its_name, Describe described) noexcept : name{its_name}, fill{described}, next{first} {
    first = this;
  }
  VerbCode(const VerbCode&) = delete;
  VerbCode& operator=(const VerbCode&) = delete;

  const char* name;
  Describe fill;
  const VerbCode* next;  ///< that is linked, or null
  static inline const VerbCode* first = nullptr;
};

/// The whole of a program `fantail-NAME`, which the program `fantail` starts: reads the command line, does what the
/// verb has described, says what went wrong, and returns the exit code.
[[nodiscard]] int run(const VerbCode& verb, int argc, char** argv);

}  // namespace fantail::tool
