// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "link/log_download.hpp"
#include "system/folder.hpp"
#include "text/output_folder.hpp"

namespace fantail::link {
namespace {

std::vector<std::byte> bytes(std::size_t count, int first) {
  std::vector<std::byte> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = static_cast<std::byte>(static_cast<std::size_t>(first) + i);
  }
  return out;
}

TEST(LogPart, GoesOnWhereTheOneBeforeItEndedAndGoesAwayWhenItIsDone) {
  const test::Folder folder;
  const std::string path = folder / "deep/er/record.part";
  {
    LogPart part{path};
    EXPECT_EQ(part.size(), 0U);
    part.append(bytes(300, 1));
  }
  LogPart part{path};
  EXPECT_EQ(part.size(), 300U);
  part.append(bytes(100, 7));
  EXPECT_EQ(part.size(), 400U);
  EXPECT_EQ(part.read(0, 300), bytes(300, 1));
  EXPECT_EQ(part.read(300, 100), bytes(100, 7));
  EXPECT_THROW((void)part.read(301, 100), text::OutputError);
  part.start_anew();
  EXPECT_EQ(part.size(), 0U);
  part.append(bytes(5, 9));
  EXPECT_EQ(part.read(0, 5), bytes(5, 9));
  part.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(LogPart, AFolderThatCannotBeMadeAndADiskThatIsFullAreNamed) {
  const test::Folder folder;
  (void)folder.write("file", "");
  EXPECT_THROW(LogPart{folder / "file/record.part"}, text::OutputError);
  if (std::filesystem::exists("/dev/full")) {
    LogPart full{"/dev/full"};
    try {
      full.append(bytes(10, 0));
      FAIL() << "a full disk took it";
    } catch (const text::OutputError& error) {
      EXPECT_EQ(std::string{error.what()}, "/dev/full: No space left on device");
    }
  }
}

}  // namespace
}  // namespace fantail::link
