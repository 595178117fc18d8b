// SPDX-License-Identifier: MIT
#include "fantail/card_output.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <fmt/core.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "report/card_text.hpp"

namespace fantail::tool {
namespace {

constexpr const char* program = "rsvg-convert";

[[noreturn]] void cannot(const std::string& why) {
  throw std::runtime_error{fmt::format(
      "--card: {}, which draws the card, {}; it comes with the Debian package librsvg2-bin, and its letters "
      "with fonts-dejavu-core",
      program, why)};
}

/// A file that is nowhere but in memory.
class MemoryFile {
 public:
  MemoryFile() : number_{::memfd_create("card", MFD_CLOEXEC)} {
    if (number_ < 0) {
      throw std::runtime_error{fmt::format("--card: no memory for it: {}", std::strerror(errno))};
    }
  }
  ~MemoryFile() { ::close(number_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int number() const { return number_; }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = ::write(number_, text.data(), text.size());
      if (written <= 0) {
        throw std::runtime_error{fmt::format("--card: no memory for it: {}", std::strerror(errno))};
      }
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(number_, 0, SEEK_SET);
  }

  [[nodiscard]] std::string content() const {
    std::string all(static_cast<std::size_t>(::lseek(number_, 0, SEEK_END)), '\0');
    const ssize_t read = ::pread(number_, all.data(), all.size(), 0);
    all.resize(read > 0 ? static_cast<std::size_t>(read) : 0);
    return all;
  }

 private:
  int number_;
};

}  // namespace

void add_card_option(const Verb& verb, bool& wanted) {
  verb.flag("--card", wanted,
            "Also write card.png, 1200 x 630: the result in one picture for sharing (needs rsvg-convert)");
}

void check_card_program() {
  const char* const path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody changes it
  std::string_view folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    if (::access(fmt::format("{}/{}", folders.substr(0, end), program).c_str(), X_OK) == 0) {
      return;
    }
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  cannot("is not there");
}

std::string png_of(const std::string& svg) {
  const MemoryFile in;
  const MemoryFile out;
  in.write(svg);
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_adddup2(&files, in.number(), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, out.number(), STDOUT_FILENO);
  std::array<std::string, 4> words{program, "--format=png", "--width=1200", "--height=630"};
  std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, program, &files, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  if (error != 0) {
    cannot(fmt::format("could not be started ({})", std::strerror(error)));
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  std::string png = out.content();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !png.starts_with("\x89PNG")) {
    cannot("failed");
  }
  return png;
}

std::string note_on_letters(const flight::Flight& flight) {
  const bool needed = report::needs_another_font(flight.scenario) || report::needs_another_font(flight.vehicle);
  return needed
             ? "  note    the card's names have letters that DejaVu Sans lacks: where no other font has them they are "
               "empty boxes (the Debian package fonts-droid-fallback has Chinese, Japanese and Korean)\n"
             : "";
}

}  // namespace fantail::tool
