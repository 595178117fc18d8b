// SPDX-License-Identifier: MIT
#include "flight/fly_command.hpp"

#include "text/quoting.hpp"

namespace fantail::flight {

std::string fly_command(const std::string& scenario, const std::vector<std::string>& changes) {
  std::string command = "fantail fly " + text::shell_word(scenario);
  for (const std::string& change : changes) {
    const bool is_option = change.starts_with("seed=") || change.starts_with("trajectory=");
    command += is_option ? " --" : " --set ";
    command += text::shell_word(change);
  }
  return command;
}

}  // namespace fantail::flight
