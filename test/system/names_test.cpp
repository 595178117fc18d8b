// SPDX-License-Identifier: MIT
// Names that another computer has given: bytes that are not UTF-8.
#include <filesystem>

#include <gtest/gtest.h>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "text/quoting.hpp"

namespace fantail::test {
namespace {

using Words = std::vector<std::string>;

// Where a text is no UTF-8, or holds what no page may have; npos: nowhere.
std::size_t first_wrong(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const bool is_space = text[at] == '\n' || text[at] == '\t' || text[at] == '\r';
    const std::size_t length = is_space ? 1 : text::printable_character(text.substr(at));
    if (length == 0) {
      return at;
    }
    at += length;
  }
  return std::string::npos;
}

void expect_texts(const Folder& folder, const std::string& below, std::size_t pages) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder.path() / below}) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".html" && ending != ".json" && ending != ".csv" && ending != ".toml") {
      continue;
    }
    const std::string text = content(entry.path());
    const std::size_t at = first_wrong(text);
    EXPECT_EQ(at, std::string::npos) << entry.path() << ": " << text::printable(text.substr(at, 20));
    if (ending == ".json") {
      EXPECT_NO_THROW((void)json::parse(text));
    }
    pages -= ending == ".html" && text.find("\uFFFD stands for a byte that is not text in UTF-8") != std::string::npos
                 ? 1
                 : 0;
  }
  EXPECT_EQ(pages, 0U) << "pages that say what \uFFFD is";
}

const std::string odd =
    "fl\xFC"
    "g";

TEST(Names, ThatAreNoUtf8MakePagesThatAreAndSaySo) {
  const Folder folder;
  const auto done = [&](const Words& words) {
    const Outcome outcome = fantail(words, {.working_folder = folder.path()});
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err;
    EXPECT_EQ(first_wrong(outcome.err), std::string::npos) << outcome.err;
    return outcome;
  };
  folder.write(odd + ".toml", "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n");
  done({"fly", odd + ".toml", "--out", odd});
  expect_texts(folder, odd, 1);
  std::filesystem::copy_file(folder.path() / odd / "flight.csv", folder.path() / (odd + ".csv"));
  done({"identify", odd + ".csv", "--vehicle", "tasha3_launch2", "--window", "1:8", "--out", "identified"});
  expect_texts(folder, "identified", 1);
  done({"listen", odd + ".csv", "--out", "heard"});
  expect_texts(folder, "heard", 1);
  done({"report", odd, odd + ".csv", "--out", "two"});
  expect_texts(folder, "two", 1);
  done({"airframe", "tasha3_launch2", "--out", odd + "_airframe"});
  expect_texts(folder, odd + "_airframe", 0);  // where it is written is not on it
  const Outcome info = done({"log", "info", odd, "--json"});
  EXPECT_EQ(first_wrong(info.out), std::string::npos);
  (void)json::parse(info.out);
}

TEST(Names, OfColumnsThatAreNoUtf8DoNotSpoilAPage) {
  const Folder folder;
  std::string log = "time_s,roll_rate_deg_s,accel_x,temp\xE9rature\n";
  for (int i = 0; i < 300; ++i) {
    log += std::to_string(0.01 * i) + ",1,9.81,20\n";
  }
  folder.write("log.csv", log);
  const Outcome outcome = fantail({"listen", "log.csv", "--out", "heard"}, {.working_folder = folder.path()});
  EXPECT_EQ(first_wrong(outcome.err), std::string::npos) << outcome.err;
  if (std::filesystem::exists(folder.path() / "heard")) {
    expect_texts(folder, "heard", 1);
  }
}

}  // namespace
}  // namespace fantail::test
