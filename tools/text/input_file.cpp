// SPDX-License-Identifier: MIT
#include "text/input_file.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/error.hpp"

namespace fantail::text {
namespace {

std::atomic<void (*)()> check_of_pipes = nullptr;
std::atomic<void (*)(const std::string&)> tell_of_pipes = nullptr;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why,
                         ErrorKind kind = ErrorKind::bad_data) {
  throw Error{kind, path.string() + ": " + why};
}

struct stat status_of(int file, const std::filesystem::path& path) {
  struct stat status{};
  if (::fstat(file, &status) != 0) {
    throw std::system_error{errno, std::generic_category(), path.string()};
  }
  return status;
}

/// Reads all of a file into what `room` gives: a place for so many bytes, with those that have come at its beginning.
template <typename Room>
std::size_t read_all(const std::filesystem::path& path, InputKind kind, std::size_t most, const Room& room) {
  InputFile file{path, kind};
  const std::size_t expected = file.size();  // 0: unknown
  std::size_t used = 0;
  std::size_t end = expected > 0 ? std::min(expected, most) + 1 : std::size_t{1} << 16U;
  // One byte too many is enough to know, and the size of a file says it without one.
  while (expected <= most && used <= most && (expected == 0 || used <= expected)) {
    end = used < end ? end : std::min(2 * end, most + 1);
    const std::size_t came = file.read(std::span{room(end) + used, end - used});
    used += came;
    if (came == 0) {
      break;
    }
  }
  if (expected > most || used > most) {
    const std::string remedy = kind == InputKind::data
                                   ? "the most that is read of one file; give the part that you need"
                                   : "which is too large for this kind of file; check the path";
    refuse(path, fmt::format("larger than {} MiB, {}", most >> 20U, remedy));
  }
  if (file.size() != expected || (expected != 0 && used != expected)) {
    refuse(path, "changed while it was read; wait until no program writes to it, or give a copy");
  }
  return used;
}

}  // namespace

void check_while_reading(void (*check)(), void (*tell)(const std::string& sentence)) {
  check_of_pipes = check;
  tell_of_pipes = tell;
}

// Without O_NONBLOCK a pipe that nobody writes to would hold the program here.
InputFile::InputFile(const std::filesystem::path& path, InputKind kind)
    : path_{path}, file_{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)} {
  if (file_ < 0) {
    if (errno == ENOENT || errno == ENOTDIR) {
      throw Error{ErrorKind::no_such_input, path.string() + ": no such file"};
    }
    throw std::system_error{errno, std::generic_category(), path.string()};
  }
  try {
    const auto mode = status_of(file_, path).st_mode;
    is_pipe_ = S_ISFIFO(mode);
    if (S_ISDIR(mode)) {
      refuse(path, "is a folder, not a file", ErrorKind::no_such_input);
    }
    if (is_pipe_ && kind == InputKind::document) {
      refuse(path, "is a pipe, which can be read only once; save its content to a file and give that",
             ErrorKind::no_such_input);
    }
    if (!is_pipe_ && !S_ISREG(mode)) {
      refuse(path, "is a device, not a file; copy the data you need into a file", ErrorKind::no_such_input);
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

InputFile::~InputFile() { ::close(file_); }

bool InputFile::has_come() {
  if (!is_pipe_) {
    return true;
  }
  if (void (*const check)() = check_of_pipes) {
    check();
  }
  constexpr int between_checks_ms = 100;
  constexpr int silent_looks_till_told = 50;
  pollfd waiting{.fd = file_, .events = POLLIN, .revents = 0};
  if (::poll(&waiting, 1, between_checks_ms) > 0) {
    silent_looks_ = silent_looks_till_told;
    return true;
  }
  silent_looks_ += 1;
  if (void (*const tell)(const std::string&) = tell_of_pipes;
      tell != nullptr && silent_looks_ == silent_looks_till_told) {
    tell(path_.string() + " is a pipe that has given no data for 5 s; Ctrl-C ends the wait");
  }
  return false;
}

std::size_t InputFile::read(std::span<char> to) {
  for (;;) {
    if (!has_come()) {
      continue;
    }
    const ssize_t came = ::read(file_, to.data(), to.size());
    if (came >= 0) {
      return static_cast<std::size_t>(came);
    }
    if (errno != EAGAIN && errno != EINTR) {
      throw std::system_error{errno, std::generic_category(), path_.string()};
    }
  }
}

std::size_t InputFile::size() const { return is_pipe_ ? 0 : static_cast<std::size_t>(status_of(file_, path_).st_size); }

std::string read_input(const std::filesystem::path& path, InputKind kind, std::size_t most) {
  std::string text;
  const std::size_t size = read_all(path, kind, most, [&text](std::size_t bytes) {
    text.resize(bytes);
    return text.data();
  });
  text.resize(size);
  return text;
}

std::optional<std::string> read_if_there(const std::filesystem::path& path, InputKind kind, std::size_t most) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) ? std::optional{read_input(path, kind, most)} : std::nullopt;
}

InputBytes read_input_bytes(const std::filesystem::path& path) {
  InputBytes content;
  std::size_t capacity = 0;
  content.size = read_all(path, InputKind::data, most_bytes(InputKind::data), [&](std::size_t bytes) {
    if (bytes > capacity) {
      auto larger = std::make_unique_for_overwrite<std::byte[]>(bytes);  // NOLINT(modernize-avoid-c-arrays)
      std::copy_n(content.bytes.get(), capacity, larger.get());
      content.bytes = std::move(larger);
      capacity = bytes;
    }
    return reinterpret_cast<char*>(content.bytes.get());  // NOLINT: bytes are what is read
  });
  return content;
}

}  // namespace fantail::text
