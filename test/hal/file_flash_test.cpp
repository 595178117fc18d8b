// SPDX-License-Identifier: MIT
#include "hal/linux/file_flash.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "test.hpp"

namespace fantail::hal::on_linux {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

constexpr FlashGeometry small{.size = 65'536, .sector_size = 4096, .page_size = 256};

struct FileFlashTest : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("fantail_flash_" + std::to_string(::getpid()));
  fs::path path = folder / "flash.bin";

  FileFlashTest() { fs::create_directories(folder); }
  ~FileFlashTest() override { fs::remove_all(folder); }

  // The message with the folder taken off.
  std::string refusal(const fs::path& name, const FlashGeometry& geometry = small) {
    try {
      const FileFlash flash{folder / name, geometry};
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(folder.string()), 0U);
      return message.substr(std::min(message.size(), folder.string().size() + 1));
    }
    return "not refused";
  }
};

Bytes content(FileFlash& flash) {
  Bytes all(flash.geometry().size);
  EXPECT_EQ(flash.read(0, all), FlashResult::ok);
  return all;
}

TEST_F(FileFlashTest, ANewFileIsABlankFlashThatTakesNoRoomOnTheDisk) {
  FileFlash flash{path};
  EXPECT_EQ(flash.geometry().size, 16'777'216U);
  const Bytes all = content(flash);
  EXPECT_TRUE(std::ranges::all_of(all, [](std::byte byte) { return byte == std::byte{0xFF}; }));
  EXPECT_EQ(fs::file_size(path), 16'777'216U);
  struct stat status{};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_LT(status.st_blocks, 64) << "512 bytes each";
}

TEST_F(FileFlashTest, BehavesLikeNor) {
  FileFlash flash{path, small};
  const Bytes page(256, std::byte{0x3C});
  EXPECT_EQ(flash.program(4096, page), FlashResult::ok);
  EXPECT_FALSE(flash.busy());
  EXPECT_EQ(flash.program(4096, Bytes(1, std::byte{0x0F})), FlashResult::ok);
  EXPECT_EQ(flash.program(4097, page), FlashResult::out_of_range);
  EXPECT_EQ(flash.erase_sector(256), FlashResult::out_of_range);
  Bytes expected(small.size, std::byte{0xFF});
  std::ranges::copy(page, expected.begin() + 4096);
  expected[4096] = std::byte{0x0C};
  EXPECT_EQ(content(flash), expected);
  EXPECT_EQ(flash.erase_sector(4096), FlashResult::ok);
  EXPECT_EQ(content(flash), Bytes(small.size, std::byte{0xFF}));
}

TEST_F(FileFlashTest, KeepsWhatItHoldsUntilTheNextTime) {
  Bytes expected;
  {
    FileFlash flash{path, small};
    EXPECT_EQ(flash.program(512, Bytes(100, std::byte{0x42})), FlashResult::ok);
    EXPECT_EQ(flash.program(8192, Bytes(256, std::byte{0x00})), FlashResult::ok);
    EXPECT_EQ(flash.program(12'288, Bytes(256, std::byte{0x00})), FlashResult::ok);
    EXPECT_EQ(flash.erase_sector(8192), FlashResult::ok);
    expected = content(flash);
  }
  EXPECT_EQ(expected[512], std::byte{0x42});
  EXPECT_EQ(expected[8192], std::byte{0xFF});
  FileFlash again{path, small};
  EXPECT_EQ(content(again), expected);
}

TEST_F(FileFlashTest, AProcessThatIsKilledHasKeptWhatItProgrammed) {
  const pid_t child = ::fork();
  if (child == 0) {
    FileFlash flash{path, small};
    flash.program(0, Bytes(256, std::byte{0x11}));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  FileFlash flash{path, small};  // and the lock went with the process
  EXPECT_EQ(content(flash)[255], std::byte{0x11});
}

TEST_F(FileFlashTest, TheFlashOfARunningProcessIsRefused) {
  auto first = std::make_unique<FileFlash>(path, small);
  EXPECT_EQ(refusal("flash.bin"), "flash.bin: is the flash of another process that is running");
  first.reset();
  EXPECT_EQ(refusal("flash.bin"), "not refused");
}

TEST_F(FileFlashTest, AFileOfAnotherSizeIsRefusedAndLeftAlone) {
  std::ofstream{path} << "a letter to a friend";
  EXPECT_EQ(refusal("flash.bin"), "flash.bin: has 20 bytes, and the flash has 65536; is it another file?");
  EXPECT_EQ(fs::file_size(path), 20U);
  {
    const FileFlash flash{folder / "other.bin", small};
  }
  EXPECT_EQ(refusal("other.bin", {.size = 131'072, .sector_size = 4096, .page_size = 256}),
            "other.bin: has 65536 bytes, and the flash has 131072; is it another file?");
}

TEST_F(FileFlashTest, WhatCannotBeMadeOrIsNoFileIsNamed) {
  EXPECT_EQ(refusal("no/such/folder"), "no/such/folder: No such file or directory");
  fs::create_directory(folder / "folder");
  EXPECT_EQ(refusal("folder"), "folder: Is a directory");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe"), "pipe: is not a file");
  EXPECT_EQ(refusal("flash.bin", {.size = 1000, .sector_size = 4096, .page_size = 256}),
            "flash.bin: a flash is a whole number of sectors, and a sector a whole number of pages");
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(FileFlashTest, ADiskThatTakesNoMoreIsAFlashThatFailsForGood) {
  FileFlash flash{path, small};
  EXPECT_EQ(flash.program(0, Bytes(16)), FlashResult::ok);
  // A limit on the size of files stands for a full disk: both make pwrite fail.
  auto* const before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit tight{.rlim_cur = 4096, .rlim_max = limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  const FlashResult result = flash.program(8192, Bytes(16));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, before);
  EXPECT_EQ(result, FlashResult::failed);
  Bytes out(1);
  EXPECT_EQ(flash.read(0, out), FlashResult::failed);
  EXPECT_EQ(flash.program(0, out), FlashResult::failed);
  EXPECT_EQ(flash.erase_sector(0), FlashResult::failed);
}

}  // namespace
}  // namespace fantail::hal::on_linux
