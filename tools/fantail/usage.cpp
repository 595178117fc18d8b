// SPDX-License-Identifier: MIT
#include "fantail/usage.hpp"

#include <vector>

#include "sim/document.hpp"

namespace fantail::tool {
namespace {

const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.front());
}

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

}  // namespace

std::string usage_complaint(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& app = innermost(program);
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands(nullptr)) {
    verbs.push_back(verb->get_name());
  }
  // CLI11 says only that something is required, whatever stands in its place.
  if (verbs.empty() || dynamic_cast<const CLI::RequiredError*>(&error) == nullptr) {
    return error.what();
  }
  const std::vector<std::string> left_over = program.remaining(true);
  if (left_over.empty()) {
    return "a verb is missing; allowed: " + list(verbs);
  }
  const std::string& word = left_over.front();
  if (word.starts_with('-')) {
    return "unknown option " + word + "; a verb comes first: " + list(verbs);
  }
  const auto meant = sim::suggestion(word, verbs);
  return "unknown verb \"" + word + '"' + (meant ? "; did you mean " + *meant + "?" : "; allowed: " + list(verbs));
}

}  // namespace fantail::tool
