// SPDX-License-Identifier: MIT
#include <cerrno>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/output_folder.hpp"

namespace fantail::text {
namespace {

/// False when whoever had the lock before has removed its file since it was opened.
bool is_still_there(int fd, const std::filesystem::path& file) {
  struct stat held{};
  struct stat named{};
  return fstat(fd, &held) == 0 && stat(file.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
         held.st_dev == named.st_dev;
}

}  // namespace

bool FolderLock::take(const std::filesystem::path& folder, std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds between_tries{2};
  release();
  std::error_code ignored;
  const std::filesystem::path file = folder / ".fantail.writing";
  const auto give_up = std::chrono::steady_clock::now() + patience;
  do {
    const int fd = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (fd < 0) {
      // Whatever else forbids it forbids the results, too, which then say why.
      return errno != ENOENT || std::filesystem::is_directory(folder, ignored);
    }
    const int error = flock(fd, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if ((error == 0 && is_still_there(fd, file)) || (error != 0 && error != EWOULDBLOCK && error != EINTR)) {
      fd_ = fd;
      file_ = file;
      return true;
    }
    close(fd);
    std::this_thread::sleep_for(error == 0 ? std::chrono::milliseconds{0} : between_tries);
  } while (std::chrono::steady_clock::now() < give_up);
  throw OutputError{folder.string() + ": another program has been writing there for " +
                    std::to_string(std::chrono::duration_cast<std::chrono::seconds>(patience).count()) +
                    " s; nothing was written. Choose another folder, or try again when that program has ended"};
}

void FolderLock::release() noexcept {
  if (fd_ >= 0) {
    unlink(file_.c_str());
    flock(fd_, LOCK_UN);  // a child of another thread may have inherited it
    close(std::exchange(fd_, -1));
  }
}

}  // namespace fantail::text
