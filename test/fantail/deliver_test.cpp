// SPDX-License-Identifier: MIT
#include "fantail/deliver.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;

// The digest of "abc" is the example of FIPS 180-4. A log that somebody has moved away costs no result.
TEST(Made, HashesTheFilesThatAreThereAndOnlyThose) {
  const fs::path folder = fs::path{testing::TempDir()} / "made_with";
  fs::create_directories(folder);
  std::ofstream{folder / "plan.toml"} << "abc";
  const result::Made made = made_with({folder / "plan.toml", folder / "moved_away.csv", folder, ""}, 7, {"a.b=c"});
  ASSERT_EQ(made.inputs.size(), 1U);
  EXPECT_EQ(made.inputs[0].file, "plan.toml");
  EXPECT_EQ(made.inputs[0].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(made.seed, 7U);
  EXPECT_EQ(made.changes, std::vector<std::string>{"a.b=c"});
  fs::remove_all(folder);
}

}  // namespace
}  // namespace fantail::tool
