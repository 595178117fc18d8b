// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace fantail::tool
