// SPDX-License-Identifier: MIT
#include "fantail/many_flights.hpp"

#include <fmt/core.h>

#include "avionics/identity.hpp"
#include "fantail/progress.hpp"
#include "text/input_file.hpp"

namespace fantail::tool {

namespace fs = std::filesystem;

std::string program_that_flies() { return fmt::format("{} ({})", FANTAIL_VERSION, avionics::git_hash()); }

runs::Place place_of_flights(const std::string& verb, const std::string& command, const fs::path& folder,
                             const std::vector<fs::path>& files) {
  std::string digests;
  for (const fs::path& file : files) {
    digests += runs::short_digest(text::read_input(file));
  }
  return {.folder = folder,
          .parts = verb + "_parts",
          .identity = {{"kind", verb},
                       {"program", program_that_flies()},
                       {"command", command},
                       {"files", runs::short_digest(digests)}},
          .replaces_others = true};
}

void leave_if_interrupted(const fs::path& folder, const std::string& kept) {
  if (!take_interrupt()) {
    return;
  }
  std::error_code ignored;
  const bool is_any_kept =
      runs::has_parts({.folder = folder, .parts = kept}) || fs::is_regular_file(folder / kept, ignored);
  throw Interrupted{is_any_kept
                        ? fmt::format("interrupted; finished flights are kept in {}, and the same command goes on "
                                      "from there",
                                      folder.string())
                        : "interrupted before the first flights were finished and kept"};
}

}  // namespace fantail::tool
