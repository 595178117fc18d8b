// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fantail/command_line.hpp"
#include "text/error.hpp"

namespace fantail::tool {

/// What the program says to a script. The numbers of the errors are those of <sysexits.h>.
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
};

/// The program did what it was asked to, and the answer is no. what() is for standard error; it may be empty when the
/// answer has been printed.
class RequirementNotMet : public text::Error {
 public:
  explicit RequirementNotMet(const std::string& message) : Error{text::ErrorKind::requirement_not_met, message} {}
};

/// The whole of a program `fantail-NAME`, which the program `fantail` starts: reads the command line, does what `fill`
/// has described, says what went wrong, and returns the exit code. The name is one of verb_table.hpp.
[[nodiscard]] int run(const char* name, void (*fill)(const Verb& verb), int argc, char** argv);

}  // namespace fantail::tool
