// SPDX-License-Identifier: MIT
#include "hal/linux/console.hpp"

#include <chrono>

#include <fcntl.h>
#include <unistd.h>

#include "test.hpp"

namespace fantail::test {
namespace {

/// Standard error is a pipe as long as this lives.
class ErrorPipe {
 public:
  ErrorPipe() : saved_{dup(STDERR_FILENO)} {
    EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0);
    dup2(ends_[1], STDERR_FILENO);
  }
  ~ErrorPipe() {
    dup2(saved_, STDERR_FILENO);
    close(saved_);
    close(ends_[0]);
    close(ends_[1]);
  }
  ErrorPipe(const ErrorPipe&) = delete;
  ErrorPipe& operator=(const ErrorPipe&) = delete;

  std::string read_all() {
    fcntl(ends_[0], F_SETFL, O_NONBLOCK);
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t count = 0; (count = read(ends_[0], part.data(), part.size())) > 0;) {
      text.append(part.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int saved_;
  std::array<int, 2> ends_{};
};

TEST(LinuxConsole, WritesToStandardError) {
  ErrorPipe pipe;
  hal::on_linux::Console console;
  console.write("one\n");
  console.write("");
  console.write("two\n");
  EXPECT_EQ(pipe.read_all(), "one\ntwo\n");
}

TEST(LinuxConsole, DropsWhatDoesNotFitInsteadOfWaiting) {
  ErrorPipe pipe;
  hal::on_linux::Console console;
  const std::string much(1 << 20, 'x');
  console.write(much);  // nobody reads: whoever waited would wait for ever
  console.write("lost");
  const std::string kept = pipe.read_all();
  EXPECT_GT(kept.size(), 0U);
  EXPECT_LT(kept.size(), much.size());
  EXPECT_EQ(kept.find_first_not_of('x'), std::string::npos);
}

}  // namespace
}  // namespace fantail::test
