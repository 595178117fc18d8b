// SPDX-License-Identifier: MIT
#include "input/file_text.hpp"

#include <gtest/gtest.h>

#include "scratch_file.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

TEST(FileText, IsAllThatStandsInTheFile) {
  const std::string content{"a = 1\r\n\0\xff\n", 10};
  EXPECT_EQ(file_text(ScratchFile{content}.path()), content);
  EXPECT_EQ(file_text(ScratchFile{""}.path()), "");
}

TEST(FileText, IsNoneOfWhatIsNoFile) {
  EXPECT_EQ(file_text("/nowhere/a.toml"), std::nullopt);
  EXPECT_THROW((void)file_text("/"), text::Error) << "a folder";
}

}  // namespace
}  // namespace fantail::input
