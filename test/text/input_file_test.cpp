// SPDX-License-Identifier: MIT
#include "text/input_file.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include <sys/stat.h>

#include "system/folder.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::text {
namespace {

using namespace std::chrono_literals;

class InputFileTest : public testing::Test {
 protected:
  InputFileTest() { std::signal(SIGPIPE, SIG_IGN); }
  ~InputFileTest() override { check_while_reading(nullptr); }

  [[nodiscard]] std::string pipe() const {
    std::string path = folder_ / "pipe";
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    return path;
  }
  /// What is said of it, without its name in front.
  static std::string refusal(const std::string& path, ErrorKind kind, InputKind read_as = InputKind::data) {
    try {
      (void)read_input(path, read_as);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with(path + ": ")) << what;
      return what.substr(std::min(what.size(), path.size() + 2));
    }
    return "read";
  }

  test::Folder folder_;
};

TEST_F(InputFileTest, IsReadWhole) {
  std::string text(300'000, 'x');
  text += std::string{"\0\xFF\n", 3};
  EXPECT_EQ(read_input(folder_.write("a", text)), text);
  EXPECT_EQ(read_input(folder_.write("b", "")), "");
  EXPECT_EQ(read_if_there(folder_ / "b"), "");
  EXPECT_EQ(read_if_there(folder_ / "c"), std::nullopt);
  const InputBytes bytes = read_input_bytes(folder_ / "a");
  ASSERT_EQ(bytes.size, text.size());
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.bytes.get()), bytes.size), text);
  EXPECT_FALSE(read_input("/proc/self/status").empty()) << "a file that says that it is empty";
}

TEST_F(InputFileTest, OfAPipeIsAllThatAWriterPutsIntoIt) {
  const std::string path = pipe();
  const std::string text(1'000'000, 'y');
  std::jthread writer{[&] {
    std::this_thread::sleep_for(300ms);  // it is waited for
    std::ofstream{path} << text;
  }};
  EXPECT_EQ(read_input(path), text);
}

TEST_F(InputFileTest, WhatIsNoFileIsSaidToBeWhatItIs) {
  EXPECT_EQ(refusal(folder_ / "none", ErrorKind::no_such_input), "no such file");
  EXPECT_EQ(refusal(folder_.write("file", "") + "/below", ErrorKind::no_such_input), "no such file");
  EXPECT_EQ(refusal(folder_.path().string(), ErrorKind::no_such_input), "is a folder, not a file");
  for (const char* device : {"/dev/zero", "/dev/null", "/dev/random"}) {
    EXPECT_EQ(refusal(device, ErrorKind::no_such_input), "is a device, not a file; copy the data you need into a file");
  }
  EXPECT_EQ(refusal(pipe(), ErrorKind::no_such_input, InputKind::document),
            "is a pipe, which can be read only once; save its content to a file and give that");
  EXPECT_EQ(read_if_there("/dev/null/x"), std::nullopt);
}

TEST_F(InputFileTest, ThatIsLargerThanItsKindIsRefusedWithoutBeingRead) {
  const std::string path = folder_.write("large", "");
  std::filesystem::resize_file(path, (16U << 20U) + 1);  // without taking room on the disk
  EXPECT_EQ(refusal(path, ErrorKind::bad_data, InputKind::document),
            "larger than 16 MiB, which is too large for this kind of file; check the path");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40U);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(refusal(path, ErrorKind::bad_data),
            "larger than 512 MiB, the most that is read of one file; give the part that you need");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
}

TEST_F(InputFileTest, OfAPipeWithoutAnEndIsRefusedAtTheLimit) {
  const std::string path = pipe();
  std::jthread writer{[&] {
    std::ofstream stream{path};
    const std::string much(1U << 20U, 'z');
    for (int i = 0; i < 600 && stream; ++i) {
      stream << much;
    }
  }};
  EXPECT_TRUE(refusal(path, ErrorKind::bad_data).starts_with("larger than 512 MiB"));
}

// Each time the writer is a little further: what was read is neither the file before nor the file after.
TEST_F(InputFileTest, ThatGrowsMeanwhileIsSaidTo) {
  const std::string path = folder_.write("growing", std::string(50U << 20U, 'g'));
  std::atomic<bool> is_read = false;
  std::jthread writer{[&] {
    std::ofstream stream{path, std::ios::app};
    while (!is_read) {
      stream << "more\n" << std::flush;
    }
  }};
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(refusal(path, ErrorKind::bad_data),
            "changed while it was read; wait until no program writes to it, or give a copy");
  is_read = true;
}

TEST_F(InputFileTest, APipeThatNobodyWritesToIsNamedOnce) {
  struct Enough {};
  static std::atomic<int> looks;
  static std::string told;
  looks = 0;
  told = "";
  check_while_reading(
      [] {
        if (++looks > 70) {
          throw Enough{};
        }
      },
      [](const std::string& sentence) { told += std::to_string(looks) + ": " + sentence + "\n"; });
  const std::string path = pipe();
  EXPECT_THROW((void)read_input(path), Enough);
  EXPECT_EQ(told, "50: " + path + " is a pipe that has given no data for 5 s; Ctrl-C ends the wait\n");
}

TEST_F(InputFileTest, NobodyWaitsForAPipeAfterCtrlC) {
  struct CtrlC {};
  static std::atomic<bool> pressed;
  pressed = false;
  check_while_reading([] {
    if (pressed) {
      throw CtrlC{};
    }
  });
  const std::string path = pipe();
  std::jthread hand{[] {
    std::this_thread::sleep_for(200ms);
    pressed = true;
  }};
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW((void)read_input(path), CtrlC) << "before anybody has opened it to write";
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
  // And one whose writer says nothing more.
  pressed = false;
  std::jthread second_hand{[&path] {
    std::ofstream stream{path};
    stream << "a beginning" << std::flush;
    std::this_thread::sleep_for(200ms);
    pressed = true;
    std::this_thread::sleep_for(2s);
  }};
  EXPECT_THROW((void)read_input(path), CtrlC);
}

}  // namespace
}  // namespace fantail::text
