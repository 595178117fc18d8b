// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "system/folder.hpp"
#include "system/process.hpp"

namespace fantail::test {

using Words = std::vector<std::string>;

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
    for (const std::string& part : said) {
      EXPECT_NE(outcome.err.find(part), std::string::npos) << "not said: " << part << "\n" << outcome.err;
    }
    EXPECT_EQ(folder.listing(), before);
  }
};

}  // namespace fantail::test
