// SPDX-License-Identifier: MIT
#pragma once

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "test.hpp"

namespace fantail::test {

using Words = std::vector<std::string>;

/// Each part stands in the text.
inline void expect_said(const std::string& text, const Words& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "not said: " << part << "\n" << text;
  }
}

/// Files in a fresh folder, a command run in it, and what must come of it: nothing on standard output, no new file.
struct Refusal {
  Refusal(const std::vector<std::pair<std::string, std::string>>& files, const Words& words, int exit_code,
          const std::vector<std::string>& said) {
    const Folder folder;
    for (const auto& [name, text] : files) {
      folder.write(name, text);
    }
    const Words before = folder.listing();
    const Outcome outcome = fantail(words, {.working_folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err << "signal " << outcome.signal;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("fantail: ")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << "one line: " << outcome.err;
    expect_said(outcome.err, said);
    EXPECT_EQ(folder.listing(), before);
  }
};

/// A command in that folder, which ends with that exit code.
inline Outcome run_in(const Folder& folder, const Words& words, int exit_code = 0) {
  Outcome outcome = fantail(words, {.working_folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, exit_code) << words.front() << ": " << outcome.err;
  return outcome;
}

/// The same, and what it says as JSON.
inline json::Value asked(const Folder& folder, Words words, int exit_code = 0) {
  words.emplace_back("--json");
  return json::parse(run_in(folder, words, exit_code).out);
}

}  // namespace fantail::test
